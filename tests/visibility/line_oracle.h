#pragma once

#include <cstddef>
#include <vector>

namespace scree::test {

/// A node of a line's profile, which is straight in between. World units.
struct ProfileNode {
    long double away; ///< from the viewer
    long double height;
};

/// What a view sees of the piece between nodes[far - 1] and nodes[far], over cos theta.
///
/// It is held against every node nearer to the viewer, point by point in closed form: visible is
/// where no node is above the line of sight. No running maximum.
///
/// nodes      in order, away from the viewer; those left out hide nothing
/// far        >= 1
/// cotangent  of the view's angle from the normal
long double seen_of_piece(const std::vector<ProfileNode>& nodes, std::size_t far,
                          long double cotangent);

} // namespace scree::test
