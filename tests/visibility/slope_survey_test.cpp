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
TEST(SlopeSurvey, RmsOfAPlaneIsItsSlope)
{
    const auto plane = [](double x, double y) { return 0.3 * x + 0.4 * y; };
    EXPECT_NEAR(survey_slopes(heights_of(plane)).rms, 0.5, 1e-5);
    EXPECT_NEAR(survey_slopes(heights_of(plane, 0.25)).rms, 0.5, 1e-5) << "oblong texels";
    const auto holes = [](double x, double y) {
        return static_cast<int>(x + 3 * y) % 17 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                     : 0.3 * x + 0.4 * y;
    };
    EXPECT_NEAR(survey_slopes(heights_of(holes)).rms, 0.5, 1e-5);
}

// White noise of variance 1, slope a + (b - a) y of a cell between two rows: E[s^2] = 2 (2 / 3) of
// the variance, that of the same differences without interpolation would be 2.
TEST(SlopeSurvey, RmsIsThatOfTheBilinearSurface)
{
    HeightGrid::Shape shape;
    shape.width = shape.height = 256;
    std::mt19937 random(3);
    std::normal_distribution<float> number;
    std::vector<float> noise(256 * 256);
    for (float& height : noise)
        height = number(random);
    EXPECT_NEAR(survey_slopes(MemoryHeights(shape, noise)).rms, std::sqrt(2 * 4.0 / 3), 0.02);
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
    EXPECT_NEAR(survey_slopes(MemoryHeights(shape, heights)).rms, 0.02 / std::sqrt(2.0), 2e-4);
}

TEST(SlopeSurvey, WithoutDataIsFlat)
{
    const auto nothing = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
    EXPECT_EQ(survey_slopes(heights_of(nothing)).rms, 0);
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
