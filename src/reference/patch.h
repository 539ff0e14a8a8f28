#pragma once

#include "math/vec.h"
#include "reference/node_grid.h"

namespace scree::reference {

/// Height above the grid's base and its derivatives by x and y, world units (per texel).
struct PatchPoint {
    double height = 0;
    Vec2 slope{0, 0};
};

/// The surface inside texel (column, row) of the relief, which has data, at (x, y) in grid
/// coordinates.
///
/// A texel is four quarters of bilinear cells. Where a neighbour has no data, its height is made up
/// so that a plane stays a plane, for this texel alone: beside it, mirrored through the centre from
/// the opposite one (2 centre - opposite), or level with the centre where that is missing too; at a
/// corner, so that it closes the parallelogram of the centre and the two beside it.
PatchPoint patch_at(const NodeGrid& grid, int column, int row, double x, double y);

} // namespace scree::reference
