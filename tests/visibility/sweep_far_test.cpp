// What coarse levels, and a few lines a texel, leave out.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "visibility/swept.h"

namespace scree {
namespace {

using test::heights_of;
using test::kPi;
using test::mean_of;
using test::radians;
using test::shape_of;
using test::swept;
using test::whole_block;

double at(const std::vector<float>& values, int i)
{
    return static_cast<double>(values[static_cast<size_t>(i)]);
}

/// A wall whose shadow is 5700 texels long, as seen by blocks that begin far behind it.
TEST(Sweep, SeesShadowsFromAfar)
{
    constexpr int kSize = 8192, kWall = 1024; // texels of its top: whole ones on all levels
    constexpr int kBlock = 251;               // so that they begin anywhere in texels of levels
    const double height = 100, theta = 89;
    const double shadow = height * std::tan(radians(theta));
    for (const double azimuth : {0.0, 180.0}) {
        const auto place = [&](int step) { return azimuth == 180 ? step : kSize - 1 - step; };
        const MemoryHeights grid = heights_of(shape_of(kSize, 3, Edge::extend), [&](int x, int) {
            return place(x) < kWall ? height : 0;
        });
        const auto bright = [&](int step) {
            return std::clamp(step + 0.5 - (kWall - 1 + shadow), 0.0, 1.0);
        };
        const auto whole = swept(grid, whole_block(grid), azimuth, {theta});
        for (int step = kWall + 1; step < kSize; ++step) // 6000 drops are rounded to 2^-11
            ASSERT_NEAR(at(whole[0], place(step)), bright(step), 5e-4) << step;
        for (const int near : {16, 64, 256}) {
            SweepOptions options;
            options.near_steps = near;
            double gained = 0;
            for (int step = 2048; step + kBlock <= kSize; step += kBlock) {
                const TexelBlock block{std::min(place(step), place(step + kBlock - 1)), 1, kBlock,
                                       1};
                const auto part = swept(grid, block, azimuth, {theta}, options);
                for (int i = 0; i < kBlock; ++i)
                    gained += at(part[0], place(step + i) - block.x0) - bright(step + i);
            }
            // The wall's back is the centre of a texel of the level that it is seen on: half a
            // texel from its end, but for the half of one of level 0.
            int texel = 1, reach = near;
            for (; reach < shadow - kBlock; reach += near * texel)
                texel *= 2;
            EXPECT_NEAR(gained, 0.5 * texel - 0.5, 0.01) << near; // 20 roundings as above
        }
    }
}

/// The shadow of a tower, 64 rows wide, lies behind it: in the same rows from afar.
TEST(Sweep, SeesShadowsFromAfarWhereTheyAre)
{
    constexpr int kSize = 4096, kTower = 1024, kFirst = 64, kRows = 256;
    const MemoryHeights grid = heights_of(shape_of(kSize, kRows, Edge::extend), [](int x, int y) {
        return x < kTower && y >= kFirst && y < 2 * kFirst ? 100 : 0;
    });
    SweepOptions options;
    options.near_steps = 64; // 32 rows a texel of the level that sees the tower
    const auto seen = swept(grid, {3500, 0, 1, kRows}, 180, {89}, options)[0];
    double dark = 0, moment = 0;
    for (int y = 0; y < kRows; ++y) {
        dark += 1 - at(seen, y);
        moment += (1 - at(seen, y)) * y;
    }
    // Its edges are ramps two texels of the level wide: brighter or darker by as much on both
    // sides. Two lines a texel tell their places to half a row.
    EXPECT_NEAR(moment / dark, 1.5 * kFirst - 0.5, 0.5);
    EXPECT_NEAR(dark, kFirst, 32);
}

/// A wall of four texels is seen wherever it stands, also where one level takes over from the next.
TEST(Sweep, LosesNothingBetweenLevels)
{
    constexpr int kSize = 300;
    SweepOptions options;
    options.near_steps = 8;
    for (const double azimuth : {0.0, 180.0})
        for (int wall = 100; wall < 196; ++wall) {
            const bool forwards = azimuth == 180;
            const MemoryHeights grid =
                heights_of(shape_of(kSize, 4, Edge::extend), [&](int x, int) {
                    const int step = forwards ? x : kSize - 1 - x;
                    return step >= wall && step < wall + 4 ? 100 : 0;
                });
            const int x0 = forwards ? 200 : kSize - 1 - 215;
            const auto seen = swept(grid, {x0, 0, 16, 4}, azimuth, {85}, options);
            for (const float v : seen[0])
                ASSERT_EQ(v, 0) << "azimuth " << azimuth << " wall at " << wall;
        }
}

/// What a start on coarse levels misses of a rough surface: the figures of SweepOptions.
TEST(Sweep, LosesLittleByCoarseBeginnings)
{
    // Hills upon hills, half as high where they are half as wide.
    const MemoryHeights grid = heights_of(shape_of(512, 512), [](int x, int y) {
        double h = 0;
        for (int wave = 1; wave <= 64; wave *= 2)
            h += 16.0 / wave *
                 (std::sin(2 * kPi * wave * (x + 2 * y) / 512.0 + wave) +
                  std::cos(2 * kPi * wave * (3 * x - y) / 512.0 + 2 * wave));
        return h;
    });
    EXPECT_NEAR(grid.shape().highest - grid.shape().lowest, 90, 1);
    SweepOptions exact;
    exact.near_steps = 1 << 20;
    const TexelBlock block{128, 128, 256, 256};
    const std::vector<double> thetas = {80, 85, 87}, bounds = {0.004, 0.015, 0.025};
    for (const double azimuth : {0.0, 67.0, 135.0, 200.0}) {
        const auto want = swept(grid, block, azimuth, thetas, exact);
        const auto got = swept(grid, block, azimuth, thetas);
        for (size_t k = 0; k < thetas.size(); ++k) {
            double squares = 0;
            for (int cell = 0; cell < 256; ++cell) { // of 16x16 texels
                double difference = 0;
                for (int y = 0; y < 16; ++y)
                    for (int x = 0; x < 16; ++x) {
                        const int i = (cell / 16 * 16 + y) * 256 + cell % 16 * 16 + x;
                        difference += (at(got[k], i) - at(want[k], i)) / 256;
                    }
                squares += difference * difference / 256;
            }
            EXPECT_LT(std::sqrt(squares), bounds[k]) << azimuth << " " << thetas[k];
            EXPECT_NEAR(mean_of(got[k]), mean_of(want[k]), 0.003) << azimuth << " " << thetas[k];
        }
    }
}

/// What small areas are off by falls with the lines a texel has.
TEST(Sweep, MoreLinesSeeMore)
{
    const MemoryHeights grid = test::rough_heights(shape_of(64, 64), 1.5, 12);
    const auto off = [&](int lines) { // over 4x4 texels, root mean square
        SweepOptions some, many;
        some.lines_per_texel = lines;
        many.lines_per_texel = 24;
        double squares = 0;
        for (const double azimuth : {20.0, 160.0, 275.0}) {
            const auto got = swept(grid, whole_block(grid), azimuth, {70.0}, some)[0];
            const auto want = swept(grid, whole_block(grid), azimuth, {70.0}, many)[0];
            for (int cell = 0; cell < 256; ++cell) {
                double difference = 0;
                for (int i = 0; i < 16; ++i) {
                    const int texel = (cell / 16 * 4 + i / 4) * 64 + cell % 16 * 4 + i % 4;
                    difference += (at(got, texel) - at(want, texel)) / 16;
                }
                squares += difference * difference / (3 * 256);
            }
        }
        return std::sqrt(squares);
    };
    const double one = off(1), two = off(2), four = off(4);
    EXPECT_LT(two, one / 2);
    EXPECT_LT(four, two / 2);
}

} // namespace
} // namespace scree
