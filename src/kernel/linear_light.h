#pragma once

// Reflection of thin linear lights on filtered surfaces, for renderers in C++: scree_linear_light.h
// on Imath vectors. Header only; float or double. Ranges, limits, errors and sources of the
// formulas stand in scree_linear_light.h at the functions named the same.

#include "kernel/filter.h"

#pragma push_macro("LIT")
#pragma push_macro("OUT")
#undef LIT
#undef OUT
#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/scree_linear_light.h"
}

#undef SCREE_FUNCTION
#undef LIT
#undef OUT
#pragma pop_macro("OUT")
#pragma pop_macro("LIT")

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

} // namespace scree::filter
