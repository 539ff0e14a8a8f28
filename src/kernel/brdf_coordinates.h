#pragma once

// Coordinates for BRDFs, for renderers in C++: scree_brdf_coordinates.h on Imath vectors. Header
// only; float or double. Ranges, limits, errors and sources of the formulas stand in
// scree_brdf_coordinates.h at the functions named the same.

#include "kernel/filter.h"

#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/scree_brdf_coordinates.h"
}

#include "kernel/prelude_cpp_end.h"

namespace scree::filter {

/// To viewer and light: unit vectors, z >= 0.
template <typename Real>
struct Directions {
    Vec3<Real> wo{0, 0, 1}, wi{0, 0, 1};
};

/// Rusinkiewicz' coordinates, radians.
template <typename Real>
struct HalfDifference {
    Real theta_h = 0, phi_h = 0, theta_d = 0, phi_d = 0;
};

/// Lengths of h_bar and k_bar, in [0, 1], and their azimuths, radians.
template <typename Real>
struct Orthographic {
    Real h_bar = 0, phi_h = 0, k_bar = 0, phi_k = 0;
};

/// Lengths of h_bar and k, in [0, 1], and their azimuths, radians.
template <typename Real>
struct Hybrid {
    Real h_bar = 0, phi_h = 0, k = 0, phi_k = 0;
};

template <typename Real>
HalfDifference<Real> half_difference(const Directions<Real>& w)
{
    HalfDifference<Real> out;
    kernel::scree_to_half_difference(w.wo.x, w.wo.y, w.wo.z, w.wi.x, w.wi.y, w.wi.z, out.theta_h,
                                     out.phi_h, out.theta_d, out.phi_d);
    return out;
}

template <typename Real>
Orthographic<Real> orthographic(const Directions<Real>& w)
{
    Orthographic<Real> out;
    kernel::scree_to_orthographic(w.wo.x, w.wo.y, w.wi.x, w.wi.y, out.h_bar, out.phi_h, out.k_bar,
                                  out.phi_k);
    return out;
}

template <typename Real>
Hybrid<Real> hybrid(const Directions<Real>& w)
{
    Hybrid<Real> out;
    kernel::scree_to_hybrid(w.wo.x, w.wo.y, w.wo.z, w.wi.x, w.wi.y, w.wi.z, out.h_bar, out.phi_h,
                            out.k, out.phi_k);
    return out;
}

template <typename Real>
Directions<Real> directions(const HalfDifference<Real>& c)
{
    Directions<Real> out;
    kernel::scree_from_half_difference(c.theta_h, c.phi_h, c.theta_d, c.phi_d, out.wo.x, out.wo.y,
                                       out.wo.z, out.wi.x, out.wi.y, out.wi.z);
    return out;
}

template <typename Real>
Directions<Real> directions(const Orthographic<Real>& c)
{
    Directions<Real> out;
    kernel::scree_from_orthographic(c.h_bar, c.phi_h, c.k_bar, c.phi_k, out.wo.x, out.wo.y,
                                    out.wo.z, out.wi.x, out.wi.y, out.wi.z);
    return out;
}

template <typename Real>
Directions<Real> directions(const Hybrid<Real>& c)
{
    Directions<Real> out;
    kernel::scree_from_hybrid(c.h_bar, c.phi_h, c.k, c.phi_k, out.wo.x, out.wo.y, out.wo.z,
                              out.wi.x, out.wi.y, out.wi.z);
    return out;
}

/// The coordinates of all three systems without phi_h, azimuths folded to [0, pi/2].
template <typename Real>
struct IsotropicCoordinates {
    Real theta_h = 0, theta_d = 0, phi_d = 0;      ///< half/difference
    Real h_bar = 0, k_bar = 0, k = 0, azimuth = 0; ///< orthographic and hybrid
};

template <typename Real>
IsotropicCoordinates<Real> isotropic_coordinates(const Directions<Real>& w)
{
    IsotropicCoordinates<Real> out;
    kernel::scree_isotropic_coordinates(w.wo.x, w.wo.y, w.wo.z, w.wi.x, w.wi.y, w.wi.z, out.theta_h,
                                        out.theta_d, out.phi_d, out.h_bar, out.k_bar, out.k,
                                        out.azimuth);
    return out;
}

/// Where the table of `scree table brdf` with its own axes has a pair of directions, each in [0,
/// 1].
template <typename Real>
Vec3<Real> hybrid_place(const Directions<Real>& w)
{
    Vec3<Real> out;
    kernel::scree_hybrid_place(w.wo.x, w.wo.y, w.wo.z, w.wi.x, w.wi.y, w.wi.z, out.x, out.y, out.z);
    return out;
}

} // namespace scree::filter
