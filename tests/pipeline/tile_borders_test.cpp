#include "pipeline/tile_borders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace scree::test {
namespace {

using Height = std::function<double(double, double)>; ///< of u right and v up

/// A tile of heights that are a function over the whole texture plane.
BorderedMap tile_of(const UdimTile& tile, int width, int height, const Height& h)
{
    BorderedMap map{tile, width, height, {}};
    const auto at = [&](int x, int y) {
        return h(tile.u + (x + 0.5) / width, tile.v + 1 - (y + 0.5) / height);
    };
    for (int y = 0; y < height; ++y) {
        map.edges[kLeft].height.push_back(at(0, y));
        map.edges[kRight].height.push_back(at(width - 1, y));
    }
    for (int x = 0; x < width; ++x) {
        map.edges[kTop].height.push_back(at(x, 0));
        map.edges[kBottom].height.push_back(at(x, height - 1));
    }
    return map;
}

std::vector<BorderedMap> nine_tiles(int width, int height, const Height& h)
{
    std::vector<BorderedMap> maps;
    for (int v = 0; v < 3; ++v)
        for (int u = 0; u < 3; ++u)
            maps.push_back(tile_of({u, v}, width, height, h));
    return maps;
}

constexpr size_t kMiddle = 4;

TEST(TileBorders, NeighboursOnAllSides)
{
    const Height h = [](double u, double v) { return std::sin(3 * u) + u * v * v; };
    const auto maps = nine_tiles(4, 6, h);
    const Surroundings around = surroundings_of(maps[kMiddle], maps, false, false);
    for (int y = 0; y < 6; ++y) {
        const double v = 2 - (y + 0.5) / 6;
        EXPECT_EQ(around.left[static_cast<size_t>(y)], h(1 - 0.5 / 4, v));
        EXPECT_EQ(around.right[static_cast<size_t>(y)], h(2 + 0.5 / 4, v));
    }
    for (int x = -1; x <= 4; ++x) {
        const double u = 1 + (x + 0.5) / 4;
        EXPECT_EQ(around.above[static_cast<size_t>(x + 1)], h(u, 2 + 0.5 / 6)) << x;
        EXPECT_EQ(around.below[static_cast<size_t>(x + 1)], h(u, 1 - 0.5 / 6)) << x;
    }
}

TEST(TileBorders, NothingWhereThereIsNoTile)
{
    const auto maps = nine_tiles(4, 6, [](double u, double) { return u; });
    const Surroundings corner = surroundings_of(maps[0], maps, false, false);
    for (const double height : corner.left)
        EXPECT_EQ(height, kNothingBeyond);
    for (const double height : corner.below)
        EXPECT_EQ(height, kNothingBeyond);
    EXPECT_EQ(corner.above.front(), kNothingBeyond);
    EXPECT_NE(corner.above.back(), kNothingBeyond);
}

TEST(TileBorders, ALoneMapMeetsItselfWhereItWraps)
{
    const std::vector<BorderedMap> maps = {
        tile_of({0, 0}, 4, 4, [](double u, double v) { return u + 10 * v; })};
    const Surroundings around = surroundings_of(maps[0], maps, true, false);
    EXPECT_EQ(around.left, maps[0].edges[kRight].height);
    EXPECT_EQ(around.right, maps[0].edges[kLeft].height);
    for (const double height : around.above)
        EXPECT_EQ(height, kNothingBeyond);
}

// Tiles of four resolutions: what is beyond is where the plane is.
TEST(TileBorders, APlaneStaysOneBetweenResolutions)
{
    const Height plane = [](double u, double v) { return 3 * u - 2 * v + 1; };
    const std::vector<BorderedMap> maps = {
        tile_of({1, 1}, 8, 8, plane), tile_of({0, 1}, 32, 16, plane), tile_of({2, 1}, 3, 8, plane),
        tile_of({1, 2}, 4, 40, plane)};
    const Surroundings around = surroundings_of(maps[0], maps, false, false);
    for (int y = 0; y < 8; ++y) {
        const double v = 2 - (y + 0.5) / 8;
        EXPECT_NEAR(around.left[static_cast<size_t>(y)], plane(1 - 0.5 / 8, v), 1e-12) << y;
        EXPECT_NEAR(around.right[static_cast<size_t>(y)], plane(2 + 0.5 / 8, v), 1e-12) << y;
    }
    for (int x = 0; x < 8; ++x)
        EXPECT_NEAR(around.above[static_cast<size_t>(x + 1)], plane(1 + (x + 0.5) / 8, 2 + 0.5 / 8),
                    1e-12);
}

/// Gives the tile's left and right edges places on a sheet: P = (u + shift, v, 0).
void lay_on_sheet(BorderedMap& map, double shift)
{
    for (const Side side : {kLeft, kRight}) {
        MapEdge& edge = map.edges[side];
        for (int y = 0; y < map.height; ++y) {
            edge.place.emplace_back(map.tile.u + (side == kRight ? 1 : 0) + shift,
                                    map.tile.v + 1 - (y + 0.5) / map.height, 0);
            edge.reach.push_back(0.5 / map.width);
        }
    }
    for (const Side side : {kTop, kBottom}) { // in no chart
        map.edges[side].place.assign(static_cast<size_t>(map.width), Vec3(std::nan("")));
        map.edges[side].reach.assign(static_cast<size_t>(map.width), 0);
    }
}

TEST(TileBorders, OnAMeshTheyMeetWhereTheSurfaceGoesOn)
{
    const Height h = [](double u, double v) { return u * u + v; };
    for (const double gap : {0.0, 0.1 / 8, 0.6 / 8, 1.0}) {
        std::vector<BorderedMap> maps = {tile_of({0, 0}, 8, 8, h), tile_of({1, 0}, 8, 8, h)};
        lay_on_sheet(maps[0], 0);
        lay_on_sheet(maps[1], gap);
        maps[1].edges[kLeft].place[3] = Vec3(std::nan("")); // outside of all charts
        const Surroundings around = surroundings_of(maps[0], maps, false, false);
        for (size_t y = 0; y < 8; ++y) {
            const bool meets = gap < 0.5 / 8 && y != 3;
            EXPECT_EQ(around.right[y] == kNothingBeyond, !meets) << gap << ' ' << y;
            if (meets) {
                EXPECT_EQ(around.right[y], maps[1].edges[kLeft].height[y]);
            }
        }
        EXPECT_EQ(around.left[0], kNothingBeyond);
        EXPECT_EQ(around.above[4], kNothingBeyond);
    }
}

} // namespace
} // namespace scree::test
