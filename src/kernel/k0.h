#pragma once

// The K0 law of slopes, for renderers in C++: scree_k0.h on Imath vectors. Header only; float or
// double. Ranges, limits, errors and sources of the formulas stand in scree_k0.h at the functions
// named the same.

#include "kernel/filter.h"

#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/scree_k0.h"
}

#include "kernel/prelude_cpp_end.h"

namespace scree::k0 {

using filter::Masking;
using filter::Slopes;
using filter::Vec2;
using filter::Vec3;

// Slopes::tau counts in mixture_slope_pdf only: everything else is K0 alone. Of a mixture, areas
// and masking are filter::projected_area and filter::masking.

/// Density of K0 slopes, or its mean over a pixel.
///
/// rho  radius of the pixel in deviations, 0 for the density itself, infinite at the mean:
///      sqrt(A / (pi sqrt(det C))) for a pixel that covers an area A of slopes
template <typename Real>
Real slope_pdf(const Vec2<Real>& slope, const Slopes<Real>& slopes, Real rho = 0)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_k0_slope_pdf(slope.x, slope.y, slopes.mean.x, slopes.mean.y, ss, st, tt,
                                      rho);
}

/// (1 - tau) Gaussian + tau K0.
template <typename Real>
Real mixture_slope_pdf(const Vec2<Real>& slope, const Slopes<Real>& slopes, Real rho = 0)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_mixture_slope_pdf(slope.x, slope.y, slopes.mean.x, slopes.mean.y, ss, st,
                                           tt, slopes.tau, rho);
}

/// D(m), m unit: area of facets per solid angle of their normals, per area of the texture plane.
template <typename Real>
Real ndf(const Vec3<Real>& m, const Slopes<Real>& slopes, Real rho = 0)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_k0_ndf(m.x, m.y, m.z, slopes.mean.x, slopes.mean.y, ss, st, tt, rho);
}

/// Projected area of the facets that face w, above the texture plane or below.
template <typename Real>
Real projected_area(const Vec3<Real>& w, const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_k0_area(w.x, w.y, w.z, slopes.mean.x, slopes.mean.y, ss, st, tt);
}

/// Smith's Lambda and G1.
template <typename Real>
Masking<Real> masking(const Vec3<Real>& w, const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    Masking<Real> out;
    kernel::scree_k0_masking(w.x, w.y, w.z, slopes.mean.x, slopes.mean.y, ss, st, tt, out.lambda,
                             out.g1);
    return out;
}

/// Density of the slopes that w faces: of what sample_visible() draws.
template <typename Real>
Real visible_slope_pdf(const Vec2<Real>& slope, const Vec3<Real>& w, const Slopes<Real>& slopes,
                       Real rho = 0)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return kernel::scree_k0_visible_pdf(slope.x, slope.y, w.x, w.y, w.z, slopes.mean.x,
                                        slopes.mean.y, ss, st, tt, rho);
}

/// A slope; u  three random numbers in [0, 1).
template <typename Real>
Vec2<Real> sample(const Real (&u)[3], const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    Vec2<Real> out;
    kernel::scree_k0_sample(u[0], u[1], u[2], slopes.mean.x, slopes.mean.y, ss, st, tt, out.x,
                            out.y);
    return out;
}

/// A slope as w faces it; u  five random numbers in [0, 1). Its normal is filter::normal().
template <typename Real>
Vec2<Real> sample_visible(const Real (&u)[5], const Vec3<Real>& w, const Slopes<Real>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    Vec2<Real> out;
    kernel::scree_k0_sample_visible(u[0], u[1], u[2], u[3], u[4], w.x, w.y, w.z, slopes.mean.x,
                                    slopes.mean.y, ss, st, tt, out.x, out.y);
    return out;
}

} // namespace scree::k0
