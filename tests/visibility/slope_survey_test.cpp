// How steep a height map is, and where its slopes lie.

#include "visibility/slope_survey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "visibility/memory_heights.h"

namespace scree::test {
namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

MemoryHeights heights_of(double (*height)(double x, double y), double texel_width = 1)
{
    HeightGrid::Shape shape;
    shape.width = 96;
    shape.height = 80;
    shape.texel_width = texel_width;
    shape.edge_s = shape.edge_t = Edge::extend;
    std::vector<float> heights;
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            heights.push_back(static_cast<float>(height(texel_width * x, y)));
    return {shape, heights};
}

// A plane, also beyond its edges, and through cells without data.
TEST(SlopeSurvey, SteepnessOfAPlaneIsItsSlope)
{
    const auto plane = [](double x, double y) { return 0.3 * x + 0.4 * y; };
    EXPECT_NEAR(survey_slopes(heights_of(plane)).steepness, 0.5, 1e-5);
    EXPECT_NEAR(survey_slopes(heights_of(plane, 0.25)).steepness, 0.5, 1e-5) << "oblong texels";
    const auto holes = [](double x, double y) {
        return static_cast<int>(x + 3 * y) % 17 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                     : 0.3 * x + 0.4 * y;
    };
    EXPECT_NEAR(survey_slopes(heights_of(holes)).steepness, 0.5, 1e-5);
}

// Grooves with walls of slope 0.5, a quarter of the map; the rest is flat.
TEST(SlopeSurvey, SteepnessOfGroovesIsThatOfTheirWalls)
{
    const auto grooves = [](double x, double) {
        return 0.5 * std::min(std::abs(std::fmod(x, 16) - 8), 2.0);
    };
    EXPECT_NEAR(survey_slopes(heights_of(grooves)).steepness, 0.5, 1e-5);
}

// Slopes are sums of k_i cos(phase_i): E[r^2] = sum |k_i|^2 / 2, and E[r^4] = sum 3 |k_i|^4 / 8 +
// sum over i != j of (|k_i|^2 |k_j|^2 + 2 (k_i . k_j)^2) / 4. Many waves are nearly normal.
TEST(SlopeSurvey, SteepnessOfWavesFollowsFromTheirMoments)
{
    constexpr int kSize = 512;
    constexpr double kTurn = 2 * 3.14159265358979323846;
    const int waves[][2] = {{1, 3}, {-2, 7}, {5, 11}, {13, -4}, {-9, 2}, {3, -12}};
    HeightGrid::Shape shape;
    shape.width = shape.height = kSize;
    std::vector<float> heights;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            double height = 0;
            for (const auto& [u, v] : waves)
                height += std::sin(kTurn * (u * x + v * y) / kSize + u * u);
            heights.push_back(static_cast<float>(height));
        }
    double squares = 0, fourths = 0;
    for (const auto& a : waves) {
        const double aa = a[0] * a[0] + a[1] * a[1];
        squares += aa / 2;
        fourths += 3 * aa * aa / 8;
        for (const auto& b : waves)
            if (&a != &b) {
                const double bb = b[0] * b[0] + b[1] * b[1], ab = a[0] * b[0] + a[1] * b[1];
                fourths += (aa * bb + 2 * ab * ab) / 4;
            }
    }
    const double expected = kTurn / kSize * std::sqrt(fourths / squares);
    EXPECT_NEAR(survey_slopes(MemoryHeights(shape, heights)).steepness, expected, 0.01 * expected);
}

// Of more rows than it looks at it takes some.
TEST(SlopeSurvey, OfManyRowsIsThatOfAll)
{
    HeightGrid::Shape shape;
    shape.width = 8;
    shape.height = 3000;
    shape.texel_height = 0.5;
    std::vector<float> heights;
    for (int i = 0; i < 8 * 3000; ++i)
        heights.push_back(static_cast<float>(std::sin(0.01 * (i / 8)))); // slope 0.02 cos
    shape.edge_t = Edge::extend;
    // E[cos^4] / E[cos^2] = 3 / 4
    EXPECT_NEAR(survey_slopes(MemoryHeights(shape, heights)).steepness, 0.02 * std::sqrt(0.75),
                2e-4);
}

TEST(SlopeSurvey, WithoutDataIsFlat)
{
    const auto nothing = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
    EXPECT_EQ(survey_slopes(heights_of(nothing)).steepness, 0);
    EXPECT_EQ(survey_slopes(heights_of(nothing)).axis_deg, 0);
}

double axis_of(const HeightGrid& heights) { return survey_slopes(heights).axis_deg; }

TEST(SlopeSurvey, AxisOfGroovesIsAcrossThem)
{
    const auto grooves = [](double x, double y) {
        return 0.3 * std::sin(0.4 * (x * std::cos(31 * kRadian) + y * std::sin(31 * kRadian)));
    };
    EXPECT_NEAR(axis_of(heights_of(grooves)), 31, 0.5);
    EXPECT_NEAR(axis_of(heights_of(grooves, 0.5)), 31, 0.5) << "oblong texels";
}

TEST(SlopeSurvey, AxisOfBricksLiesAlongTheMap)
{
    const auto bricks = [](double x, double y) {
        return std::fmod(x, 12) < 2 || std::fmod(y, 8) < 2 ? 0.0 : 1.0;
    };
    // Where edges meet neighbours' differences lie in between, alike on both sides.
    EXPECT_NEAR(axis_of(heights_of(bricks)), 0, 1);
}

TEST(SlopeSurvey, AxisOfWhatHasNoneIsThatOfTheMap)
{
    const auto hill = [](double x, double y) {
        return std::exp(-((x - 48) * (x - 48) + (y - 40) * (y - 40)) / 200);
    };
    EXPECT_EQ(axis_of(heights_of(hill)), 0);
    EXPECT_EQ(axis_of(heights_of([](double, double) { return 2.0; })), 0);
    std::mt19937 random(1);
    std::normal_distribution<float> number;
    HeightGrid::Shape shape;
    shape.width = shape.height = 64;
    for (int i = 0; i < 5; ++i) {
        std::vector<float> noise(64 * 64);
        for (float& height : noise)
            height = number(random);
        EXPECT_EQ(axis_of(MemoryHeights(shape, noise)), 0);
    }
}

} // namespace
} // namespace scree::test
