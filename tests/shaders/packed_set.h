#pragma once

#include <vector>

#include "shaders/sample_set.h"

namespace scree::test {

/// The textures of src/shaders/scree_set.glsl, by the table at its top.
struct PackedSet {
    std::vector<Image> slope, extra, color, color_height;
    std::vector<Image> rank_b, rank_g, rank_r, color_slope_bg, color_slope_r;
    std::vector<Image> exponent; ///< none where the set has none
    std::vector<Image> map;      ///< one level; none where the set has no color map
};

PackedSet pack(const SampleSet& set);

/// The array texture of src/shaders/scree_visible.glsl, levels[level][layer].
std::vector<std::vector<Image>> pack(const VisibleTables& tables);

} // namespace scree::test
