#pragma once

#include <array>
#include <string>
#include <vector>

#include "figures/brdf_materials.h"

namespace scree::test {

/// Where errors are looked at.
struct BrdfRegion {
    std::string name;
    std::vector<filter::Directions<double>> pairs;
};

/// All pairs; h within 20 degrees of the normal; theta_d above 60 degrees; viewer or light above 75
/// degrees; both directions drawn evenly over their solid angle, to 87 degrees, and picked. The
/// same at each call.
std::vector<BrdfRegion> brdf_regions();

/// A material's values in the regions, in their order: BRDF times cosine of the light.
using RegionValues = std::vector<std::vector<double>>;
RegionValues true_values(const BrdfMaterial& material, const std::vector<BrdfRegion>& regions);

/// Of each region the rms error of what a table of this grid gives, per rms of the truth.
std::vector<double> interpolation_errors(const BrdfMaterial& material, const BrdfGrid& grid,
                                         const std::vector<BrdfRegion>& regions,
                                         const RegionValues& truth);

} // namespace scree::test
