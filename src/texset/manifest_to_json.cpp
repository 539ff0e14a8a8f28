#include "texset/manifest_json.h"

#include <nlohmann/json.hpp>

namespace scree {

using Json = nlohmann::ordered_json;

namespace {

template <class T>
void put(Json& json, const char* key, const std::optional<T>& value)
{
    if (value)
        json[key] = *value;
}

constexpr const char* kPlaneAxes = "s to the right, t down; slope = dh/ds, dh/dt in world units";
constexpr const char* kMeshAxes =
    "x along dP/ds, y square to it on the side of dP/dt (t down); slope = "
    "dh/dx, dh/dy in world units";

Json input_to_json(const InputRecord& input)
{
    Json json = {{"role", input.role},      {"file", input.file},     {"sha256", input.sha256},
                 {"width", input.width},    {"height", input.height}, {"channels", input.channels},
                 {"pixel_type", input.type}};
    if (input.tile != 0)
        json["tile"] = input.tile;
    if (!input.color_space.empty())
        json["color_space"] = input.color_space;
    return json;
}

Json texture_to_json(const TextureRecord& texture, const Manifest& manifest)
{
    const MapInfo& info = map_info(texture.map);
    Json json = {{"map", info.name},
                 {"file", texture.file},
                 {"channels", texture.channels},
                 {"meaning", info.meaning},
                 {"pixel_type", pixel_type_name(texture.type)}};
    if (manifest.tiles.empty() || texture.map == Map::map)
        json["levels"] = texture.map == Map::map ? 1 : manifest.levels.size();
    put(json, "half_error", texture.half_error);
    put(json, "float_error", texture.float_error);
    return json;
}

Json table_to_json(const MapTableRecord& table)
{
    Json json = {{"columns", table.columns},
                 {"rows", table.rows},
                 {"mean_range", {table.low, table.high}},
                 {"widest_deviation", table.widest},
                 {"row_spacing", "row i of n holds the deviation widest (i / (n - 1))^2"},
                 {"tolerance", table.tolerance},
                 {"rms_error", table.rms_error},
                 {"largest_error", table.largest_error}};
    put(json, "shortcut_rms", table.shortcut_rms);
    put(json, "shortcut_largest", table.shortcut_largest);
    return json;
}

Json color_map_to_json(const ColorMapRecord& map)
{
    Json json = {{"by", map.by}, {"range", {map.first, map.last}}};
    if (map.by == "slope")
        json["azimuth_deg"] = map.azimuth_deg;
    if (map.table)
        json["table"] = table_to_json(*map.table);
    return json;
}

Json choice_to_json(const ModelChoice& choice)
{
    Json json = {{"max_view_angle_deg", choice.max_view_angle_deg},
                 {"tolerance", choice.tolerance},
                 {"models", Json::array()}};
    for (const ModelRecord& model : choice.models)
        json["models"].push_back({{"model", model.model},
                                  {"channels", model.channels},
                                  {"error", model.error},
                                  {"rank_terms", model.rank_terms},
                                  {"chosen", model.chosen}});
    return json;
}

Json mesh_to_json(const MeshRecord& mesh)
{
    Json json = {{"scheme", mesh.scheme},
                 {"boundary", mesh.boundary},
                 {"uv_interpolation", mesh.uv_interpolation},
                 {"faces", mesh.faces},
                 {"charts", mesh.charts},
                 {"mirrored_charts", mesh.mirrored_charts},
                 {"covered_texels", mesh.covered},
                 {"overlapped_texels", mesh.overlapped},
                 {"mirrored_texels", mesh.mirrored},
                 {"singular_texels", mesh.singular},
                 {"area", mesh.area},
                 {"largest_height_times_curvature", mesh.largest_displacement},
                 {"at_texel", mesh.displaced_most},
                 {"usual_height_times_curvature", mesh.usual_displacement}};
    if (mesh.displaced_tile != 0)
        json["in_tile"] = mesh.displaced_tile;
    return json;
}

Json visibility_to_json(const VisibilityRecord& visibility)
{
    Json json = {{"node_angles_deg", visibility.node_angles_deg},
                 {"azimuths", visibility.azimuths}};
    if (visibility.axis_deg)
        json["axis_deg"] = *visibility.axis_deg;
    else
        json["harmonics"] = visibility.harmonics;
    return json;
}

Json fit_to_json(const ColorFit& fit)
{
    Json json = {{"sigma", fit.sigma}};
    put(json, "height_correlation", fit.height_correlation);
    put(json, "slope_correlation", fit.slope_correlation);
    put(json, "r2_height", fit.height);
    put(json, "r2_slope", fit.slope);
    put(json, "r2_rank1", fit.rank1);
    put(json, "r2_rank2", fit.rank2);
    put(json, "r2_rank4", fit.rank4);
    json["residual"] = fit.residual;
    return json;
}

Json level_to_json(const LevelSummary& level)
{
    Json json = {{"width", level.width}, {"height", level.height}, {"coverage", level.coverage}};
    put(json, "mean_slope", level.mean_slope);
    put(json, "steepest", level.steepest);
    put(json, "rms_slope", level.rms_slope);
    put(json, "slope_sigma", level.slope_sigma);
    put(json, "kurtosis", level.kurtosis);
    put(json, "tau", level.tau);
    put(json, "height_sigma", level.height_sigma);
    put(json, "mean_color", level.mean_color);
    if (level.color_fit)
        json["color_fit"] = fit_to_json(*level.color_fit);
    if (level.exponent)
        json["exponent"] = {{"gain", level.exponent->gain},
                            {"power", level.exponent->power},
                            {"threshold", level.exponent->threshold}};
    for (const LevelError& error : level.model_errors)
        json["model_errors"].push_back({{"model", error.model}, {"error", error.error}});
    return json;
}

Json levels_to_json(const std::vector<LevelSummary>& levels)
{
    Json json = Json::array();
    for (const LevelSummary& level : levels)
        json.push_back(level_to_json(level));
    return json;
}

Json tile_to_json(const TileRecord& tile)
{
    Json json = {{"tile", tile.number},
                 {"width", tile.width},
                 {"height", tile.height},
                 {"texel_size", {tile.texel_width, tile.texel_height}},
                 {"no_data_texels", tile.no_data_texels}};
    if (tile.mesh)
        json["mesh"] = mesh_to_json(*tile.mesh);
    json["levels"] = levels_to_json(tile.levels);
    return json;
}

Json manifest_to_json(const Manifest& m)
{
    Json json;
    json["format"] = kManifestFormat;
    json["format_version"] = Manifest::kFormatVersion;
    json["program"] = kManifestProgram + m.program_version;
    json["name"] = m.name;
    json["width"] = m.width;
    json["height"] = m.height;
    json["axes"] = m.mesh ? kMeshAxes : kPlaneAxes;
    json["wrap"] = {m.wrap_s, m.wrap_t};
    json["texel_size"] = {m.texel_width, m.texel_height};
    json["height_scale"] = m.height_scale;
    json["height_offset"] = m.height_offset;
    json["reconstruction"] = m.reconstruction;
    json["layout"] = m.layout;
    json["compression"] = m.compression;
    if (m.has_height) {
        json["h0"] = m.h0;
        json["h1"] = m.h1;
        json["height_range"] = {m.height_min, m.height_max};
        json["height_bits"] = m.integer_bits;
        json["height_quantum"] = m.quantum;
    }
    if (!m.working_space.empty())
        json["working_space"] = m.working_space;
    json["no_data_texels"] = m.no_data_texels;
    json["half_tolerance"] = m.half_tolerance;
    if (m.mesh)
        json["mesh"] = mesh_to_json(*m.mesh);
    if (m.color_map)
        json["color_map"] = color_map_to_json(*m.color_map);
    if (m.model_choice)
        json["model_choice"] = choice_to_json(*m.model_choice);
    if (m.visibility)
        json["visibility"] = visibility_to_json(*m.visibility);
    json["inputs"] = Json::array();
    for (const auto& input : m.inputs)
        json["inputs"].push_back(input_to_json(input));
    json["textures"] = Json::array();
    for (const auto& texture : m.textures)
        json["textures"].push_back(texture_to_json(texture, m));
    json["levels"] = levels_to_json(m.levels);
    for (const auto& tile : m.tiles)
        json["tiles"].push_back(tile_to_json(tile));
    json["options"] = m.options;
    json["warnings"] = m.warnings;
    return json;
}

} // namespace

std::string to_json(const Manifest& manifest)
{ // JSON is UTF-8; names of files need not be
    return manifest_to_json(manifest).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace scree
