#include "figures/slope_truth.h"

#include "chart/temp_folder.h"
#include "judge/picked_texels.h"
#include "pipeline/bake.h"

namespace scree::test {
namespace {

constexpr int kFootprintsOfSize = 16;
constexpr uint64_t kSeed = 6;

filter::Slopes<double> slopes_in_double(const SetTexel& texel)
{
    const auto& [s, ss, st, t, tt] = texel.slope;
    return filter::slopes<double>({static_cast<double>(s), static_cast<double>(ss),
                                   static_cast<double>(st), static_cast<double>(t),
                                   static_cast<double>(tt)},
                                  static_cast<double>(texel.tau));
}

/// Footprints of a size, and the grid of samples of each: finer where there are few of them.
struct Picked {
    SlopesOfSize size;
    int grid = 1;
};

std::vector<Picked> pick(SetReader& set)
{
    const Manifest& manifest = set.manifest();
    const int last = reference::level_count(manifest.width, manifest.height) - 1;
    struct Size {
        const char* name;
        int level, grid;
    };
    std::vector<Picked> sizes;
    for (const auto& [name, level, grid] :
         {Size{"16", 4, 32}, Size{"64", 6, 56}, Size{"map", last, 192}}) {
        Picked& of_size = sizes.emplace_back();
        of_size.size.name = name;
        of_size.grid = grid;
        for (PickedTexel& picked : pick_texels(set, level, kFootprintsOfSize, kSeed))
            if (picked.level == level) {
                of_size.size.baked.push_back(slopes_in_double(picked.texel));
                of_size.size.places.push_back(std::move(picked.footprint));
            }
    }
    return sizes;
}

std::vector<Picked> bake_and_pick(const Asset& asset)
{
    const TempFolder folder;
    BakeOptions options = asset.options;
    options.output = folder.path() / "set";
    options.maps = {Map::slope, Map::tail};
    Manifest start;
    start.name = asset.name;
    AssetSource source(asset);
    bake(source, options, start);
    SetReader reader(options.output);
    return pick(reader);
}

} // namespace

reference::DisplacedSurface white_and_gray(const Asset& asset)
{
    reference::Relief relief = asset.relief;
    double mean = 0;
    for (reference::Rgb& color : relief.colors) {
        color = {1, 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2], 0};
        mean += color[1] / static_cast<double>(relief.colors.size());
    }
    for (reference::Rgb& color : relief.colors)
        color[1] /= mean;
    return reference::DisplacedSurface(std::move(relief));
}

std::vector<SlopesOfSize> see_slopes(const Asset& asset, const reference::DisplacedSurface& surface,
                                     const SlopeViews& views)
{
    std::vector<SlopesOfSize> all;
    for (Picked& picked : bake_and_pick(asset)) {
        SlopesOfSize& size = all.emplace_back(std::move(picked.size));
        reference::GatherPlan plan;
        plan.grid = picked.grid;
        plan.views = views.fitted;
        size.fitted = reference::gather_all(surface, size.places, plan);
        plan.views = views.judged;
        plan.lights = views.lights;
        for (size_t base = 0; base < kBaseAlphas.size(); ++base) {
            plan.base_alpha = kBaseAlphas[base];
            size.judged[base] = reference::gather_all(surface, size.places, plan);
        }
    }
    return all;
}

} // namespace scree::test
