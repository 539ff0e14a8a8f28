#include "pipeline/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/color_table.h"
#include "texset/udim.h"
#include "version.h"

namespace scree {

namespace {

constexpr double kRadian = 0.017453292519943295769;

void describe_surface(const Surface& surface, Manifest& manifest)
{
    const BakeOptions& options = surface.options;
    const bool has_heights = surface.source.has_heights();
    manifest.program_version = kVersion;
    manifest.width = surface.source.width();
    manifest.height = surface.source.height();
    manifest.wrap_s = wrap_name(options.wrap_s);
    manifest.wrap_t = wrap_name(options.wrap_t);
    manifest.texel_width = surface.texel[0];
    manifest.texel_height = surface.texel[1];
    manifest.height_scale = options.height_scale;
    manifest.height_offset = options.height_offset;
    manifest.reconstruction =
        has_heights ? reconstruction_name(options.reconstruction) : "given normals";
    manifest.layout = layout_name(options.layout);
    manifest.has_height = has_heights;
    manifest.h0 = surface.found.h0;
    manifest.h1 = surface.found.h1;
    manifest.height_min = surface.found.height_min;
    manifest.height_max = surface.found.height_max;
    manifest.no_data_texels = surface.found.no_data_texels;
    manifest.half_tolerance = options.half_tolerance;
    manifest.compression = compression_name(options.compression);
    manifest.options = options.as_given;
    if (surface.mapped)
        manifest.color_map = color_map_record(*surface.mapped, options);
}

long long texels_of(const Source& source)
{
    return static_cast<long long>(source.width()) * source.height();
}

TileRecord tile_record(const BakedMap& map)
{
    TileRecord tile;
    tile.number = map.number();
    tile.width = map.surface->width();
    tile.height = map.surface->height();
    tile.texel_width = map.surface->texel[0];
    tile.texel_height = map.surface->texel[1];
    tile.no_data_texels = map.surface->found.no_data_texels;
    return tile;
}

/// Adds what a tile has of a mesh to what the tiles before it have.
void add(const MeshRecord& tile, int number, MeshRecord& whole)
{
    whole.covered += tile.covered;
    whole.overlapped += tile.overlapped;
    whole.mirrored += tile.mirrored;
    whole.singular += tile.singular;
    whole.area += tile.area;
    whole.usual_displacement = std::max(whole.usual_displacement, tile.usual_displacement);
    if (tile.largest_displacement <= whole.largest_displacement)
        return;
    whole.largest_displacement = tile.largest_displacement;
    whole.displaced_most = tile.displaced_most;
    whole.displaced_tile = number;
}

} // namespace

void describe(const BakedMaps& maps, Manifest& manifest)
{
    const auto largest =
        std::max_element(maps.begin(), maps.end(), [](const auto& a, const auto& b) {
            return texels_of(a->source()) < texels_of(b->source());
        });
    describe_surface(*(*largest)->surface, manifest);
    if (maps.front()->number() == 0)
        return;
    manifest.no_data_texels = 0;
    for (const auto& map : maps) {
        manifest.tiles.push_back(tile_record(*map));
        manifest.no_data_texels += manifest.tiles.back().no_data_texels;
    }
}

void describe_mesh(const BakedMaps& maps, Manifest& manifest)
{
    if (maps.front()->mesh() == nullptr)
        return;
    MeshRecord whole = maps.front()->mesh()->mesh().record();
    for (size_t i = 0; i < maps.size(); ++i) {
        const MeshRecord record = maps[i]->mesh()->record();
        add(record, maps[i]->number(), whole);
        if (!manifest.tiles.empty())
            manifest.tiles[i].mesh = record;
    }
    manifest.mesh = whole;
}

std::vector<std::string> channels_of(Map map, const TableSizes& tables)
{
    const VisibilityPlan& visibility = tables.visibility;
    const auto nodes = static_cast<int>(visibility.node_angles_deg.size());
    if (map == Map::rank)
        return rank_channels(tables.rank_terms);
    if (map == Map::visible)
        return visibility.axes ? visible_channels_along_axes(nodes)
                               : visible_channels(nodes, visibility.harmonics);
    return map_info(map).channels;
}

std::vector<TextureRecord> textures_for(const std::vector<Map>& maps, const TableSizes& tables,
                                        const BakeOptions& options, const std::string& name)
{
    std::vector<TextureRecord> textures;
    for (const Map map : maps) {
        TextureRecord texture;
        texture.map = map;
        texture.channels = channels_of(map, tables);
        const bool tiled = is_tiled(options.height_file);
        texture.file = fmt::format("{}{}.{}.exr", name, tiled ? ".<UDIM>" : "", map_info(map).name);
        const bool half =
            options.pixel_type == PixelTypeChoice::half && map != Map::map && map != Map::exponent;
        texture.type = half ? PixelType::half : PixelType::float32;
        textures.push_back(texture);
    }
    return textures;
}

Attributes attributes_of(Map map, const Manifest& manifest)
{
    const std::string wraps =
        map == Map::map ? "clamp,clamp" : manifest.wrap_s + "," + manifest.wrap_t;
    Attributes attributes = {
        {"textureformat", std::string("Plain Texture")},
        {"wrapmodes", wraps},
        {"Software", "scree " + manifest.program_version},
        {"scree:set", manifest.name},
        {"scree:map", map_info(map).name},
        {"scree:meaning", map_info(map).meaning},
        {"scree:axes",
         std::string(manifest.mesh ? "x along dP/ds, y towards dP/dt, t down" : "s right, t down")},
        {"scree:texelWidth", manifest.texel_width},
        {"scree:texelHeight", manifest.texel_height},
        {"scree:reconstruction", manifest.reconstruction}};
    if (manifest.has_height) {
        attributes.emplace_back("scree:h0", manifest.h0);
        attributes.emplace_back("scree:h1", manifest.h1);
    }
    if (map == Map::map && manifest.color_map && manifest.color_map->table) {
        const MapTableRecord& table = *manifest.color_map->table;
        attributes.emplace_back("scree:by", manifest.color_map->by);
        attributes.emplace_back("scree:meanLow", static_cast<float>(table.low));
        attributes.emplace_back("scree:meanHigh", static_cast<float>(table.high));
        attributes.emplace_back("scree:widestDeviation", static_cast<float>(table.widest));
        if (manifest.color_map->by == "slope")
            attributes.emplace_back("scree:azimuthDegrees",
                                    static_cast<float>(manifest.color_map->azimuth_deg));
    }
    if (map == Map::visible && manifest.visibility) {
        const VisibilityRecord& table = *manifest.visibility;
        attributes.emplace_back("scree:nodes", static_cast<int>(table.node_angles_deg.size()));
        if (table.axis_deg) {
            const double axis = *table.axis_deg * kRadian;
            attributes.emplace_back("scree:axisCosine", static_cast<float>(std::cos(axis)));
            attributes.emplace_back("scree:axisSine", static_cast<float>(std::sin(axis)));
        } else {
            attributes.emplace_back("scree:harmonics", table.harmonics);
        }
        for (size_t i = 0; i < table.node_angles_deg.size(); ++i)
            attributes.emplace_back(
                fmt::format("scree:nodeCosine{}", i + 1),
                static_cast<float>(std::cos(table.node_angles_deg[i] * kRadian)));
    }
    if (!manifest.working_space.empty())
        attributes.emplace_back("scree:workingSpace", manifest.working_space);
    return attributes;
}

} // namespace scree
