#include "figures/light_measure.h"

#include "figures/baked_set.h"
#include "figures/light_joint.h"
#include "figures/light_ways.h"

namespace scree::test {
namespace {

constexpr uint64_t kJudgedSeed = 1, kFittedSeed = 2;

/// axes  only what a table along axes needs
SetPlan set_plan(bool axes)
{
    SetPlan plan;
    plan.maps = {Map::slope,       Map::tail,     Map::height, Map::color,
                 Map::colorheight, Map::exponent, Map::visible};
    if (axes)
        plan.maps = {Map::slope, Map::color, Map::visible};
    plan.axes = axes;
    plan.sizes = {{"16", 4, 24}, {"64", 6, 48}, map_size(128)};
    return plan;
}

/// Footprints of one size, as both sets have them.
struct SizeOfSets {
    const PickedSize& harmonics;
    const PickedSize& axes;
};

/// Sources x footprints.
std::vector<std::vector<DirectionColors>> colors_of(const std::vector<LightSource>& sources,
                                                    const SizeOfSets& sets, const LightPairs& pairs)
{
    std::vector<std::vector<DirectionColors>> all(sources.size());
    for (size_t source = 0; source < exact(sources); ++source) {
        const bool axes = source == along_axes(sources);
        for (const SetTexel& texel : axes ? sets.axes.texels : sets.harmonics.texels)
            all[source].push_back(table_colors(sources[source].table.value(), texel, pairs));
    }
    return all;
}

LightSizeFigures measure_size(const reference::DisplacedSurface& surface, const SizeOfSets& sets,
                              const std::vector<LightSource>& sources, double mean_color)
{
    const LightPairs judged = judged_pairs(), fitted = fitted_pairs();
    const PickedSize& size = sets.harmonics;
    const auto truth = light(surface, size.footprints, judged, kJudgedSeed);
    const auto examples = light(surface, size.footprints, fitted, kFittedSeed);
    auto colors = colors_of(sources, sets, judged);
    colors.back() = exact_colors(surface, size.footprints, judged, kJudgedSeed);
    const auto example_colors = colors_of(sources, sets, fitted);

    LightSizeFigures figures{size.footprints.name, {}, squares_of_noise(truth, judged, mean_color)};
    for (const LightWay& way : light_ways(sources))
        figures.squares.push_back(squares_of(
            [&](size_t i, size_t v, size_t l) {
                return way.color(pair_colors(size.texels[i], colors[way.source][i], judged, v, l));
            },
            truth, judged, mean_color));
    for (const JointForm& form : joint_forms(sources)) {
        const size_t source = form.base.source;
        const std::vector<JointNumbers> numbers =
            fitted_numbers(form, size.texels, example_colors[source], examples, fitted);
        figures.squares.push_back(squares_of(
            [&](size_t i, size_t v, size_t l) {
                return joint_color(form, numbers[i],
                                   pair_colors(size.texels[i], colors[source][i], judged, v, l));
            },
            truth, judged, mean_color));
    }
    return figures;
}

} // namespace

LightFigures measure_light(const Asset& asset, double slope)
{
    const BakedSet set = bake_and_pick(asset, set_plan(false));
    const BakedSet axes = bake_and_pick(asset, set_plan(true));
    const reference::DisplacedSurface surface(asset.relief);
    LightFigures figures{asset.name, slope, {}, {}};
    const std::vector<LightSource> sources = light_sources(set.visibility, axes.visibility);
    for (const LightWay& way : light_ways(sources))
        figures.ways.push_back({way.name, way.numbers, way.of_light_alone});
    for (const JointForm& form : joint_forms(sources))
        figures.ways.push_back({form.name, form.numbers(), form.of_light_alone});
    for (size_t i = 0; i < set.sizes.size(); ++i)
        figures.sizes.push_back(
            measure_size(surface, {set.sizes[i], axes.sizes[i]}, sources, set.mean_color));
    return figures;
}

} // namespace scree::test
