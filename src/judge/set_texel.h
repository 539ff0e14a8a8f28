#pragma once

#include <array>

#include "kernel/filter.h"
#include "math/vec.h"
#include "texset/channels.h"

namespace scree {

/// All that a set knows of one texel of one level, as a renderer reads it; what was not baked is 0.
struct SetTexel {
    std::array<float, 3> color{};
    filter::SlopeMoments<float> slope;
    float tau = 0;
    float h = 0, hh = 0; ///< E[hn], E[hn hn]
    std::array<float, 3> color_height{};
    std::array<float, 3> exponent{1, 1, 0}; ///< gain, power, threshold
    std::array<float, 3> color_s{}, color_t{};
    std::array<std::array<float, 3>, 8> rank{};        ///< a_1 .. a_8
    std::array<float, kMostVisibleChannels> visible{}; ///< in the order of the file
    float coverage = 1;
    float world_height = 0; ///< mean, world units; of the bumpslopes layout
};

/// Puts the channels of a map, in the order of its file, where they belong in a texel; a color
/// map's table has no place in it.
void put_channels(SetTexel& texel, Map map, const float* values, size_t count);

} // namespace scree
