#include "judge/set_texel.h"

#include <algorithm>

namespace scree {

namespace {

/// Where channel `i` of a map belongs in a texel; null: nowhere.
///
/// terms  of a rank table
float* place(SetTexel& texel, Map map, size_t i, size_t terms)
{
    // Of three colors that sort B G R, as maps of several numbers a color do.
    const size_t per_color = map == Map::rank ? terms : 2;
    const size_t blue_first = 2 - std::min<size_t>(i / per_color, 2);
    switch (map) {
    case Map::slope: {
        auto& [s, ss, st, t, tt] = texel.slope;
        const std::array<float*, 5> all{&s, &ss, &st, &t, &tt};
        return all[i];
    }
    case Map::height:
        return i == 0 ? &texel.h : &texel.hh;
    case Map::color:
        return &texel.color[i];
    case Map::colorheight:
        return &texel.color_height[i];
    case Map::exponent:
        return &texel.exponent[i];
    case Map::colorslope:
        return i % 2 == 0 ? &texel.color_s[blue_first] : &texel.color_t[blue_first];
    case Map::rank:
        return &texel.rank[i % terms][blue_first];
    case Map::visible:
        return &texel.visible[i];
    case Map::tail:
        return &texel.tau;
    case Map::coverage:
        return &texel.coverage;
    case Map::bumpslopes: {
        auto& [s, ss, st, t, tt] = texel.slope;
        const std::array<float*, 6> all{&texel.world_height, &s, &t, &ss, &tt, &st};
        return all[i];
    }
    case Map::map:
        break;
    }
    return nullptr;
}

} // namespace

void put_channels(SetTexel& texel, Map map, const float* values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (float* of_texel = place(texel, map, i, count / 3))
            *of_texel = values[i];
}

} // namespace scree
