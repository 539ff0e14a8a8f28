#include "figures/visibility_measure.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "figures/baked_set.h"

namespace scree::test {
namespace {

/// Samples along a side of a footprint: fewer where there are many footprints to average over.
std::vector<SizePlan> all_sizes()
{
    return {{"16", 4, 32}, {"64", 6, 56}, {"256", 8, 72}, map_size(224)};
}

std::vector<SizePlan> few_sizes() { return {{"64", 6, 56}, map_size(224)}; }

/// Ways to tell the color, of one baked set.
struct JudgedSet {
    std::vector<ColorOfView> models;
    BakedSet set;
};

JudgedSet judged(const Asset& asset, const SetPlan& plan)
{
    BakedSet set = bake_and_pick(asset, plan);
    return {plan.axes ? std::vector{axes_color(set.visibility)} : colors_of_views(set.visibility),
            std::move(set)};
}

std::vector<JudgedSet> sets_of_models(const Asset& asset)
{
    SetPlan plan;
    plan.maps = {Map::slope,       Map::tail, Map::height,   Map::color,
                 Map::colorheight, Map::rank, Map::exponent, Map::visible};
    plan.sizes = all_sizes();
    std::vector<JudgedSet> sets;
    sets.push_back(judged(asset, plan));
    plan.maps = {Map::slope, Map::color, Map::visible};
    plan.axes = true;
    sets.push_back(judged(asset, plan));
    return sets;
}

/// The mean color, tables of several numbers of nodes, of several pixel types, and ways between
/// four nodes.
std::vector<JudgedSet> sets_of_nodes(const Asset& asset)
{
    std::vector<JudgedSet> sets;
    auto add = [&](int nodes, PixelTypeChoice type, const std::string& name) {
        JudgedSet set = judged(
            asset, {{Map::slope, Map::color, Map::visible}, nodes, type, few_sizes(), false});
        const ColorOfView mean = set.models.front();
        ColorOfView table = set.models.back();
        table.name = name;
        set.models = {table};
        if (sets.empty())
            set.models = {mean, table};
        sets.push_back(std::move(set));
    };
    add(4, PixelTypeChoice::float32, "4 nodes");
    add(4, PixelTypeChoice::half, "4 nodes, half");
    for (const int nodes : {2, 3, 5, 6})
        add(nodes, PixelTypeChoice::float32, fmt::format("{} nodes", nodes));
    const VisibilityRecord four = sets.front().set.visibility;
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
    const BakedSet& first = sets.front().set;
    for (size_t size = 0; size < first.sizes.size(); ++size) {
        const SeenOfSize seen = see(surface, first.sizes[size].footprints, views);
        SizeFigures& of_size = figures.sizes.emplace_back();
        of_size.footprint = seen.name;
        of_size.noise = squares_of_noise(seen, views, first.mean_color);
        for (const JudgedSet& judged : sets)
            for (const ColorOfView& model : judged.models)
                of_size.squares.push_back(squares_of(model, judged.set.sizes[size].texels, seen,
                                                     views, judged.set.mean_color));
    }
    return figures;
}

} // namespace scree::test
