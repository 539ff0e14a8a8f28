#pragma once

#include "math/vec.h"

namespace scree::test {

/// Smith's Lambda of a plane whose Gaussian slopes, of variance base_alpha^2 / 2, lie about its
/// own: by quadrature, the projected area of those turned away from w over that of the plane.
///
/// w  that the plane faces
double own_lambda(const Vec3& w, const Vec2& slope, double base_alpha);

/// Radiance over irradiance of such a plane of mirrors: of those that mirror wi into wo what is
/// neither hidden nor in shadow, over the projected area of the plane.
double mirrored_by_plane(const Vec3& wo, const Vec3& wi, const Vec2& slope, double base_alpha);

} // namespace scree::test
