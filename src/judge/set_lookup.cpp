#include "judge/set_lookup.h"

#include <array>
#include <cassert>

namespace scree {

namespace {

constexpr size_t kMostChannels = kMostVisibleChannels;

/// Whether looking up by a model of color takes a map: those of other models it does not.
bool is_needed(Map map, ColorModel model, const SetColors& colors)
{
    switch (map) {
    case Map::map: // a table, which SetColors has
        return false;
    case Map::colorheight:
        return model == ColorModel::height || model == ColorModel::exponent;
    case Map::exponent:
        return model == ColorModel::exponent;
    case Map::rank:
        return model == ColorModel::rank;
    case Map::visible:
        return model == ColorModel::visible;
    case Map::colorslope:
        return colors.adds_slope(model);
    default:
        return true;
    }
}

} // namespace

SetLookup::SetLookup(const std::filesystem::path& set, const TextureFilter& filter, int tile)
    : reader_(set, tile), textures_(reader_.folder(), reader_.manifest(), filter)
{
    for (const TextureRecord& record : manifest().textures)
        if (is_needed(record.map, colors().best(), colors()))
            maps_.push_back(record.map);
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
