#pragma once

#include "math/vec.h"

namespace scree {

/// A surface at a parametric place (p, q) of a face: position and derivatives by p and q, world
/// units. P_p x P_q points outside (the face's winding).
///
/// On triangles of Loop's scheme all three second derivatives may have the wrong sign: OpenSubdiv
/// (3.5, 3.6) applies that of a patch turned half around once, not twice. Normal curvatures then
/// change sign together, and nothing here looks at their sign.
struct SurfacePoint {
    Vec3 position{0, 0, 0};
    Vec3 by_p{0, 0, 0}, by_q{0, 0, 0};
    Vec3 by_pp{0, 0, 0}, by_pq{0, 0, 0}, by_qq{0, 0, 0};
};

/// Texture coordinates there (v UP) and their derivatives.
struct UvPoint {
    Vec2 uv{0, 0};
    Vec2 by_p{0, 0}, by_q{0, 0};
};

} // namespace scree
