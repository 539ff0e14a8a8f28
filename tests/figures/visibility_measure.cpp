#include "figures/visibility_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart/temp_folder.h"
#include "judge/picked_texels.h"
#include "pipeline/bake.h"

namespace scree::test {
namespace {

constexpr int kFootprintsOfSize = 16;
constexpr uint64_t kSeed = 6;

/// Samples along a side of a footprint: fewer where there are many footprints to average over.
constexpr int kGrid16 = 32, kGrid64 = 56, kGrid256 = 72, kGridMap = 224;

/// Footprints and their texels, of the sizes that are judged.
struct Picked {
    FootprintsOfSize footprints;
    std::vector<SetTexel> texels;
};

/// few  64x64 texels and the whole map
std::vector<Picked> pick(SetReader& set, bool few)
{
    const Manifest& manifest = set.manifest();
    const int last = reference::level_count(manifest.width, manifest.height) - 1;
    std::vector<Picked> sizes;
    struct Size {
        const char* name;
        int level, grid;
        bool among_few;
    };
    for (const auto& [name, level, grid, among_few] :
         {Size{"16", 4, kGrid16, false}, Size{"64", 6, kGrid64, true},
          Size{"256", 8, kGrid256, false}, Size{"map", last, kGridMap, true}})
        if ((level < last || name == std::string("map")) && (among_few || !few)) {
            Picked& of_size = sizes.emplace_back();
            of_size.footprints.name = name;
            of_size.footprints.grid = grid;
            for (PickedTexel& picked : pick_texels(set, level, kFootprintsOfSize, kSeed))
                if (picked.level == level) {
                    of_size.texels.push_back(picked.texel);
                    of_size.footprints.places.push_back(std::move(picked.footprint));
                }
        }
    return sizes;
}

/// Ways to tell the color, of one baked set.
struct JudgedSet {
    std::vector<ColorOfView> models;
    std::vector<Picked> sizes;
    double mean_color = 0; ///< rms of the map's, over R, G, B
};

double rms(const std::array<double, 3>& color)
{
    return std::sqrt((color[0] * color[0] + color[1] * color[1] + color[2] * color[2]) / 3);
}

/// What to bake.
struct SetPlan {
    std::vector<Map> maps;
    int nodes = kDefaultNodes;
    PixelTypeChoice type = PixelTypeChoice::automatic;
    bool few_footprints = false;
    bool axes = false; ///< instead of harmonics
};

JudgedSet bake_and_read(const Asset& asset, const SetPlan& plan)
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
    const VisibilityRecord& table = manifest.visibility.value();
    return {plan.axes ? std::vector{axes_color(table)} : colors_of_views(table),
            pick(reader, plan.few_footprints), rms(manifest.levels.back().mean_color.value())};
}

std::vector<JudgedSet> sets_of_models(const Asset& asset)
{
    return {bake_and_read(asset, {{Map::slope, Map::tail, Map::height, Map::color, Map::colorheight,
                                   Map::rank, Map::exponent, Map::visible}}),
            bake_and_read(asset, {{Map::slope, Map::color, Map::visible},
                                  kDefaultNodes,
                                  PixelTypeChoice::automatic,
                                  false,
                                  true})};
}

/// The mean color, tables of several numbers of nodes, of several pixel types, and ways between
/// four nodes.
std::vector<JudgedSet> sets_of_nodes(const Asset& asset)
{
    const std::vector<Map> maps = {Map::slope, Map::color, Map::visible};
    std::vector<JudgedSet> sets;
    auto add = [&](const SetPlan& plan, const std::string& name) {
        JudgedSet set = bake_and_read(asset, plan);
        const ColorOfView mean = set.models.front();
        ColorOfView table = set.models.back();
        table.name = name;
        set.models = {table};
        if (sets.empty())
            set.models = {mean, table};
        sets.push_back(std::move(set));
    };
    add({maps, 4, PixelTypeChoice::float32, true}, "4 nodes");
    add({maps, 4, PixelTypeChoice::half, true}, "4 nodes, half");
    for (const int nodes : {2, 3, 5, 6})
        add({maps, nodes, PixelTypeChoice::float32, true}, fmt::format("{} nodes", nodes));
    const VisibilityRecord four{best_node_angles(4), kMaxHarmonics, 8, {}};
    std::vector<ColorOfView>& of_four = sets.front().models;
    of_four.push_back(table_color_along(four, "4 nodes, by theta",
                                        [](double cosine) { return std::acos(cosine); }));
    of_four.push_back(
        table_color_along(four, "4 nodes, by cos theta", [](double cosine) { return -cosine; }));
    of_four.push_back(table_color_along(four, "4 nodes, by log cos theta",
                                        [](double cosine) { return -std::log(cosine); }));
    of_four.push_back(table_color_along(four, "4 nodes, by 1 / cos theta",
                                        [](double cosine) { return 1 / cosine; }));
    return sets;
}

} // namespace

SurfaceFigures measure(const Asset& asset, double slope, Comparison comparison,
                       const AllViews& views)
{
    const std::vector<JudgedSet> sets =
        comparison == Comparison::models ? sets_of_models(asset) : sets_of_nodes(asset);
    const reference::DisplacedSurface surface(asset.relief);
    SurfaceFigures figures{asset.name, slope, {}, {}};
    for (const JudgedSet& set : sets)
        for (const ColorOfView& model : set.models)
            figures.models.push_back(model.name);
    for (size_t size = 0; size < sets.front().sizes.size(); ++size) {
        const SeenOfSize seen = see(surface, sets.front().sizes[size].footprints, views);
        SizeFigures& of_size = figures.sizes.emplace_back();
        of_size.footprint = seen.name;
        of_size.noise = squares_of_noise(seen, views, sets.front().mean_color);
        for (const JudgedSet& set : sets)
            for (const ColorOfView& model : set.models)
                of_size.squares.push_back(
                    squares_of(model, set.sizes[size].texels, seen, views, set.mean_color));
    }
    return figures;
}

} // namespace scree::test
