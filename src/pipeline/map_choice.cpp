#include "pipeline/map_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "pipeline/texture_values.h"

namespace scree {

namespace {

/// Tables of visibility stand for the other ways that color follows the view.
std::vector<Map> all_maps(const Source& source, const BakeOptions& options, bool has_color)
{
    const bool sees = options.visibility == Visibility::tables;
    std::vector<Map> maps = {Map::slope, Map::tail};
    if (source.has_heights())
        maps.push_back(Map::height);
    if (has_color)
        maps.push_back(Map::color);
    if (has_color && sees)
        maps.push_back(Map::visible);
    if (has_color && !sees)
        maps.push_back(Map::colorslope);
    if (has_color && !sees && source.has_heights())
        maps.insert(maps.end(), {Map::colorheight, Map::rank});
    if (!options.colormap_file.empty() && !sees)
        maps.push_back(Map::map);
    return maps;
}

void expect_inputs(Map map, const Source& source, const BakeOptions& options, bool has_color)
{
    const std::string& name = map_info(map).name;
    MomentSet needs;
    require_moments(map, {options.rank_terms, options.table}, needs);
    if ((needs.height || map == Map::visible) && !source.has_heights())
        throw Error(fmt::format("--maps {}: needs heights, and a normal map has none", name));
    if (needs.color && !has_color)
        throw Error(fmt::format("--maps {}: needs a color; give --color or --colormap", name));
    if (map == Map::map && options.colormap_file.empty())
        throw Error(fmt::format("--maps {}: is the table of a color map; give --colormap", name));
}

} // namespace

std::vector<Map> choose_maps(const Source& source, const BakeOptions& options, bool has_color,
                             bool complete)
{
    if (options.layout == Layout::bumpslopes)
        return {Map::bumpslopes};
    std::vector<Map> maps =
        options.maps.empty() ? all_maps(source, options, has_color) : options.maps;
    for (const Map map : maps)
        expect_inputs(map, source, options, has_color);
    if (!complete)
        maps.push_back(Map::coverage);
    std::sort(maps.begin(), maps.end());
    maps.erase(std::unique(maps.begin(), maps.end()), maps.end());
    return maps;
}

VisibilityPlan table_of(const std::vector<Map>& maps, const BakeOptions& options)
{
    const bool has_table = std::find(maps.begin(), maps.end(), Map::visible) != maps.end();
    return has_table ? options.table : VisibilityPlan();
}

MomentLayout moments_for(const std::vector<Map>& maps, const TableSizes& tables, int views,
                         const Source& source, const BakeOptions& options)
{
    MomentSet set;
    set.slope = false;
    for (const Map map : maps)
        require_moments(map, tables, set);
    set.views = views;
    set.height = set.height && source.has_heights();
    const bool mapped_by_slope = !options.colormap_file.empty() && options.map_by != MapBy::height;
    const bool has_table = std::find(maps.begin(), maps.end(), Map::map) != maps.end();
    set.slope = set.slope || ((set.color || has_table) && mapped_by_slope);
    return MomentLayout(set);
}

} // namespace scree
