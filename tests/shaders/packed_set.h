#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/files.h"

namespace scree::test {

/// A built-in sample, baked in float32, and its maps as read back: levels, 0 the finest.
struct SampleSet {
    float world_width = 0, world_height = 0;
    std::vector<Image> slope, height, color, colorheight, tail;
};

SampleSet bake_sample(const std::string& kind, int width, int height);

/// The value of a channel by its name; fails the test when there is none.
float value(const Image& image, int x, int y, const std::string& channel);

/// The four textures of src/shaders/scree_set.glsl, by the table at its top.
struct PackedSet {
    std::vector<Image> slope, extra, color, color_height;
};

PackedSet pack(const SampleSet& set);

} // namespace scree::test
