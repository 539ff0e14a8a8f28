#pragma once

#include <algorithm>
#include <cmath>

#include "math/vec.h"
#include "surface/surface_point.h"

namespace scree {

/// How a texture lies on a surface at a point: s to the right over [0, 1], t DOWN (t = 1 - v of an
/// OBJ file). World units per texture unit.
struct Tangents {
    Vec3 by_s{0, 0, 0}, by_t{0, 0, 0};
};

/// dP/ds and dP/dt from derivatives by the face's parameters: [P_s P_t] = [P_p P_q] U^-1, where
/// U = d(s, t)/d(p, q), t = 1 - v. Not finite where U is singular.
inline Tangents tangents(const SurfacePoint& point, const UvPoint& uv)
{
    // Cramer's rule, with t_p = -v_p and t_q = -v_q.
    const double determinant = uv.by_p % uv.by_q;
    return {(point.by_p * uv.by_q.y - point.by_q * uv.by_p.y) / determinant,
            (point.by_p * uv.by_q.x - point.by_q * uv.by_p.x) / determinant};
}

/// Unit normal on the side from which the face runs counterclockwise; not finite where the surface
/// has no tangent plane.
inline Vec3 unit_normal(const SurfacePoint& point)
{
    const Vec3 across = point.by_p % point.by_q;
    return across / across.length();
}

/// Largest absolute normal curvature, 1 / world unit: the larger |k| of
/// k = H +- sqrt(H^2 - K), H = (e N - 2 f M + g L) / (2 (e g - f^2)), K = (L N - M^2) / (e g - f^2)
/// with the fundamental forms e f g, L M N (Gauss).
///
/// normal  unit_normal(point)
inline double largest_curvature(const SurfacePoint& point, const Vec3& normal)
{
    const double e = point.by_p ^ point.by_p, f = point.by_p ^ point.by_q,
                 g = point.by_q ^ point.by_q;
    const double l = point.by_pp ^ normal, m = point.by_pq ^ normal, n = point.by_qq ^ normal;
    const double area = e * g - f * f;
    const double mean = (e * n - 2 * f * m + g * l) / (2 * area);
    const double gauss = (l * n - m * m) / area;
    // Never negative but by rounding, at umbilics.
    return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

/// The map from texture to the surface's frame: the frame's coordinates of a small step (ds, dt)
/// are (xs ds + xt dt, yt dt).
///
/// x lies along dP/ds; y in the tangent plane, square to x, on the side of dP/dt. So yt > 0, and
/// nothing depends on whether the texture is mirrored: x, y and the normal are right-handed where
/// it is, left-handed where it is not (t runs down). Upper triangular by that choice:
///
///   J = | xs xt |     xs = |P_s|,  xt = x . P_t,  yt = |P_s x P_t| / |P_s|
///       |  0 yt |
struct TextureJacobian {
    double xs = 1, xt = 0, yt = 1; ///< world units per texture unit
};

/// The frame at a point: unit vectors, square to each other. A renderer finds the same ones from
/// its own dP/ds and dP/dt, of any length.
struct TangentFrame {
    Vec3 x{1, 0, 0}, y{0, 1, 0};
};

/// tangents  neither 0 nor parallel
inline TangentFrame tangent_frame(const Tangents& tangents)
{
    const Vec3 x = tangents.by_s / tangents.by_s.length();
    const Vec3 across = tangents.by_t - x * (x ^ tangents.by_t);
    return {x, across / across.length()};
}

inline TextureJacobian texture_jacobian(const Tangents& tangents)
{
    const double length = tangents.by_s.length();
    return {length, (tangents.by_s ^ tangents.by_t) / length,
            (tangents.by_s % tangents.by_t).length() / length};
}

/// World area per texture area.
inline double area(const TextureJacobian& j) { return j.xs * j.yt; }

/// Slopes on the surface from slopes in the texture. A height changes by g . (ds, dt) over a small
/// step, and by g' . J (ds, dt) in the frame, for all steps; so g = J^T g', g' = J^-T g.
///
/// gradient  (dh/ds, dh/dt), world units per texture unit: h is measured along the normal in the
///           world units of P
/// returns (dh/dx, dh/dy), dimensionless
inline Vec2 surface_slope(const TextureJacobian& j, const Vec2& gradient)
{
    const double x = gradient.x / j.xs;
    return {x, (gradient.y - j.xt * x) / j.yt};
}

/// A symmetric 2x2 matrix.
struct SlopeCovariance {
    double xx = 0, xy = 0, yy = 0;
};

/// Their covariance, or raw second moments: C' = J^-T C J^-1, as g' is linear in g.
///
/// cov  E[(g - E g)(g - E g)^T] in the texture, square world units per square texture unit
inline SlopeCovariance surface_covariance(const TextureJacobian& j, const SlopeCovariance& cov)
{
    const double shear = j.xt / j.xs;
    const double xy = cov.xy - shear * cov.xx;
    return {cov.xx / (j.xs * j.xs), xy / (j.xs * j.yt),
            (cov.yy - shear * (cov.xy + xy)) / (j.yt * j.yt)};
}

/// How far a displacement is from small: slopes on a curved surface, displaced by h along its
/// normal, are off by the factor 1 / (1 - h k) along a direction of principal curvature k, which is
/// taken for 1.
inline double displacement_error(double height, double curvature)
{
    return std::abs(height) * curvature;
}

} // namespace scree
