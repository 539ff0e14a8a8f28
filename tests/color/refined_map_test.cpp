// Knots for curves: as many as a tolerance needs.

#include "color/refined_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "color/maps.h"

namespace scree::test {
namespace {

// IEC 61966-2-1.
double linear_of_srgb(double v)
{
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Rgb linear_of_srgb_color(const Rgb& c)
{
    return {linear_of_srgb(c[0]), linear_of_srgb(c[1]), linear_of_srgb(c[2])};
}

Rgb unchanged(const Rgb& c) { return c; }

double worst(const ColorMap& encoded, const ColorMap& linear)
{
    double error = 0;
    for (int i = 0; i <= 50021; ++i) {
        const double x = -0.1 + 1.2 * i / 50021;
        error =
            std::max(error, largest_difference(linear.at(x), linear_of_srgb_color(encoded.at(x))));
    }
    return error;
}

TEST(RefinedMap, FollowsTheConversionWithinTheTolerance)
{
    const ColorMap encoded(
        {{0, {0, 1, 0.5}}, {0.3, {1, 0, 0.5}}, {0.3, {0, 0, 0}}, {1, {1, 1, 1}}});
    for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
        const ColorMap linear = refined(encoded, linear_of_srgb_color, tolerance);
        EXPECT_LT(worst(encoded, linear), tolerance);
        // A parabola of curvature f'' needs sqrt(f'' / 8 tolerance) pieces; f'' is below 3.2.
        EXPECT_LT(linear.knots().size(), 10 + 3 * 2 * std::sqrt(3.2 / 8 / tolerance));
    }
    EXPECT_GT(worst(encoded, encoded), 0.1); // the conversion is not nothing
}

TEST(RefinedMap, TheToleranceIsAShareOfTheLargestColor)
{
    const ColorMap encoded = ramp_map(0, 1); // up to 1, then -2
    const auto cube = [](double scale) {
        return [scale](const Rgb& c) {
            return Rgb{scale * c[0] * c[0] * c[0], scale * c[1] * c[1] * c[1], 0};
        };
    };
    EXPECT_EQ(refined(encoded, cube(1)).knots().size(),
              refined(encoded, cube(1000)).knots().size());
}

// A wave with its zeros at the quarters, where a bisection looks first.
TEST(RefinedMap, SeesWhatIsStraightAtTheQuarters)
{
    const auto wave = [](double v) { return v + 0.1 * std::sin(4 * std::acos(-1.0) * v); };
    const ColorMap map = refined(ColorMap({{0, {}}, {1, {1, 1, 1}}}), [&](const Rgb& c) {
        return Rgb{wave(c[0]), wave(c[1]), wave(c[2])};
    });
    for (double x = 0; x < 1; x += 1e-3)
        EXPECT_NEAR(map.at(x)[0], wave(x), 1e-5) << x;
}

TEST(RefinedMap, JumpsStayWhereTheyAre)
{
    const ColorMap encoded({{0, {0, 0, 0}}, {0, {.5, .5, .5}}, {1, {1, 1, 1}}, {1, {.2, .2, .2}}});
    const ColorMap linear = refined(encoded, linear_of_srgb_color);
    EXPECT_EQ(linear.at(-1), (Rgb{0, 0, 0}));
    EXPECT_EQ(linear.at(0), linear_of_srgb_color({.5, .5, .5}));
    EXPECT_EQ(linear.at(1), (Rgb{1, 1, 1}));
    EXPECT_EQ(linear.at(1.001), linear_of_srgb_color({.2, .2, .2}));
}

TEST(RefinedMap, StraightLinesNeedNoKnots)
{
    std::vector<Knot> knots;
    for (int i = 0; i <= 1000; ++i)
        knots.push_back({i / 1000.0, {i / 1000.0, 1 - i / 500.0, 3}});
    EXPECT_EQ(refined(ColorMap(knots), unchanged).knots().size(), 2U);
    EXPECT_EQ(without_collinear_knots(ColorMap(knots), 1e-12).knots().size(), 2U);
    knots[500].color[2] = 3.5;
    EXPECT_EQ(refined(ColorMap(knots), unchanged).knots().size(), 5U); // one peak
}

TEST(RefinedMap, WithoutCollinearKnotsNothingMovesByMoreThanTheTolerance)
{
    std::vector<Knot> knots;
    for (int i = 0; i <= 1000; ++i) // a circle's arc: no three knots on a line
        knots.push_back({i / 1000.0, {std::sqrt(1 - i * i / 1e6), 0, i < 300 ? 0.0 : 1.0}});
    const ColorMap map(knots);
    for (const double tolerance : {0.0, 1e-4, 1e-2}) {
        const ColorMap thin = without_collinear_knots(map, tolerance);
        for (double x = 0; x < 1; x += 1e-4)
            ASSERT_LE(largest_difference(thin.at(x), map.at(x)), tolerance + 1e-13) << x;
        EXPECT_EQ(thin.first(), 0);
        EXPECT_EQ(thin.last(), 1);
        EXPECT_LT(thin.knots().size(), tolerance == 0 ? 1003U : tolerance < 1e-3 ? 100U : 15U);
    }
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const ColorMap jumps = random_map(seed), thin = without_collinear_knots(jumps, 1e-3);
        for (double x = -0.1; x < 1.1; x += 1e-3)
            ASSERT_LE(largest_difference(thin.at(x), jumps.at(x)), 1e-3 + 1e-13) << seed;
    }
}

TEST(RefinedMap, OneColorStaysOneKnot)
{
    const ColorMap map(std::vector<Knot>{{2, {0.5, 0.5, 0.5}}});
    const ColorMap linear = refined(map, linear_of_srgb_color);
    EXPECT_EQ(linear.knots().size(), 1U);
    EXPECT_EQ(linear.at(0), linear_of_srgb_color({0.5, 0.5, 0.5}));
}

TEST(RefinedMap, BlackAllOverNeedsNoKnots)
{
    const auto black = [](const Rgb&) { return Rgb{}; }; // any share of the largest color is 0
    EXPECT_EQ(refined(ramp_map(0, 1), black).knots().size(), 2U);
}

} // namespace
} // namespace scree::test
