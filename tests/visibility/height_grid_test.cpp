#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "reference/reliefs.h"
#include "visibility/swept.h"

namespace scree {
namespace {

using test::heights_of;
using test::shape_of;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Numbers that tell columns from rows, on no plane: so what continues them is not by chance right.
double bent(int x, int y) { return 3 * x * x + 100.0 * y * y - x * y; }

// Oracles: one texel beyond the ends of a line, by what the edge says, looked up one at a time;
// nothing in common with runs of texels that are copied or turned round.
int wrapped(int i, int n) { return ((i % n) + n) % n; }
int mirrored(int i, int n)
{
    const int twice = wrapped(i, 2 * n);
    return twice < n ? twice : 2 * n - 1 - twice;
}

double along(Edge edge, int i, int n, double ground, const std::function<double(int)>& inside)
{
    if (edge == Edge::periodic)
        return inside(wrapped(i, n));
    if (edge == Edge::repeat)
        return inside(mirrored(i, n));
    if (i >= 0 && i < n)
        return inside(i);
    if (i < -1 || i > n)
        return kNan;
    if (edge == Edge::zero)
        return ground;
    if (n == 1)
        return inside(0);
    return i < 0 ? 2 * inside(0) - inside(1) : 2 * inside(n - 1) - inside(n - 2);
}

double expected(const HeightGrid::Shape& shape, int x, int y)
{
    const auto ground = static_cast<double>(shape.ground);
    // Where there is nothing along s there is nothing, whatever lies beyond along t.
    const bool nothing =
        std::isnan(along(shape.edge_s, x, shape.width, ground, [](int) { return 0.0; }));
    return nothing ? kNan : along(shape.edge_t, y, shape.height, ground, [&](int row) {
        return along(shape.edge_s, x, shape.width, ground,
                     [&](int column) { return bent(column, row); });
    });
}

void expect_window(const HeightGrid& grid, int x0, int y0, int columns, int rows)
{
    std::vector<float> heights(static_cast<size_t>(columns) * static_cast<size_t>(rows), -1);
    grid.read(0, x0, y0, columns, rows, heights.data());
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double want = expected(grid.shape(), x0 + column, y0 + row);
            const auto got = static_cast<double>(heights[test::index_of(column, row, columns)]);
            ASSERT_TRUE(std::isnan(want) ? std::isnan(got) : got == want)
                << "texel " << x0 + column << ", " << y0 + row << " of " << grid.shape().width
                << " x " << grid.shape().height << ": " << got << ", not " << want << "; edges "
                << static_cast<int>(grid.shape().edge_s) << ", "
                << static_cast<int>(grid.shape().edge_t);
        }
}

TEST(HeightGrid, WindowsReachBeyondTheMapAsItsEdgesSay)
{
    const Edge edges[] = {Edge::periodic, Edge::extend, Edge::repeat, Edge::zero};
    for (const Edge edge_s : edges)
        for (const Edge edge_t : edges)
            for (const auto& [width, height] : {std::pair(1, 1), {1, 5}, {7, 2}, {4, 3}}) {
                HeightGrid::Shape shape = shape_of(width, height, edge_s, edge_t);
                shape.ground = 17;
                const MemoryHeights grid = heights_of(shape, bent);
                expect_window(grid, 0, 0, width, height);
                expect_window(grid, -3, -2, width + 6, height + 4);
                expect_window(grid, -23, 19, 40, 3);   // several images on one side
                expect_window(grid, 31, -27, 5, 60);   // beyond along s, all of t
                expect_window(grid, width, 0, 1, 1);   // just what is made up
                expect_window(grid, -1, height, 1, 1); // a corner of it
            }
}

TEST(HeightGrid, WhatIsExtendedFromAHoleIsAHole)
{
    const MemoryHeights grid = heights_of(shape_of(3, 1, Edge::extend, Edge::zero),
                                          [](int x, int) { return x == 0 ? kNan : x; });
    float row[5];
    grid.read(0, -1, 0, 5, 1, row);
    EXPECT_TRUE(std::isnan(row[0]) && std::isnan(row[1]));
    EXPECT_EQ(row[4], 3.0F);
    grid.read(0, -1, 1, 5, 1, row);
    for (const float h : row) // ground has no holes
        EXPECT_EQ(h, 0.0F);
}

TEST(HeightGrid, CoarserLevelsEndAtTheMap)
{
    const MemoryHeights grid =
        heights_of(shape_of(8, 8, Edge::extend, Edge::periodic), [](int, int) { return 1.0; });
    float row[6];
    grid.read(1, -1, -3, 6, 1, row);
    EXPECT_TRUE(std::isnan(row[0]) && std::isnan(row[5]));
    for (int x = 1; x < 5; ++x)
        EXPECT_EQ(row[x], 1.0F);
}

TEST(HeightGrid, LevelsHalveDownToOneTexel)
{
    const MemoryHeights grid = heights_of(shape_of(13, 5), [](int, int) { return 0.0; });
    ASSERT_EQ(grid.levels(), 4);
    const int widths[] = {13, 6, 3, 1}, heights[] = {5, 2, 1, 1};
    for (int level = 0; level < 4; ++level) {
        EXPECT_EQ(grid.width(level), widths[level]) << level;
        EXPECT_EQ(grid.height(level), heights[level]) << level;
    }
}

} // namespace
} // namespace scree
