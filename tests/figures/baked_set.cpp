#include "figures/baked_set.h"

#include <array>
#include <cmath>
#include <utility>

#include "chart/temp_folder.h"
#include "judge/picked_texels.h"
#include "pipeline/bake.h"

namespace scree::test {
namespace {

constexpr int kFootprintsOfSize = 16;
constexpr uint64_t kSeed = 6;
constexpr int kWholeMap = -1;

std::vector<PickedSize> pick(SetReader& set, const std::vector<SizePlan>& sizes)
{
    const Manifest& manifest = set.manifest();
    const int last = reference::level_count(manifest.width, manifest.height) - 1;
    std::vector<PickedSize> all;
    for (const SizePlan& size : sizes) {
        if (size.level >= last)
            continue;
        const int level = size.level == kWholeMap ? last : size.level;
        PickedSize& of_size = all.emplace_back();
        of_size.footprints.name = size.name;
        of_size.footprints.grid = size.grid;
        for (PickedTexel& picked : pick_texels(set, level, kFootprintsOfSize, kSeed))
            if (picked.level == level) {
                of_size.texels.push_back(picked.texel);
                of_size.footprints.places.push_back(std::move(picked.footprint));
            }
    }
    return all;
}

double rms(const std::array<double, 3>& color)
{
    return std::sqrt((color[0] * color[0] + color[1] * color[1] + color[2] * color[2]) / 3);
}

} // namespace

SizePlan map_size(int grid) { return {"map", kWholeMap, grid}; }

BakedSet bake_and_pick(const Asset& asset, const SetPlan& plan)
{
    const TempFolder folder;
    BakeOptions options = asset.options;
    options.output = folder.path() / "set";
    options.maps = plan.maps;
    options.pixel_type = plan.type;
    options.table = {best_node_angles(plan.nodes), plan.axes ? 0 : kMaxHarmonics, 8, plan.axes};
    Manifest start;
    start.name = asset.name;
    AssetSource source(asset);
    bake(source, options, start);

    SetReader reader(options.output);
    const Manifest& manifest = reader.manifest();
    return {manifest.visibility.value(), pick(reader, plan.sizes),
            rms(manifest.levels.back().mean_color.value())};
}

} // namespace scree::test
