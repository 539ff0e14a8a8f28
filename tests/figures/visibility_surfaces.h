#pragma once

#include <filesystem>
#include <vector>

#include "chart/asset.h"

namespace scree::test {

/// The built-in samples that have an effect to tell, at 512x512 texels; and scanned and painted
/// materials, whose heights repeat.
///
/// data  the folder of real data beside the project; empty: samples alone
/// Throws Error when a file of it is missing.
std::vector<Asset> visibility_surfaces(const std::filesystem::path& data);

/// Rms length of the slope, sqrt(E[s^2] + E[t^2]), as a bake measures it.
double rms_slope(const Asset& asset);

Asset with_heights_scaled(Asset asset, double factor);

} // namespace scree::test
