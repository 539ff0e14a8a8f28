#pragma once

#include <optional>

#include "math/vec.h"
#include "reference/relief.h"

/// Rays against the bilinear surface straight from its definition: every cell under the ray in
/// turn, in long double, no tree, no code of src/reference but the inputs' struct.
namespace scree::oracle {

/// How far a ray keeps above the surface.
struct RayClearance {
    /// The least of ray minus surface, world units, over the cells that have all corners; +infinity
    /// where there is none.
    long double least = 0;
    /// Where the difference first changes its sign, in units of the direction's length.
    std::optional<long double> crossing;
};

/// Follows a ray from (s, t), texels, at height z, world units, for `reach` times its direction or
/// until it leaves a relief that does not go on.
///
/// direction  world units
RayClearance follow(const reference::Relief& relief, double s, double t, double z,
                    const Vec3& direction, double reach);

/// A height the relief's texels and one beyond them lie below.
double above_all(const reference::Relief& relief);

} // namespace scree::oracle
