#include "judge/picked_texels.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <tuple>
#include <utility>

#include "reference/jitter.h"

namespace scree {

namespace {

/// Of drawing places, where many have no data.
constexpr uint64_t kRounds = 64;

using Place = std::pair<int, int>; // y, x

/// Places in a level that `seen` does not have yet, `count` of them or as many as there are, and
/// adds them to it.
std::set<Place> more_places(int width, int height, int count, uint64_t seed, std::set<Place>& seen)
{
    const auto texels = static_cast<size_t>(width) * static_cast<size_t>(height);
    std::set<Place> picked;
    for (uint64_t i = 0; picked.size() < static_cast<size_t>(count) && seen.size() < texels; ++i) {
        const uint64_t place = reference::scattered(reference::scattered(seed) + i) % texels;
        const Place at{static_cast<int>(place / static_cast<uint64_t>(width)),
                       static_cast<int>(place % static_cast<uint64_t>(width))};
        if (seen.insert(at).second)
            picked.insert(at);
    }
    return picked;
}

/// Rows are decoded by tiles: places sorted by row read each once.
void add_with_data(SetReader& set, int level, const std::set<Place>& places, size_t most,
                   std::vector<PickedTexel>& texels)
{
    const int width = set.manifest().width, height = set.manifest().height;
    std::vector<SetTexel> row;
    int row_y = -1;
    for (const auto& [y, x] : places) {
        if (texels.size() == most)
            return;
        if (y != row_y)
            row = set.row(level, y);
        row_y = y;
        const SetTexel& texel = row[static_cast<size_t>(x)];
        if (texel.coverage > 0)
            texels.push_back(
                {level, x, y, texel, reference::footprint_of(width, height, level, x, y)});
    }
}

} // namespace

std::vector<PickedTexel> pick_texels(SetReader& set, int first_level, int count, uint64_t seed)
{
    const int width = set.manifest().width, height = set.manifest().height;
    std::vector<PickedTexel> texels;
    for (int level = first_level; level < reference::level_count(width, height); ++level) {
        const int columns = reference::level_size(width, level);
        const int rows = reference::level_size(height, level);
        const size_t most = texels.size() + static_cast<size_t>(count);
        std::set<Place> seen;
        for (uint64_t round = 0; round < kRounds && texels.size() < most; ++round)
            add_with_data(set, level,
                          more_places(columns, rows, count,
                                      seed + static_cast<uint64_t>(level) + (round << 32), seen),
                          most, texels);
    }
    std::stable_sort(texels.begin(), texels.end(), [](const PickedTexel& a, const PickedTexel& b) {
        return std::tie(a.level, a.y) < std::tie(b.level, b.y);
    });
    return texels;
}

GatheredTexels gather_texels(const reference::DisplacedSurface& surface,
                             const std::vector<PickedTexel>& texels,
                             const reference::GatherPlan& plan,
                             const std::function<void(double)>& progress)
{
    std::vector<reference::Footprint> footprints;
    footprints.reserve(texels.size());
    for (const PickedTexel& texel : texels)
        footprints.push_back(texel.footprint);
    GatheredTexels gathered;
    const auto begin = std::chrono::steady_clock::now();
    gathered.truths = gather_all(surface, footprints, plan, progress);
    gathered.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (const reference::Estimate& truth : gathered.truths) {
        gathered.rays += truth.rays;
        gathered.samples += truth.samples;
    }
    return gathered;
}

} // namespace scree
