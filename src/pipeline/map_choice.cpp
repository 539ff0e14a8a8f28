#include "pipeline/map_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "math/error.h"
#include "pipeline/texture_values.h"

namespace scree {

namespace {

/// Which ways color may follow the view; a choice is made among them later where there are several.
struct Ways {
    bool smith, corrected, tables;
};

Ways ways_of(const BakeOptions& options)
{
    if (!options.visibility)
        return {true, options.auto_maps, options.auto_maps};
    // With `auto` the named way may be taken, and what is plainer.
    const Visibility given = *options.visibility;
    return {given == Visibility::smith || options.auto_maps,
            given == Visibility::corrected || (options.auto_maps && given == Visibility::tables),
            given == Visibility::tables};
}

std::vector<Map> all_maps(const Source& source, const BakeOptions& options, bool has_color)
{
    const Ways ways = ways_of(options);
    const bool has_heights = source.has_heights();
    std::vector<Map> maps = {Map::slope, Map::tail};
    auto add_if = [&maps](bool condition, std::initializer_list<Map> more) {
        if (condition)
            maps.insert(maps.end(), more);
    };
    add_if(has_heights, {Map::height});
    add_if(has_color, {Map::color});
    add_if(has_color && ways.smith, {Map::colorslope});
    add_if(has_color && has_heights && ways.smith, {Map::colorheight, Map::rank});
    add_if(has_color && has_heights && ways.corrected, {Map::colorheight, Map::exponent});
    add_if(has_color && has_heights && ways.tables, {Map::visible});
    add_if(!options.colormap_file.empty() && ways.smith, {Map::map});
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

/// What was asked for is not left out in silence. With `auto` it is one way of several.
void expect_inputs(const BakeOptions& options, const Source& source, bool has_color)
{
    if (!options.visibility || *options.visibility == Visibility::smith || options.auto_maps)
        return;
    if (!source.has_heights())
        throw Error(
            "--visibility: is measured on heights, and a normal map has none; give a height "
            "map, or --visibility smith");
    if (!has_color)
        throw Error("--visibility: tells the visible color, and there is none; give --color or "
                    "--colormap, or --visibility smith");
}

} // namespace

std::vector<Map> choose_maps(const Source& source, const BakeOptions& options, bool has_color,
                             bool complete)
{
    if (options.layout == Layout::bumpslopes)
        return {Map::bumpslopes};
    expect_inputs(options, source, has_color);
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

TableSizes tables_of(const std::vector<Map>& maps, const BakeOptions& options)
{
    TableSizes tables;
    tables.rank_terms = options.rank_terms;
    if (std::find(maps.begin(), maps.end(), Map::visible) == maps.end())
        return tables;
    tables.visibility = options.table;
    if (!options.auto_maps || options.table.axes)
        return tables;
    tables.tried = options.table;
    tables.tried.axes = true;
    return tables;
}

bool needs_views(const std::vector<Map>& maps, const BakeOptions& options)
{
    auto has = [&maps](Map map) { return std::find(maps.begin(), maps.end(), map) != maps.end(); };
    return has(Map::visible) || has(Map::exponent) ||
           (options.auto_maps && has(Map::height) && has(Map::color));
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
    // Models of color go by the slopes, too.
    set.slope = set.slope || views > 0 || ((set.color || has_table) && mapped_by_slope);
    return MomentLayout(set);
}

} // namespace scree
