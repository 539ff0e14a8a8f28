#include "figures/visibility_measure.h"

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
constexpr int kGrid16 = 24, kGrid64 = 40, kGrid256 = 80, kGridMap = 256;

/// Footprints and their texels, of the sizes that are judged.
struct Picked {
    FootprintsOfSize footprints;
    std::vector<SetTexel> texels;
};

std::vector<Picked> pick(SetReader& set)
{
    const Manifest& manifest = set.manifest();
    const int last = reference::level_count(manifest.width, manifest.height) - 1;
    std::vector<Picked> sizes;
    for (const auto& [name, level, grid] : {std::tuple{"16", 4, kGrid16},
                                            {"64", 6, kGrid64},
                                            {"256", 8, kGrid256},
                                            {"map", last, kGridMap}})
        if (level < last || std::string(name) == "map") {
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

JudgedSet bake_and_read(const Asset& asset, std::vector<Map> maps, int nodes)
{
    const TempFolder folder;
    BakeOptions options = asset.options;
    options.output = folder.path() / "set";
    options.maps = std::move(maps);
    options.table = {best_node_angles(nodes), kMaxHarmonics, 8};
    Manifest start;
    start.name = asset.name;
    AssetSource source(asset);
    bake(source, options, start);

    SetReader reader(options.output);
    const Manifest& manifest = reader.manifest();
    return {colors_of_views(manifest.visibility.value()), pick(reader),
            rms(manifest.levels.back().mean_color.value())};
}

std::vector<JudgedSet> sets_of_models(const Asset& asset)
{
    return {bake_and_read(asset,
                          {Map::slope, Map::tail, Map::height, Map::color, Map::colorheight,
                           Map::rank, Map::exponent, Map::visible},
                          kDefaultNodes)};
}

/// The mean color, tables of several numbers of nodes, and ways between four nodes.
std::vector<JudgedSet> sets_of_nodes(const Asset& asset)
{
    std::vector<JudgedSet> sets;
    for (const int nodes : {2, 3, 4, 5, 6}) {
        JudgedSet set = bake_and_read(asset, {Map::slope, Map::color, Map::visible}, nodes);
        const ColorOfView mean = set.models.front(), table = set.models.back();
        set.models = {table};
        if (sets.empty())
            set.models = {mean, table};
        sets.push_back(std::move(set));
    }
    const VisibilityRecord four{best_node_angles(4), kMaxHarmonics, 8};
    std::vector<ColorOfView>& of_four = sets[2].models;
    of_four.push_back(
        table_color_along(four, "4, by theta", [](double cosine) { return std::acos(cosine); }));
    of_four.push_back(
        table_color_along(four, "4, by cos theta", [](double cosine) { return -cosine; }));
    of_four.push_back(table_color_along(four, "4, by log cos theta",
                                        [](double cosine) { return -std::log(cosine); }));
    of_four.push_back(
        table_color_along(four, "4, by 1 / cos theta", [](double cosine) { return 1 / cosine; }));
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
