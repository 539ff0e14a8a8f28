#include "pipeline/map_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "pipeline/texture_values.h"

namespace scree {

namespace {

std::vector<Map> all_maps(const Source& source, bool has_color, bool has_table)
{
    std::vector<Map> maps = {Map::slope, Map::tail};
    if (source.has_heights())
        maps.push_back(Map::height);
    if (has_color)
        maps.insert(maps.end(), {Map::color, Map::colorslope});
    if (has_color && source.has_heights())
        maps.insert(maps.end(), {Map::colorheight, Map::rank});
    if (has_table)
        maps.push_back(Map::map);
    return maps;
}

void expect_inputs(Map map, const Source& source, const BakeOptions& options, bool has_color)
{
    const std::string& name = map_info(map).name;
    MomentSet needs;
    require_moments(map, options.rank_terms, needs);
    if (needs.height && !source.has_heights())
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
    std::vector<Map> maps = options.maps.empty()
                                ? all_maps(source, has_color, !options.colormap_file.empty())
                                : options.maps;
    for (const Map map : maps)
        expect_inputs(map, source, options, has_color);
    if (!complete)
        maps.push_back(Map::coverage);
    std::sort(maps.begin(), maps.end());
    maps.erase(std::unique(maps.begin(), maps.end()), maps.end());
    return maps;
}

MomentLayout moments_for(const std::vector<Map>& maps, int rank_terms, const Source& source,
                         const BakeOptions& options)
{
    MomentSet set;
    set.slope = false;
    for (const Map map : maps)
        require_moments(map, rank_terms, set);
    set.height = set.height && source.has_heights();
    const bool mapped_by_slope = !options.colormap_file.empty() && options.map_by != MapBy::height;
    const bool has_table = std::find(maps.begin(), maps.end(), Map::map) != maps.end();
    set.slope = set.slope || ((set.color || has_table) && mapped_by_slope);
    return MomentLayout(set);
}

} // namespace scree
