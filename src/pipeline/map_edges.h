#pragma once

#include <array>
#include <limits>
#include <vector>

#include "math/vec.h"

namespace scree {

/// The four sides of a map, rows counted from the top.
enum Side { kLeft, kRight, kTop, kBottom };
constexpr std::array<Side, 4> kSides{kLeft, kRight, kTop, kBottom};

constexpr Side opposite(Side side)
{
    constexpr std::array<Side, 4> kOpposites{kRight, kLeft, kBottom, kTop};
    return kOpposites[side];
}

/// The texels along one side of a map, from the left, or from the top.
struct MapEdge {
    std::vector<double> height; ///< world units; NaN: no data
    /// Of a map on a mesh: the surface's point on the border beside each texel; NaN outside of all
    /// charts. Empty: on a plane.
    std::vector<Vec3> place;
    std::vector<double> reach; ///< of those: from the texel's centre to there, world units
};
using MapEdges = std::array<MapEdge, 4>; ///< by Side

/// Stands for a height where nothing goes on beyond a map's side, and its wrap says what is there.
constexpr double kNothingBeyond = std::numeric_limits<double>::infinity();

/// Heights beyond a map's sides, world units, of which slopes at its border are made; NaN: no data,
/// as inside of the map.
struct Surroundings {
    std::vector<double> left, right;  ///< of every row
    std::vector<double> above, below; ///< of every column, the corners before and behind them
};

} // namespace scree
