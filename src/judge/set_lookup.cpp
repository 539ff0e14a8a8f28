#include "judge/set_lookup.h"

#include <array>
#include <cassert>

namespace scree {

SetLookup::SetLookup(const std::filesystem::path& set, const TextureFilter& filter)
    : reader_(set), textures_(reader_.folder(), reader_.manifest(), filter)
{}

SetTexel SetLookup::at(const TexturePlace& place) const
{
    constexpr size_t kMostChannels = 24; // a rank table of eight terms
    SetTexel texel;
    if (!textures_.has(Map::color))
        texel.color = {1, 1, 1};
    std::array<float, kMostChannels> values;
    for (const TextureRecord& record : manifest().textures) {
        if (record.map == Map::map) // a table, not a map: SetColors has it
            continue;
        const int count = textures_.channels(record.map);
        assert(static_cast<size_t>(count) <= kMostChannels);
        textures_.read(record.map, place, 0, count, values.data());
        put_channels(texel, record.map, values.data(), static_cast<size_t>(count));
    }
    return texel;
}

} // namespace scree
