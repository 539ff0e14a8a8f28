#include "judge/set_lookup.h"

#include <array>
#include <cassert>

namespace scree {

namespace {

constexpr size_t kMostChannels = 24; // of a rank table of eight terms

} // namespace

SetLookup::SetLookup(const std::filesystem::path& set, const TextureFilter& filter)
    : reader_(set), textures_(reader_.folder(), reader_.manifest(), filter)
{
    const ColorModel model = colors().best();
    for (const TextureRecord& record : manifest().textures) {
        const Map map = record.map;
        const bool is_left_out = map == Map::map || // a table, which SetColors has
                                 (map == Map::colorheight && model != ColorModel::height) ||
                                 (map == Map::rank && model != ColorModel::rank) ||
                                 (map == Map::colorslope && !colors().adds_slope(model));
        if (!is_left_out)
            maps_.push_back(map);
    }
}

SetTexel SetLookup::at(const TexturePlace& place) const
{
    SetTexel texel;
    if (!textures_.has(Map::color))
        texel.color = {1, 1, 1};
    std::array<float, kMostChannels> values{};
    for (const Map map : maps_) {
        const int count = textures_.channels(map);
        assert(static_cast<size_t>(count) <= kMostChannels);
        textures_.read(map, place, 0, count, values.data());
        put_channels(texel, map, values.data(), static_cast<size_t>(count));
    }
    return texel;
}

} // namespace scree
