#include "shaders/packed_set.h"

#include <array>

namespace scree::test {

namespace {

/// Four channels of one map or two; no name: 0.
struct From {
    const std::vector<Image>* map;
    std::string channel;
};

std::vector<Image> packed(const std::array<From, 4>& channels)
{
    std::vector<Image> levels;
    for (size_t l = 0; l < channels[0].map->size(); ++l) {
        const Image& first = (*channels[0].map)[l];
        Image level{first.width, first.height, {"R", "G", "B", "A"}, {}};
        for (int y = 0; y < level.height; ++y)
            for (int x = 0; x < level.width; ++x)
                for (const From& from : channels)
                    level.pixels.push_back(
                        from.channel.empty() ? 0 : value((*from.map)[l], x, y, from.channel));
        levels.push_back(std::move(level));
    }
    return levels;
}

} // namespace

PackedSet pack(const SampleSet& set)
{
    const auto of = [](const std::vector<Image>& map, const std::array<const char*, 4>& names) {
        return packed({From{&map, names[0]}, From{&map, names[1]}, From{&map, names[2]},
                       From{&map, names[3]}});
    };
    PackedSet out;
    out.slope = of(set.slope, {"s", "t", "ss", "tt"});
    out.extra = packed({From{&set.slope, "st"}, From{&set.height, "h"}, From{&set.height, "hh"},
                        From{&set.tail, "tau"}});
    out.color = of(set.color, {"R", "G", "B", ""});
    out.color_height = of(set.colorheight, {"R", "G", "B", ""});
    out.rank_b = of(set.rank, {"B1", "B2", "B3", "B4"});
    out.rank_g = of(set.rank, {"G1", "G2", "G3", "G4"});
    out.rank_r = of(set.rank, {"R1", "R2", "R3", "R4"});
    out.color_slope_bg = of(set.colorslope, {"Bs", "Bt", "Gs", "Gt"});
    out.color_slope_r = of(set.colorslope, {"Rs", "Rt", "", ""});
    if (!set.exponent.empty())
        out.exponent = of(set.exponent, {"gain", "power", "threshold", ""});
    if (set.map.width > 0)
        out.map = of({set.map}, {"R", "G", "B", ""});
    return out;
}

std::vector<std::vector<Image>> pack(const VisibleTables& tables)
{
    std::vector<std::vector<Image>> out(tables.levels.size());
    const auto channels =
        visible_channels(static_cast<int>(tables.cosines.size()), tables.harmonics);
    for (size_t i = 0; i < channels.size(); i += 4) { // A B G R
        const auto layers =
            packed({From{&tables.levels, channels[i + 3]}, From{&tables.levels, channels[i + 2]},
                    From{&tables.levels, channels[i + 1]}, From{&tables.levels, channels[i]}});
        for (size_t level = 0; level < layers.size(); ++level)
            out[level].push_back(layers[level]);
    }
    return out;
}

} // namespace scree::test
