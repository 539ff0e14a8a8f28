#include "texset/channels.h"

#include <algorithm>

#include "math/error.h"

namespace scree {

const std::vector<MapInfo>& map_table()
{
    static const std::vector<MapInfo> table = {
        {Map::slope,
         "slope",
         {"s", "ss", "st", "t", "tt"},
         "raw moments of the slope (dh/ds, dh/dt): E[s] E[ss] E[st] E[t] E[tt]"},
        {Map::height,
         "height",
         {"h", "hh"},
         "raw moments of the normalised height hn = (h - h0) / h1: E[hn] E[hn hn]"},
        {Map::color, "color", {"R", "G", "B"}, "mean scene-linear color E[c]"},
        {Map::colorheight,
         "colorheight",
         {"R", "G", "B"},
         "E[c hn], color times normalised height, per color channel"},
        {Map::exponent,
         "exponent",
         {"gain", "power", "threshold"},
         "exponent for color by height as measured, in place of Smith's Lambda: gain max(Lambda - "
         "threshold, 0)^power, Lambda of the raw second moments of the slope"},
        {Map::colorslope,
         "colorslope",
         {"Bs", "Bt", "Gs", "Gt", "Rs", "Rt"},
         "E[c s] and E[c t], color times slope, per color channel"},
        {Map::rank, "rank", rank_channels(kDefaultRankTerms),
         "color by height rank q in the footprint: a_n = (2n+1) E[c P_n(2q-1)], per color channel"},
        {Map::visible, "visible", visible_channels(kDefaultNodes, 0),
         "what views see, over cos theta, more than the mean: A = E[V W] / cos theta - 1, and per "
         "color channel E[c V W] / cos theta - E[c]; at each node, by harmonics of the azimuth "
         "or along two axes"},
        {Map::map,
         "map",
         {"R", "G", "B"},
         "color map averaged over a normal law: columns mean, rows sqrt of the deviation"},
        {Map::tail, "tail", {"tau"}, "weight of the K0 slope distribution, 0 Gaussian to 1 K0"},
        {Map::coverage, "coverage", {"w"}, "share of the texel's footprint that has data"},
        {Map::bumpslopes,
         "bumpslopes",
         {"b0_h", "b1_dhds", "b2_dhdt", "b3_dhds2", "b4_dhdt2", "b5_dh2dsdt"},
         "height and raw moments of the slope, laid out as maketx --bumpslopes does"},
    };
    return table;
}

std::vector<std::string> rank_channels(int terms)
{
    std::vector<std::string> names;
    for (const char* color : {"B", "G", "R"})
        for (int n = 1; n <= terms; ++n)
            names.push_back(color + std::to_string(n));
    return names;
}

namespace {

/// Four channels of every term of every node.
std::vector<std::string> channels_of_nodes(int nodes, const std::vector<std::string>& terms)
{
    std::vector<std::string> names;
    for (int node = 1; node <= nodes; ++node)
        for (const std::string& term : terms)
            for (const char* channel : {"A", "B", "G", "R"})
                names.push_back(std::to_string(node) + term + channel);
    return names;
}

} // namespace

std::vector<std::string> visible_channels(int nodes, int harmonics)
{
    std::vector<std::string> terms = {""};
    for (const char* wave : {"c", "s"})
        for (int h = 1; h <= harmonics; ++h)
            terms.push_back(wave + std::to_string(h));
    return channels_of_nodes(nodes, terms);
}

std::vector<std::string> visible_channels_along_axes(int nodes)
{
    return channels_of_nodes(nodes, {"", "xn", "xp", "yn", "yp"});
}

const MapInfo& map_info(Map map)
{
    const auto& table = map_table();
    return *std::find_if(table.begin(), table.end(),
                         [map](const MapInfo& info) { return info.map == map; });
}

namespace {

bool is_for_users(Map map) { return map != Map::coverage && map != Map::bumpslopes; }

} // namespace

Map map_named(const std::string& name)
{
    for (const MapInfo& info : map_table())
        if (info.name == name && is_for_users(info.map))
            return info.map;
    throw Error("--maps: no map is called '" + name + "'; the maps are " + map_names());
}

std::string map_names()
{
    std::string names;
    for (const MapInfo& info : map_table())
        if (is_for_users(info.map))
            names += (names.empty() ? "" : ",") + info.name;
    return names;
}

} // namespace scree
