#pragma once

#include <array>
#include <vector>

#include "surface/limit_surface.h"

namespace scree {

/// A part of a face small enough for its texture coordinates to be about linear: where to look for
/// a point of the texture, and where to start.
struct UvCell {
    int piece = 0;               ///< of the face
    std::array<Vec2, 4> corners; ///< texture coordinates; a triangle has its last one twice
    double margin = 0;           ///< the cell lies within so much of its corners' convex hull
    Vec2 middle{0, 0};           ///< parameters of its middle
};

/// 1 to 64 cells a piece, as many for a triangle.
///
/// The margin is twice the largest distance of a curved cell's middle, or that of an edge, from
/// where corners alone would have it; for a parabola once would do.
std::vector<UvCell> uv_cells(const FaceSurface& face);

/// A cell's extent in u over the texture coordinates v to v, margin included.
struct UvSpan {
    double low, high; ///< low > high: none
};
UvSpan span_at(const UvCell& cell, double v);

/// The same in v over all u.
UvSpan height_of(const UvCell& cell);

} // namespace scree
