#include "judge/picked_texels.h"

#include <algorithm>
#include <set>
#include <utility>

namespace scree {

namespace {

/// A well-mixed function of its argument (SplitMix64, Steele et al. 2014).
uint64_t mixed(uint64_t x)
{
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// Places (y, x) in a level, sorted.
std::set<std::pair<int, int>> places(int width, int height, int level, int count, uint64_t seed)
{
    std::set<std::pair<int, int>> picked;
    const auto texels = static_cast<long long>(width) * height;
    if (texels <= count) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                picked.insert({y, x});
        return picked;
    }
    for (uint64_t i = 0; static_cast<int>(picked.size()) < count; ++i) {
        const uint64_t hash = mixed(mixed(seed + static_cast<uint64_t>(level)) + i);
        const auto place = static_cast<long long>(hash % static_cast<uint64_t>(texels));
        picked.insert({static_cast<int>(place / width), static_cast<int>(place % width)});
    }
    return picked;
}

} // namespace

std::vector<PickedTexel> pick_texels(SetReader& set, int first_level, int count, uint64_t seed)
{
    const int width = set.manifest().width, height = set.manifest().height;
    std::vector<PickedTexel> texels;
    for (int level = first_level; level < reference::level_count(width, height); ++level) {
        std::vector<SetTexel> row;
        int row_y = -1;
        for (const auto& [y, x] :
             places(reference::level_size(width, level), reference::level_size(height, level),
                    level, count, seed)) {
            if (y != row_y)
                row = set.row(level, y);
            row_y = y;
            const SetTexel& texel = row[static_cast<size_t>(x)];
            if (texel.coverage > 0)
                texels.push_back(
                    {level, x, y, texel, reference::footprint_of(width, height, level, x, y)});
        }
    }
    return texels;
}

} // namespace scree
