#include "pipeline/map_survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/tile_borders.h"

namespace scree {

namespace {

/// A mesh without texels in its charts is none of these maps'.
void weigh_alike(const BakedMaps& maps)
{
    double largest = 0;
    for (const auto& map : maps)
        if (map->mesh() != nullptr)
            largest = std::max(largest, map->mesh()->largest_area());
    for (const auto& map : maps)
        if (map->mesh() != nullptr)
            map->mesh()->weigh_by(largest);
}

BorderedMap bordered(const BakedMap& map)
{
    BorderedMap bordered{map.tile(), map.source().width(), map.source().height(), map.found.edges};
    if (map.mesh() != nullptr)
        for (const Side side : kSides) {
            bordered.edges[side].place = map.mesh()->edges()[side].place;
            bordered.edges[side].reach = map.mesh()->edges()[side].reach;
        }
    return bordered;
}

bool has_holes(const Surroundings& around)
{
    const auto has = [](const std::vector<double>& heights) {
        return std::any_of(heights.begin(), heights.end(), [](double h) { return std::isnan(h); });
    };
    return has(around.left) || has(around.right) || has(around.above) || has(around.below);
}

void let_borders_meet(const BakedMaps& maps, const BakeOptions& options)
{
    std::vector<BorderedMap> all;
    all.reserve(maps.size());
    for (const auto& map : maps)
        all.push_back(bordered(*map));
    for (size_t i = 0; i < maps.size(); ++i) {
        Survey& found = maps[i]->found;
        found.around = surroundings_of(all[i], all, options.wrap_s == Wrap::periodic,
                                       options.wrap_t == Wrap::periodic);
        found.has_holes = found.has_holes || has_holes(*found.around);
    }
}

void drop_empty(BakedMaps& maps, std::vector<std::string>& warnings)
{
    const auto is_empty = [](const auto& map) { return !(map->found.weight > 0); };
    if (std::all_of(maps.begin(), maps.end(), is_empty))
        refuse_without_data(maps.front()->source());
    for (const auto& map : maps)
        if (is_empty(map))
            warnings.push_back(fmt::format("tile {}: {} has no data in any texel; left out",
                                           map->number(), map->name()));
    maps.erase(std::remove_if(maps.begin(), maps.end(), is_empty), maps.end());
}

} // namespace

void survey_maps(BakedMaps& maps, const BakeOptions& options, const BakeMonitor& monitor,
                 std::vector<std::string>& warnings)
{
    weigh_alike(maps);
    const MapMonitors monitors(monitor, maps.size());
    for_each_map(widths_of(maps), [&](size_t map) {
        maps[map]->found = survey_if_any(maps[map]->source(), monitors.of(map));
        maps[map]->source().rest();
    });
    drop_empty(maps, warnings);
    std::vector<Survey*> surveys;
    surveys.reserve(maps.size());
    for (const auto& map : maps)
        surveys.push_back(&map->found);
    unite(surveys, texel_areas(maps));
    const bool has_heights = maps.front()->source().has_heights();
    if (has_heights && (maps.front()->mesh() != nullptr || options.udim_wrap))
        let_borders_meet(maps, options);
}

std::vector<double> texel_areas(const BakedMaps& maps)
{
    std::vector<double> areas;
    areas.reserve(maps.size());
    for (const auto& map : maps)
        areas.push_back(1.0 / map->source().width() / map->source().height());
    return areas;
}

std::vector<int> widths_of(const BakedMaps& maps)
{
    std::vector<int> widths;
    widths.reserve(maps.size());
    for (const auto& map : maps)
        widths.push_back(map->source().width());
    return widths;
}

} // namespace scree
