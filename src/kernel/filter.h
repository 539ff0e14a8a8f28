#pragma once

// What a viewer sees of a filtered surface, for renderers in C++: scree_filter.h on Imath vectors.
//
// Header only; float or double; needs nothing but Imath. Ranges, limits, errors and sources of the
// formulas stand in scree_filter.h at the functions named the same.

#include <Imath/ImathVec.h>

#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/scree_filter.h"
}

#include "kernel/prelude_cpp_end.h"

namespace scree::filter {

template <typename Real>
using Vec2 = Imath::Vec2<Real>;
template <typename Real>
using Vec3 = Imath::Vec3<Real>;

/// A covariance of slopes: E[ss] - E[s]^2 and so on, dimensionless.
template <typename Real>
struct Covariance {
    Real ss = 0, st = 0, tt = 0;
};

/// One filtered lookup in NAME.slope.exr, in the order of its channels.
template <typename Real>
struct SlopeMoments {
    Real s = 0, ss = 0, st = 0, t = 0, tt = 0;
};

/// The slopes of a footprint.
template <typename Real>
struct Slopes {
    Vec2<Real> mean{0, 0};
    Covariance<Real> covariance;
    Real tau = 0; ///< weight of K0 tails, NAME.tail.exr; 0 is Gaussian
};

/// Slopes from filtered raw moments; the covariance is made positive semi-definite.
template <typename Real>
Slopes<Real> slopes(const SlopeMoments<Real>& raw, Real tau = 0)
{
    Slopes<Real> out;
    out.mean = {raw.s, raw.t};
    kernel::scree_covariance(raw.s, raw.t, raw.ss, raw.st, raw.tt, out.covariance.ss,
                             out.covariance.st, out.covariance.tt);
    out.tau = tau;
    return out;
}

/// Projected area N of the facets that face w (unit, away from the surface), per area of the
/// texture plane.
template <typename Real>
Real projected_area(const Vec3<Real>& w, const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_projected_area(w.x, w.y, w.z, slopes.mean.x, slopes.mean.y, ss, st, tt,
                                        slopes.tau);
}

/// Smith's Lambda, in [0, 1e6], and G1, in [0, 1].
template <typename Real>
struct Masking {
    Real lambda = 0, g1 = 1;
};

template <typename Real>
Masking<Real> masking(const Vec3<Real>& w, const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    Masking<Real> out;
    kernel::scree_masking(w.x, w.y, w.z, slopes.mean.x, slopes.mean.y, ss, st, tt, slopes.tau,
                          out.lambda, out.g1);
    return out;
}

/// Masking-shadowing of view and light together.
template <typename Real>
Real g2(const Masking<Real>& view, const Masking<Real>& light)
{
    return kernel::scree_g2(view.lambda, light.lambda);
}

/// One filtered lookup in NAME.exponent.exr, in the order of its channels.
template <typename Real>
struct Exponent {
    Real gain = 1, power = 1, threshold = 0;
};

/// The exponent of visible_height() as it was measured of the asset, in place of masking().lambda.
///
/// raw  as looked up: its second moments count, not its mean
/// tau  weight of K0 tails, as in Slopes
template <typename Real>
Real measured_exponent(const Vec3<Real>& w, const SlopeMoments<Real>& raw, Real tau,
                       const Exponent<Real>& exponent)
{
    const Real lambda = kernel::scree_raw_lambda(w.x, w.y, w.z, raw.ss, raw.st, raw.tt, tau);
    return kernel::scree_measured_exponent(lambda, exponent.gain, exponent.power,
                                           exponent.threshold);
}

/// What a direction sees of the slopes: projected area N, mean and covariance.
template <typename Real>
struct VisibleSlopes {
    Real area = 0;
    Vec2<Real> mean{0, 0};
    Covariance<Real> covariance;
};

template <typename Real>
VisibleSlopes<Real> visible_slopes(const Vec3<Real>& w, const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    VisibleSlopes<Real> out;
    kernel::scree_visible_slopes(w.x, w.y, w.z, slopes.mean.x, slopes.mean.y, ss, st, tt,
                                 slopes.tau, out.area, out.mean.x, out.mean.y, out.covariance.ss,
                                 out.covariance.st, out.covariance.tt);
    return out;
}

/// Unit normal of a slope.
template <typename Real>
Vec3<Real> normal(const Vec2<Real>& slope)
{
    return Vec3<Real>(-slope.x, -slope.y, 1).normalized();
}

/// Mean and variance of the visible height, in standard deviations from the mean.
template <typename Real>
struct VisibleHeight {
    Real mean = 0, variance = 1;
};

/// exponent  Lambda or measured_exponent() of the view, plus that of the light for what is seen
///           and lit
template <typename Real>
VisibleHeight<Real> visible_height(Real exponent)
{
    VisibleHeight<Real> out;
    kernel::scree_visible_height(exponent, out.mean, out.variance);
    return out;
}

/// Standard deviation of a filtered height: what a height-mapped color is looked up with is
/// h + sigma visible.mean and sigma sqrt(visible.variance), see color_map_coordinates.
template <typename Real>
Real height_sigma(Real h, Real hh)
{
    return kernel::scree_height_sigma(h, hh);
}

/// Visible color by its linear correlation with height.
///
/// color, color_height  E[c], E[c hn];  h, hh  E[hn], E[hn hn]: lookups in the set
template <typename Real>
Vec3<Real> color_by_height(const Vec3<Real>& color, const Vec3<Real>& color_height, Real h, Real hh,
                           const VisibleHeight<Real>& visible)
{
    Vec3<Real> out;
    for (int i = 0; i < 3; ++i)
        out[i] = kernel::scree_color_by_height(color[i], color_height[i], h, hh, visible.mean);
    return out;
}

/// Visible color by rank: a_1..a_count of NAME.rank.exr; those beyond 8 are not used.
template <typename Real>
Vec3<Real> color_by_rank(const Vec3<Real>& color, const Vec3<Real>* a, int count, Real exponent)
{
    Vec3<Real> out;
    for (int i = 0; i < 3; ++i) {
        Real of[8] = {};
        for (int n = 0; n < std::min(count, 8); ++n)
            of[n] = a[n][i];
        out[i] = kernel::scree_color_by_rank(color[i], of[0], of[1], of[2], of[3], of[4], of[5],
                                             of[6], of[7], exponent);
    }
    return out;
}

/// Size and ranges of a color-map table: columns are means, rows roots of the deviation.
template <typename Real>
struct ColorMapTable {
    Real low = 0, high = 1; ///< means at the centres of the first and last column
    Real widest = 1;        ///< deviation at the centre of the last row; 0 at that of the first
    int columns = 1, rows = 1;
};

/// Texture coordinates of (mean, deviation) in the table.
template <typename Real>
Vec2<Real> color_map_coordinates(Real mean, Real deviation, const ColorMapTable<Real>& table)
{
    Vec2<Real> out;
    kernel::scree_color_map_coordinates(mean, deviation, table.low, table.high, table.widest,
                                        static_cast<Real>(table.columns),
                                        static_cast<Real>(table.rows), out.x, out.y);
    return out;
}

/// Mean and standard deviation of the slope along a unit direction in the texture plane.
template <typename Real>
struct SlopeAlong {
    Real mean = 0, deviation = 0;
};

template <typename Real>
SlopeAlong<Real> slope_along(const Vec2<Real>& direction, const Vec2<Real>& mean,
                             const Covariance<Real>& covariance)
{
    SlopeAlong<Real> out;
    kernel::scree_slope_along(direction.x, direction.y, mean.x, mean.y, covariance.ss,
                              covariance.st, covariance.tt, out.mean, out.deviation);
    return out;
}

/// The same for the length of the slope, as a color map by steepness is looked up.
template <typename Real>
SlopeAlong<Real> slope_magnitude(const Vec2<Real>& mean, const Covariance<Real>& covariance)
{
    SlopeAlong<Real> out;
    kernel::scree_slope_magnitude(mean.x, mean.y, covariance.ss, covariance.tt, out.mean,
                                  out.deviation);
    return out;
}

/// Visible color by its linear correlation with slope.
///
/// color, color_s, color_t  E[c], E[c s], E[c t]: lookups in the set
template <typename Real>
Vec3<Real> color_by_slope(const Vec3<Real>& color, const Vec3<Real>& color_s,
                          const Vec3<Real>& color_t, const Vec3<Real>& w,
                          const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    const Real pull = kernel::scree_slope_pull(w.x, w.y, w.z, slopes.mean.x, slopes.mean.y, ss, st,
                                               tt, slopes.tau);
    Vec3<Real> out;
    for (int i = 0; i < 3; ++i)
        out[i] = kernel::scree_color_by_slope(color[i], color_s[i], color_t[i], slopes.mean.x,
                                              slopes.mean.y, w.x, w.y, pull);
    return out;
}

/// Anisotropic Beckmann roughness; the angle is from +s towards +t.
template <typename Real>
struct Beckmann {
    Real alpha_x = 0, alpha_y = 0, angle_rad = 0;
};

/// base_alpha  roughness of the facets themselves
template <typename Real>
Beckmann<Real> beckmann_roughness(const Covariance<Real>& covariance, Real base_alpha)
{
    Beckmann<Real> out;
    kernel::scree_beckmann_roughness(covariance.ss, covariance.st, covariance.tt, base_alpha,
                                     out.alpha_x, out.alpha_y, out.angle_rad);
    return out;
}

/// Specular BRDF times cosine, without Fresnel. Gaussian slopes: tau does not enter.
template <typename Real>
Real specular(const Vec3<Real>& wo, const Vec3<Real>& wi, const Slopes<Real>& slopes,
              Real base_alpha)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_specular(wo.x, wo.y, wo.z, wi.x, wi.y, wi.z, slopes.mean.x, slopes.mean.y,
                                  ss, st, tt, base_alpha);
}

/// Diffuse BRDF times cosine, per albedo / pi.
template <typename Real>
Real diffuse(const Vec3<Real>& wo, const Vec3<Real>& wi, const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_diffuse(wo.x, wo.y, wo.z, wi.x, wi.y, wi.z, slopes.mean.x, slopes.mean.y,
                                 ss, st, tt, slopes.tau);
}

} // namespace scree::filter
