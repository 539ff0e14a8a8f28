#pragma once

#include <algorithm>
#include <cmath>

namespace scree {

/// Fresnel reflectance of a facet whose normal is the half vector, after Schlick 1994.
///
/// f0      at normal incidence, 0 to 1
/// cosine  of the angle between half vector and light
inline double schlick(double f0, double cosine)
{
    return f0 + (1 - f0) * std::pow(std::max(1 - cosine, 0.0), 5);
}

} // namespace scree
