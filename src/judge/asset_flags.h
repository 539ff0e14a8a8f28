#pragma once

#include <string>
#include <vector>

#include "judge/original.h"

namespace scree {

/// What about an asset the models of a set do not show well, each a sentence with its figure and
/// what to do; empty where nothing stands out.
///
/// Looked for (judge/asset_measures.h; limits and their reasons in the source): few texels, steep
/// slopes, kurtosis far below 8 or above 16, slopes in little of the area, one direction, two modes
/// of the heights, steepness that goes with height, terraces.
std::vector<std::string> asset_flags(const Original& original, Reconstruction reconstruction);

} // namespace scree
