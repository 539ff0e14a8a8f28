#include "chart/height_regression.h"

#include <gtest/gtest.h>

#include <limits>

namespace scree {
namespace {

reference::Relief relief_of(const std::vector<double>& heights, const std::vector<Rgb>& colors)
{
    reference::Relief relief;
    relief.width = static_cast<int>(heights.size());
    relief.height = 1;
    relief.heights = heights;
    relief.colors = colors;
    return relief;
}

TEST(ColorByHeight, OfTwoHeightsIsALineBetweenTheirMeanColors)
{
    const auto relief = relief_of({2, 4, 4, 2}, {{1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}});
    const ColorMap map = color_by_height(relief, 3, 0.5); // hn is -2 and 2
    EXPECT_EQ(map.first(), -2);
    EXPECT_EQ(map.last(), 2);
    EXPECT_EQ(map.at(-2), (Rgb{0.5, 0.5, 0}));
    EXPECT_EQ(map.at(2), (Rgb{0, 0, 0.5}));
    EXPECT_EQ(map.at(0), (Rgb{0.25, 0.25, 0.25}));
}

// A color that is a straight line in height comes back within half a bin of its rise.
TEST(ColorByHeight, FollowsAFunctionOfHeight)
{
    std::vector<double> heights;
    std::vector<Rgb> colors;
    for (int i = 0; i < 4096; ++i) {
        heights.push_back((i * 1237 % 4096) / 4095.0);
        colors.push_back({heights.back(), 1 - heights.back(), 0.5});
    }
    const ColorMap map = color_by_height(relief_of(heights, colors), 0, 1);
    for (int i = 0; i <= 100; ++i) {
        const double h = i / 100.0;
        EXPECT_NEAR(map.at(h)[0], h, 0.5 / 256);
        EXPECT_NEAR(map.at(h)[1], 1 - h, 0.5 / 256);
        EXPECT_NEAR(map.at(h)[2], 0.5, 1e-12);
    }
}

TEST(ColorByHeight, CountsTexelsByTheirWeight)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    auto relief = relief_of({1, 1, nan, 9}, {{1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {5, 5, 5}});
    relief.weights = {3, 1, 1, 0};
    const ColorMap map = color_by_height(relief, 1, 1);
    EXPECT_EQ(map.first(), 0);
    EXPECT_EQ(map.last(), 0);
    EXPECT_EQ(map.at(0), (Rgb{0.75, 0.25, 0}));
}

// Two equal heaps of height -1 and 1 are no normal law, but with mean 0 and deviation s the table
// still is the straight map's: E[map] by symmetry its middle, as far as it reaches.
TEST(ColorByHeight, IsAveragedOverNormalLaws)
{
    const auto relief = relief_of({-1, 1}, {{0, 0, 0}, {1, 1, 1}});
    const MapTable table = filtered_by_height(color_by_height(relief, 0, 1));
    EXPECT_EQ(table.low, -1);
    EXPECT_EQ(table.high, 1);
    EXPECT_EQ(table.widest, 1);
    for (const double deviation : {0.0, 0.3, 1.0}) {
        EXPECT_NEAR(lookup(table, 0, deviation)[0], 0.5, 0.01) << deviation;
        EXPECT_GT(lookup(table, 0.8, deviation)[0], 0.6) << deviation;
    }
    EXPECT_NEAR(lookup(table, 0.5, 0)[1], 0.75, 0.01);
}

} // namespace
} // namespace scree
