#pragma once

// Reflection of thin linear lights on filtered surfaces, for renderers in C++: scree_linear_light.h
// on Imath vectors. Header only; float or double. Ranges, limits, errors and sources of the
// formulas stand in scree_linear_light.h at the functions named the same.

#include "kernel/filter.h"

#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/scree_linear_light.h"
}

#include "kernel/prelude_cpp_end.h"

namespace scree::filter {

/// Where the reflection of a linear light is brightest, and how it falls off: the Gaussian
/// exp(-(tan2 + k^2 (x - phi)^2) / sigma^2) over the angle x along the light.
template <typename Real>
struct LinearPeak {
    Real phi = 0;  ///< in (-pi, pi]
    Real k = 0;    ///< per radian, >= 1/2
    Real tan2 = 0; ///< of the angle between normal and half vector there
};

/// viewer  unit, in the frame (u, e, w) of the light: (sin theta_v, 0, cos theta_v), cos >= 0
/// normal  unit, in the same frame
/// steps   of Newton: 4 for float, 8 for double
template <typename Real>
LinearPeak<Real> linear_peak(const Vec3<Real>& viewer, const Vec3<Real>& normal, int steps)
{
    LinearPeak<Real> out;
    kernel::scree_linear_peak(viewer.x, viewer.z, normal.x, normal.y, normal.z, steps, out.phi,
                              out.k, out.tan2);
    return out;
}

/// A thin linear light, from the point that is shaded; lengths in any unit.
template <typename Real>
struct LinearLight {
    Vec3<Real> from, to; ///< its ends
    Vec3<Real> normal;   ///< unit: it shines on this side alone
};

/// A light, a viewer and a surface in the frame of the light: what every way to integrate takes.
template <typename Real>
struct LinearView {
    Vec3<Real> viewer, normal; ///< unit; viewer (sin theta_v, 0, cos theta_v)
    Vec3<Real> light_normal;
    Real first = 0, last = 0; ///< angles of what is above the horizon; equal where nothing is
    Real distance = 1;        ///< of the light's line
};

/// normal  of the surface, viewer: unit vectors
template <typename Real>
LinearView<Real> linear_view(const LinearLight<Real>& light, const Vec3<Real>& normal,
                             const Vec3<Real>& viewer)
{
    LinearView<Real> out;
    Vec3<Real> u, e, w;
    kernel::scree_linear_frame(light.from.x, light.from.y, light.from.z, light.to.x, light.to.y,
                               light.to.z, normal.x, normal.y, normal.z, viewer.x, viewer.y,
                               viewer.z, u.x, u.y, u.z, e.x, e.y, e.z, w.x, w.y, w.z, out.first,
                               out.last, out.distance);
    out.viewer = {viewer.dot(u), 0, std::max(viewer.dot(w), Real(0))};
    out.normal = {normal.dot(u), normal.dot(e), normal.dot(w)};
    out.light_normal = {light.normal.dot(u), light.normal.dot(e), light.normal.dot(w)};
    return out;
}

/// Ward's sigma^2 of a footprint: mean variance of its slopes, and the facets' own roughness.
template <typename Real>
Real ward_sigma2(const Covariance<Real>& covariance, Real base_alpha)
{
    return kernel::scree_ward_sigma2(covariance.ss, covariance.tt, base_alpha);
}

/// Radiance reflected, per the light's radiance and width, by the Gaussian about the peak.
template <typename Real>
Real linear_reflection(const LinearView<Real>& view, const LinearPeak<Real>& peak, Real sigma2)
{
    return kernel::scree_linear_reflection(view.viewer.x, view.viewer.z, view.normal.x,
                                           view.normal.y, view.normal.z, view.light_normal.x,
                                           view.light_normal.y, view.first, view.last,
                                           view.distance, peak.phi, peak.k, peak.tan2, sigma2);
}

/// The same by 4 panels points about the peak.
template <typename Real>
Real linear_quadrature(const LinearView<Real>& view, const LinearPeak<Real>& peak, Real sigma2,
                       int panels)
{
    return kernel::scree_linear_quadrature(
        view.viewer.x, view.viewer.z, view.normal.x, view.normal.y, view.normal.z,
        view.light_normal.x, view.light_normal.y, view.first, view.last, view.distance, peak.phi,
        peak.k, peak.tan2, sigma2, static_cast<Real>(panels));
}

} // namespace scree::filter
