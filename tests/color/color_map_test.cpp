// Color maps: straight lines, jumps, stretching.

#include "color/color_map.h"

#include <gtest/gtest.h>

#include <vector>

#include "color/maps.h"

namespace scree::test {
namespace {

constexpr Rgb kBlack = {0, 0, 0}, kRed = {1, 0, 0}, kGreen = {0, 1, 0}, kWhite = {1, 1, 1};

TEST(ColorMap, IsStraightBetweenKnotsAndConstantBeyond)
{
    const ColorMap map({{-1, kBlack}, {1, kRed}, {3, kWhite}});
    EXPECT_EQ(map.at(-1e300), kBlack);
    EXPECT_EQ(map.at(-1), kBlack);
    EXPECT_EQ(map.at(-0.5), (Rgb{0.25, 0, 0}));
    EXPECT_EQ(map.at(1), kRed);
    EXPECT_EQ(map.at(1.5), (Rgb{1, 0.25, 0.25}));
    EXPECT_EQ(map.at(3), kWhite);
    EXPECT_EQ(map.at(1e300), kWhite);
    EXPECT_EQ(map.first(), -1);
    EXPECT_EQ(map.last(), 3);
}

TEST(ColorMap, AJumpHasTheColorOfItsRight)
{
    const ColorMap map({{0, kBlack}, {0, kRed}, {2, kGreen}, {2, kWhite}});
    EXPECT_EQ(map.at(-1e-300), kBlack); // outside, beyond a jump at the end
    EXPECT_EQ(map.at(0), kRed);
    EXPECT_EQ(map.at(1), (Rgb{0.5, 0.5, 0}));
    EXPECT_EQ(map.at(2), kGreen); // the ends belong to the map
    EXPECT_EQ(map.at(2.0000001), kWhite);
    EXPECT_LT(largest_difference(map.at(2 - 1e-12), kGreen), 1e-11);
}

TEST(ColorMap, OfManyKnotsAtOnePlaceTheOutermostCount)
{
    const ColorMap map({{0, kBlack}, {1, kRed}, {1, kGreen}, {1, kWhite}, {2, kWhite}});
    EXPECT_EQ(map.knots().size(), 4U);
    EXPECT_EQ(map.at(1), kWhite);
    EXPECT_EQ(map.at(0.5), (Rgb{0.5, 0, 0}));
    EXPECT_EQ(ColorMap({{1, kRed}, {1, kRed}, {2, kWhite}}).knots().size(), 2U);
}

TEST(ColorMap, OneKnotIsOneColor)
{
    const ColorMap map(std::vector<Knot>{{5, kRed}});
    for (const double x : {-1e9, 5.0, 1e9})
        EXPECT_EQ(map.at(x), kRed);
}

TEST(ColorMap, IsWhatItsDefinitionSays)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const ColorMap map = random_map(seed);
        for (double x = -0.1; x < 1.1; x += 1e-3)
            EXPECT_LT(largest_difference(map.at(x), color_by_definition(map.knots(), x)), 1e-14)
                << "seed " << seed << " x " << x;
    }
}

TEST(ColorMap, StretchingMovesEveryPlaceInProportion)
{
    const ColorMap map = random_map(3), wide = map.stretched(-100, 300);
    EXPECT_EQ(wide.first(), -100);
    EXPECT_EQ(wide.last(), 300);
    for (double x = 0.0005; x < 1; x += 1e-3)
        EXPECT_LT(largest_difference(wide.at(-100 + 400 * x), map.at(x)), 1e-10) << x;
}

TEST(ColorMap, StretchedToNoWidthItIsItsMiddle)
{
    const ColorMap flat = ramp_map(0, 1).stretched(7, 7);
    EXPECT_EQ(flat.at(7), (Rgb{0.5, 0.25, -1}));
    EXPECT_EQ(flat.at(-100), flat.at(100));
}

TEST(ColorMap, AHingeStaysAndEachHalfIsStretchedByItself)
{
    const ColorMap map({{-1, kBlack}, {0, kRed}, {0, kGreen}, {1, kWhite}});
    const ColorMap land = map.stretched(-10, 1000, {0, 0});
    EXPECT_EQ(land.at(-10), kBlack);
    EXPECT_EQ(land.at(-5), (Rgb{0.5, 0, 0}));
    EXPECT_EQ(land.at(0), kGreen);
    EXPECT_LT(largest_difference(land.at(-1e-12), kRed), 1e-12);
    EXPECT_EQ(land.at(500), (Rgb{0.5, 1, 0.5}));
    EXPECT_EQ(land.at(1000), kWhite);
    // the hinge between knots: a knot of its own appears
    const ColorMap bent = ramp_map(-1, 1).stretched(0, 10, {0, 8});
    EXPECT_EQ(bent.at(8), (Rgb{0.5, 0.25, -1}));
    EXPECT_EQ(bent.at(4), (Rgb{0.25, 0.125, -0.5}));
    EXPECT_EQ(bent.at(9), (Rgb{0.75, 0.375, -1.5}));
}

TEST(ColorMap, BeyondAHingeOutsideTheRangeTheMapIsLeftOut)
{
    const ColorMap map({{-1, kBlack}, {0, kRed}, {0, kGreen}, {1, kWhite}});
    const ColorMap land = map.stretched(5, 10, {0, 0}); // all above the sea
    EXPECT_EQ(land.at(-3), kGreen);
    EXPECT_EQ(land.at(5), (Rgb{0.5, 1, 0.5}));
    EXPECT_EQ(land.at(10), kWhite);
    const ColorMap sea = map.stretched(-10, -5, {0, 0});
    EXPECT_EQ(sea.at(-10), kBlack);
    EXPECT_EQ(sea.at(-5), (Rgb{0.5, 0, 0}));
    EXPECT_EQ(sea.at(3), kRed);
    const ColorMap shore = map.stretched(0, 0, {0, 0});
    EXPECT_EQ(shore.at(0), kGreen);
    EXPECT_EQ(shore.at(1), kGreen);
}

TEST(ColorMap, SpanIsOfTheWorstChannelWithinTheRange)
{
    const ColorMap map = hat_map(0, 1, 2); // up to (1, 0.5, -2)
    EXPECT_EQ(color_span(map, -5, 5), 2);
    EXPECT_EQ(color_span(map, 0, 0.25), 0.5);
    EXPECT_EQ(color_span(map, 0.5, 1.5), 1); // the top is inside
    EXPECT_EQ(color_span(map, 3, 4), 0);
}

} // namespace
} // namespace scree::test
