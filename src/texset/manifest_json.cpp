#include "texset/manifest_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "texset/json_object.h"
#include "texset/level_json.h"

namespace scree {

namespace {

using Json = JsonObject::Json;

InputRecord input_from_json(const JsonObject& json)
{
    InputRecord input;
    json.get("role", input.role);
    json.get("file", input.file);
    json.get("sha256", input.sha256);
    json.get("width", input.width);
    json.get("height", input.height);
    json.get("channels", input.channels);
    json.get("pixel_type", input.type);
    json.get_if_there("tile", input.tile);
    json.get_if_there("color_space", input.color_space);
    return input;
}

Map map_called(const std::string& name)
{
    for (const MapInfo& info : map_table())
        if (info.name == name)
            return info.map;
    throw Error(fmt::format("holds a map '{}', which this version does not know", name));
}

TextureRecord texture_from_json(const JsonObject& json)
{
    TextureRecord texture;
    std::string map, pixel_type;
    json.get("map", map);
    texture.map = map_called(map);
    json.get("file", texture.file);
    json.get("channels", texture.channels);
    json.get("pixel_type", pixel_type);
    texture.type = pixel_type == "half" ? PixelType::half : PixelType::float32;
    json.get_if_there("half_error", texture.half_error);
    json.get_if_there("float_error", texture.float_error);
    return texture;
}

MapTableRecord table_from_json(const JsonObject& json)
{
    MapTableRecord table;
    std::array<double, 2> range{};
    json.get("columns", table.columns);
    json.get("rows", table.rows);
    json.get("mean_range", range);
    table.low = range[0];
    table.high = range[1];
    json.get("widest_deviation", table.widest);
    json.get("tolerance", table.tolerance);
    json.get("rms_error", table.rms_error);
    json.get("largest_error", table.largest_error);
    json.get_if_there("shortcut_rms", table.shortcut_rms);
    json.get_if_there("shortcut_largest", table.shortcut_largest);
    return table;
}

ColorMapRecord color_map_from_json(const JsonObject& json)
{
    ColorMapRecord map;
    std::array<double, 2> range{};
    json.get("by", map.by);
    json.get("range", range);
    map.first = range[0];
    map.last = range[1];
    json.get_if_there("azimuth_deg", map.azimuth_deg);
    if (json.has("table"))
        map.table = table_from_json(json.object("table"));
    return map;
}

ModelRecord model_from_json(const JsonObject& json)
{
    ModelRecord model;
    json.get("model", model.model);
    json.get("channels", model.channels);
    json.get("error", model.error);
    json.get("rank_terms", model.rank_terms);
    json.get("chosen", model.chosen);
    return model;
}

ModelChoice choice_from_json(const JsonObject& json)
{
    ModelChoice choice;
    json.get("max_view_angle_deg", choice.max_view_angle_deg);
    json.get("tolerance", choice.tolerance);
    for (const JsonObject& model : json.objects("models"))
        choice.models.push_back(model_from_json(model));
    return choice;
}

MeshRecord mesh_from_json(const JsonObject& json)
{
    MeshRecord mesh;
    json.get("faces", mesh.faces);
    // Not there before format 3:
    json.get_if_there("scheme", mesh.scheme);
    json.get_if_there("boundary", mesh.boundary);
    json.get_if_there("uv_interpolation", mesh.uv_interpolation);
    json.get_if_there("charts", mesh.charts);
    json.get_if_there("mirrored_charts", mesh.mirrored_charts);
    json.get("covered_texels", mesh.covered);
    json.get("overlapped_texels", mesh.overlapped);
    json.get("mirrored_texels", mesh.mirrored);
    json.get("singular_texels", mesh.singular);
    json.get("area", mesh.area);
    json.get("largest_height_times_curvature", mesh.largest_displacement);
    json.get("at_texel", mesh.displaced_most);
    json.get_if_there("in_tile", mesh.displaced_tile);
    json.get_if_there("usual_height_times_curvature", mesh.usual_displacement);
    return mesh;
}

VisibilityRecord visibility_from_json(const JsonObject& json)
{
    VisibilityRecord visibility;
    json.get("node_angles_deg", visibility.node_angles_deg);
    json.get("azimuths", visibility.azimuths);
    json.get_if_there("axis_deg", visibility.axis_deg);
    if (!visibility.axis_deg)
        json.get("harmonics", visibility.harmonics);
    return visibility;
}

void read_heights(const JsonObject& json, Manifest& m)
{
    std::array<double, 2> range{};
    m.has_height = true;
    json.get("h0", m.h0);
    json.get("h1", m.h1);
    json.get("height_range", range);
    m.height_min = range[0];
    m.height_max = range[1];
    json.get("height_bits", m.integer_bits);
    json.get("height_quantum", m.quantum);
}

void read_surface(const JsonObject& json, Manifest& m)
{
    std::array<std::string, 2> wrap;
    std::array<double, 2> texel_size{};
    json.get("width", m.width);
    json.get("height", m.height);
    json.get("wrap", wrap);
    m.wrap_s = wrap[0];
    m.wrap_t = wrap[1];
    json.get("texel_size", texel_size);
    m.texel_width = texel_size[0];
    m.texel_height = texel_size[1];
    json.get("height_scale", m.height_scale);
    json.get("height_offset", m.height_offset);
    json.get("reconstruction", m.reconstruction);
    if (json.has("h0"))
        read_heights(json, m);
}

TileRecord tile_from_json(const JsonObject& json)
{
    TileRecord tile;
    std::array<double, 2> texel_size{};
    json.get("tile", tile.number);
    json.get("width", tile.width);
    json.get("height", tile.height);
    json.get("texel_size", texel_size);
    tile.texel_width = texel_size[0];
    tile.texel_height = texel_size[1];
    json.get("no_data_texels", tile.no_data_texels);
    if (json.has("mesh"))
        tile.mesh = mesh_from_json(json.object("mesh"));
    for (const JsonObject& level : json.objects("levels"))
        tile.levels.push_back(level_from_json(level));
    return tile;
}

Manifest manifest_from_json(const JsonObject& json)
{
    const std::string before_version = kManifestProgram;
    Manifest m;
    json.get("name", m.name);
    json.get("program", m.program_version);
    if (m.program_version.rfind(before_version, 0) == 0)
        m.program_version.erase(0, before_version.size());
    read_surface(json, m);
    json.get("layout", m.layout);
    json.get("compression", m.compression);
    json.get_if_there("working_space", m.working_space);
    json.get("no_data_texels", m.no_data_texels);
    json.get("half_tolerance", m.half_tolerance);
    if (json.has("mesh"))
        m.mesh = mesh_from_json(json.object("mesh"));
    if (json.has("color_map"))
        m.color_map = color_map_from_json(json.object("color_map"));
    if (json.has("model_choice"))
        m.model_choice = choice_from_json(json.object("model_choice"));
    if (json.has("visibility"))
        m.visibility = visibility_from_json(json.object("visibility"));
    for (const JsonObject& input : json.objects("inputs"))
        m.inputs.push_back(input_from_json(input));
    for (const JsonObject& texture : json.objects("textures"))
        m.textures.push_back(texture_from_json(texture));
    for (const JsonObject& level : json.objects("levels"))
        m.levels.push_back(level_from_json(level));
    if (json.has("tiles"))
        for (const JsonObject& tile : json.objects("tiles"))
            m.tiles.push_back(tile_from_json(tile));
    json.get("options", m.options);
    json.get("warnings", m.warnings);
    return m;
}

[[noreturn]] void refuse_as_damaged(const std::string& why)
{
    throw Error(fmt::format("damaged manifest: {}; bake the set again", why));
}

[[noreturn]] void refuse_as_foreign()
{
    throw Error("not a Scree manifest; name the folder of a texture set, or the file "
                "NAME.scree.json in it");
}

Json parsed(const std::string& text)
{
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& e) {
        const size_t begin = text.find_first_not_of(" \t\r\n");
        if (begin == std::string::npos)
            refuse_as_damaged("the file is empty");
        if (text[begin] != '{')
            refuse_as_foreign();
        const std::string before = text.substr(0, e.byte - 1);
        refuse_as_damaged(fmt::format("cut short, or no JSON from line {} on",
                                      1 + std::count(before.begin(), before.end(), '\n')));
    } catch (const Json::exception&) { // out of range: parse() throws no other
        refuse_as_damaged("a number in it is too large");
    }
}

} // namespace

Manifest manifest_of(const std::string& text)
{
    const Json json = parsed(text);
    if (!json.is_object() || !json.contains("format") || json.at("format") != kManifestFormat)
        refuse_as_foreign();
    int version = 0;
    try {
        const JsonObject whole(json, "");
        whole.get("format_version", version);
        if (version <= Manifest::kFormatVersion)
            return manifest_from_json(whole);
    } catch (const Error& e) {
        refuse_as_damaged(e.what());
    }
    throw Error(fmt::format("format version {}, this program reads up to {}; use a newer scree",
                            version, Manifest::kFormatVersion));
}

} // namespace scree
