#pragma once

#include "judge/shading.h"

namespace scree {

/// Radiance over irradiance as of a plane that hides nothing of itself: Lambert of the mean normal,
/// and the lobe that a renderer has for the roughness.
///
///   color / pi max(0, n . wi)  +  f0 specular
///
/// The lobe is the kernel's, as LEADR mapping has it: it brings along the Smith term of its own
/// roughness, as microfacet lobes do. At covariance 0 this is `radiance` (shading.h) of a plane.
///
/// slopes  mean and covariance; tau is not looked at
/// wo, wi  unit, to viewer and light, z > 0
Rgbf unmasked_radiance(const filter::Slopes<float>& slopes, const Rgbf& color,
                       const Material& material, const Vec3f& wo, const Vec3f& wi);

/// Slopes of a plane as rough as the length of a mean normal tells.
///
/// The Blinn-Phong power s of base_alpha, s = 2 / alpha^2 - 2, becomes s |n| / (|n| + s (1 - |n|)),
/// and a roughness again; what is over base_alpha becomes a covariance, the same in all directions.
///
/// normal      mean of unit normals, z > 0
/// base_alpha  in (0, 1]
/// source      Toksvig 2005, Mipmapping normal maps; powers and roughness: Walter et al. 2007
/// not modelled: in slopes the lobe about a tilted normal is not round
filter::Slopes<float> toksvig_slopes(const Vec3f& normal, float base_alpha);

} // namespace scree
