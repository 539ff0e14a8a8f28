#pragma once

#include <array>
#include <string>
#include <vector>

#include "chart/asset.h"
#include "figures/slope_views.h"
#include "kernel/filter.h"
#include "reference/displaced_surface.h"
#include "reference/gather.h"

namespace scree::test {

/// Footprints of one size: what a set holds of their slopes, and what the reference renderer sees.
struct SlopesOfSize {
    std::string name; ///< texels along a side, or "map"
    std::vector<filter::Slopes<double>> baked;
    std::vector<reference::Footprint> places;
    std::vector<reference::Estimate> fitted; ///< of SlopeViews::fitted, without lights
    /// Of SlopeViews::judged and lights, one a roughness of kBaseAlphas.
    std::array<std::vector<reference::Estimate>, kBaseAlphas.size()> judged;
};

/// The asset's surface, in two colors at once: R is 1, so that diffuse radiance is told without the
/// color; G is the asset's luminance over its mean; B is 0.
reference::DisplacedSurface white_and_gray(const Asset& asset);

/// Bakes the asset and looks at footprints of 16x16 and 64x64 texels and at the whole map.
///
/// surface  of white_and_gray()
std::vector<SlopesOfSize> see_slopes(const Asset& asset, const reference::DisplacedSurface& surface,
                                     const SlopeViews& views);

} // namespace scree::test
