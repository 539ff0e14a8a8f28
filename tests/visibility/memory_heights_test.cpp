#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "visibility/swept.h"

namespace scree {
namespace {

using test::heights_of;
using test::shape_of;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Oracle: halfway between the mean over the part of the map that a texel covers, as overlaps of
// intervals, and the highest there; of those with data only. Levels are made one from the next, so
// is this.
std::vector<double> halved(const std::vector<double>& fine, int width, int height, int columns,
                           int rows)
{
    const auto overlap = [](int i, int j, int n, int m) { // of texels i of n, j of m, in 1 / (n m)
        return std::max(0, std::min((i + 1) * m, (j + 1) * n) - std::max(i * m, j * n));
    };
    std::vector<double> coarse;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            double sum = 0, weight = 0, highest = -1e30;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const double h = fine[test::index_of(x, y, width)];
                    const double w =
                        overlap(x, column, width, columns) * overlap(y, row, height, rows);
                    sum += w > 0 && !std::isnan(h) ? w * h : 0;
                    weight += std::isnan(h) ? 0 : w;
                    highest = w > 0 && !std::isnan(h) ? std::max(highest, h) : highest;
                }
            coarse.push_back(weight > 0 ? (sum / weight + highest) / 2 : kNan);
        }
    return coarse;
}

TEST(MemoryHeights, LevelsAreHalfwayFromTheMeanToTheHighest)
{
    for (const auto& [width, height] : {std::pair(16, 8), {13, 9}, {1, 7}, {15, 1}, {31, 17}})
        for (const double holes : {0.0, 0.4}) {
            test::Uniform uniform(5);
            std::vector<double> level;
            const MemoryHeights grid = heights_of(shape_of(width, height), [&](int, int) {
                const auto h = static_cast<double>(static_cast<float>(uniform() - 0.5));
                level.push_back(uniform() < holes ? kNan : h);
                return level.back();
            });
            EXPECT_EQ(grid.shape().holes, holes > 0);
            for (int l = 1; l < grid.levels(); ++l) {
                const int columns = grid.width(l), rows = grid.height(l);
                level = halved(level, grid.width(l - 1), grid.height(l - 1), columns, rows);
                std::vector<float> got(level.size());
                grid.read(l, 0, 0, columns, rows, got.data());
                for (size_t i = 0; i < level.size(); ++i) {
                    if (std::isnan(level[i]))
                        EXPECT_TRUE(std::isnan(got[i])) << l << ": " << i;
                    else // one rounding to float a level
                        EXPECT_NEAR(static_cast<double>(got[i]), level[i], l * 3e-8) << l;
                }
            }
        }
}

TEST(MemoryHeights, FindTheRangeOfTheDataThereIs)
{
    const MemoryHeights some =
        heights_of(shape_of(3, 2), [](int x, int y) { return x == 1 ? kNan : 4.0 * x - 9 * y; });
    EXPECT_EQ(some.shape().lowest, -9);
    EXPECT_EQ(some.shape().highest, 8);
    EXPECT_TRUE(some.shape().holes);
    const MemoryHeights none = heights_of(shape_of(2, 2), [](int, int) { return kNan; });
    EXPECT_EQ(none.shape().lowest, 0);
    EXPECT_EQ(none.shape().highest, 0);
}

} // namespace
} // namespace scree
