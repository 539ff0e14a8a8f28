#pragma once

#include "figures/slope_measure.h"

namespace scree::test {

/// The kernel's specular error where nothing is wrong but that it takes two scales of slopes as one
/// Gaussian: relative, at the nodes, all views alike.
///
/// Facets have Gaussian slopes without a mean, alike along all directions, and hide each other as
/// Smith has it; each is rough as the reference renderer's are.
///
/// rms_slope   length of the facets' slope
/// base_masks  whether the kernel has the roughness in its masking, as it does
ScoresOfAngles kernel_on_two_scales(double rms_slope, double base_alpha, const SlopeViews& views,
                                    bool base_masks);

} // namespace scree::test
