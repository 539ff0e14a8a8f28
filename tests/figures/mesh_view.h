#pragma once

#include <functional>
#include <vector>

#include "figures/canvas.h"
#include "math/vec.h"
#include "surface/limit_surface.h"

namespace scree::test {

/// A point of a surface as a camera sees it.
struct SeenPoint {
    double depth = 0;  ///< towards the camera
    Vec2 place;        ///< in the texture, (s, t)
    Vec3 x, y, normal; ///< the slopes' frame (surface/metric.h)
};

/// A parallel view of the whole surface.
///
/// size      pixels a side
/// toward    to the camera, of any length; +y is up
/// returns   size x size points by rows, depth -infinity where nothing is
std::vector<SeenPoint> view_of_surface(const LimitSurface& surface, int size, const Vec3& toward);

} // namespace scree::test
