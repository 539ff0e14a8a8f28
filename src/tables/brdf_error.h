#pragma once

#include <string>
#include <vector>

#include "tables/brdf_table.h"

namespace scree {

/// Where the error of a table is looked at.
struct BrdfRegion {
    std::string name;
    std::vector<filter::Directions<double>> pairs;
};

/// "all": pairs of directions even over both solid angles, to 87 degrees; "specular": of those h
/// within 20 degrees of the normal; "Fresnel": theta_d above 60 degrees; "grazing": viewer or light
/// above 75 degrees. The same at each call.
///
/// pairs  of each region
std::vector<BrdfRegion> brdf_regions(size_t pairs);

/// BRDF times cosine of the light, of each pair of each region.
using RegionValues = std::vector<std::vector<Rgbf>>;

/// brdf  asked where the half vector's azimuth is 0 and the back vector's in [0, pi/2] only: what
///       an average over turns leaves of the surface's azimuth is no error of a table
RegionValues region_values(const BrdfFunction& brdf, const std::vector<BrdfRegion>& regions,
                           const std::function<void(double)>& progress);

/// What a table says of the same pairs, linear between its nodes.
///
/// table  as brdf_table() gives it
RegionValues region_values(const BrdfGrid& grid, const std::vector<float>& table,
                           const std::vector<BrdfRegion>& regions);

/// Of each region the rms of got - truth over the rms of truth, all three colors together.
std::vector<double> relative_errors(const RegionValues& got, const RegionValues& truth);

} // namespace scree
