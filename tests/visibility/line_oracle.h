#pragma once

#include <functional>
#include <vector>

namespace scree::test {

/// Height at a place along a line, texels of the axis it steps on: at whole and half places.
using Profile = std::function<long double(double place)>;

/// What a view sees of the stretch of a line from place - 1/2 to place + 1/2, over its length and
/// cos theta.
///
/// Every straight piece is held against every node nearer to the viewer, point by point in closed
/// form: visible is where no node is above the line of sight. In world units, with no running
/// maximum.
///
/// away       +1 or -1, away from the viewer
/// reach      places towards the viewer that can hide it; nodes beyond are left out
/// length     of a step, world units
/// cotangent  of the view's angle from the normal
long double seen_of_line(const Profile& height_at, int place, int away, int reach,
                         long double length, long double cotangent);

} // namespace scree::test
