#pragma once

#include "figures/slope_table.h"

namespace scree::test {

/// How much of what is seen of a footprint the light reaches: 1 / G1 of the view times G2, Smith's
/// of the baked slopes. Of what faces the light.
double shadowing(const Vec3& wo, const Vec3& wi, const filter::Slopes<double>& baked);

/// Diffuse radiance over irradiance, white: the kernel's closed form of it, with visible slopes
/// that are given instead of the kernel's own.
///
/// open  of shadowing()
double diffuse_of(const SeenSlopes& seen, double open, const Vec3& wi);

/// Specular radiance over irradiance without Fresnel, from visible slopes:
///
///   open E_vis[p(slope of h - slope) G2 / W] / (4 h.z^4)
///
/// of facets that mirror as the reference renderer's do (p Gaussian, variance base_alpha^2 / 2, G2
/// Smith's of it about the facet), with the visible slopes taken as the Gaussian of their mean and
/// covariance. W, the area that a facet shows, and G2 are taken where the product of the two
/// Gaussians has its mean, with areas at least a quarter of those of the mean slope: the Gaussian
/// does not vanish where W does.
double specular_of(const SeenSlopes& seen, double open, const Vec3& wo, const Vec3& wi,
                   double base_alpha);

/// The kernel's specular term with the facets' roughness in the lobe and not in the masking.
double specular_without_base_masking(const Vec3& wo, const Vec3& wi,
                                     const filter::Slopes<double>& baked, double base_alpha);

} // namespace scree::test
