#pragma once

#include <array>

#include "figures/slope_measure.h"
#include "figures/slope_truth.h"

namespace scree::test {

/// Specular radiance of the kernel, with and without the facets' roughness in its masking, against
/// rays of facets that hide nothing of themselves, as the reference renderer has them, and of
/// facets that do.
struct BaseMaskingFigures {
    struct OfBase {
        ScoresOfAngles kernel, kernel_bare;               ///< against facets that hide nothing
        ScoresOfAngles kernel_masked, kernel_bare_masked; ///< against facets that hide themselves
    };
    std::array<OfBase, kBaseAlphas.size()> bases;
};

/// Of the whole map, at the nodes.
///
/// Facets that hide themselves have Smith's G2 = 1 / (1 + Lambda_o + Lambda_i) of their own
/// Gaussian about their own slope.
///
/// map  of see_slopes()
BaseMaskingFigures measure_base_masking(const reference::DisplacedSurface& surface,
                                        const SlopesOfSize& map, const SlopeViews& views);

/// Share of the light from an angle that a white rough plane reflects: the integral of its specular
/// term over the upper directions, view and light exchanged (the BRDF is the same).
///
/// masked  with the roughness in the masking, as the kernel has it, or without
double plane_albedo(double angle_deg, double base_alpha, bool masked);

} // namespace scree::test
