#pragma once

#include <string>
#include <vector>

#include "judge/original.h"
#include "texset/manifest.h"

namespace scree {

/// What about an asset the models of a set do not show well, each a sentence with its figure and
/// what to do; empty where nothing stands out.
std::vector<std::string> asset_flags(const Manifest& manifest, const Original& original);

} // namespace scree
