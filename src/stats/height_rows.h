#pragma once

#include <vector>

namespace scree {

/// What lies beyond the edge of a map, as far as its slopes are concerned.
enum class Edge {
    periodic, ///< the texel at the opposite edge
    extend,   ///< nothing: the last bilinear cell goes on, so a plane stays a plane
    repeat,   ///< the texel at the edge again (a mirrored map, or maketx's clamp)
    zero,     ///< height 0
};

/// Adds the texels beyond both ends of a row.
///
/// row   width + 2 heights, world units; [1, width] are given, [0] and [width + 1] are set.
///       NaN is no data, and spreads to an end that is extended from it
void pad_row(double* row, int width, Edge edge);

/// The row beyond an end of the map, made of the last row and the one before it.
///
/// last, before_last  padded rows of width + 2 heights; the same row where the map has just one
/// opposite           the padded row at the other end of the map, for Edge::periodic
std::vector<double> row_beyond(Edge edge, const std::vector<double>& last,
                               const std::vector<double>& before_last,
                               const std::vector<double>& opposite);

/// Fills holes (NaN) in the 3x3 neighbourhood of a texel so that a plane stays a plane.
///
/// An edge neighbour is mirrored through the centre from its opposite (2 c - opposite), or is the
/// centre where that is missing too; a corner closes the parallelogram of its edge neighbours and
/// the centre.
///
/// h  rows of 3, heights; h[1][1] is a number
void complete_neighbours(double h[3][3]);

} // namespace scree
