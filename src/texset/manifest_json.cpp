#include "texset/manifest_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "math/error.h"

namespace scree {

using Json = nlohmann::ordered_json;

namespace {

const std::string kProgram = "scree "; // goes before the version

template <class T>
void put(Json& json, const char* key, const std::optional<T>& value)
{
    if (value)
        json[key] = *value;
}

template <class T>
void get(const Json& json, const char* key, std::optional<T>& value)
{
    if (json.contains(key) && !json.at(key).is_null())
        value = json.at(key).get<T>();
}

Json input_to_json(const InputRecord& input)
{
    Json json = {{"role", input.role},      {"file", input.file},     {"sha256", input.sha256},
                 {"width", input.width},    {"height", input.height}, {"channels", input.channels},
                 {"pixel_type", input.type}};
    if (!input.color_space.empty())
        json["color_space"] = input.color_space;
    return json;
}

InputRecord input_from_json(const Json& json)
{
    return {json.at("role"),       json.at("file"),
            json.at("sha256"),     json.at("width"),
            json.at("height"),     json.at("channels"),
            json.at("pixel_type"), json.value("color_space", "")};
}

Json texture_to_json(const TextureRecord& texture, const Manifest& manifest)
{
    const MapInfo& info = map_info(texture.map);
    Json json = {{"map", info.name},
                 {"file", texture.file},
                 {"channels", texture.channels},
                 {"meaning", info.meaning},
                 {"pixel_type", pixel_type_name(texture.type)},
                 {"levels", texture.map == Map::map ? 1 : manifest.levels.size()}};
    put(json, "half_error", texture.half_error);
    put(json, "float_error", texture.float_error);
    return json;
}

TextureRecord texture_from_json(const Json& json)
{
    TextureRecord texture;
    const std::string name = json.at("map");
    bool known = false;
    for (const MapInfo& info : map_table())
        if (info.name == name) {
            texture.map = info.map;
            known = true;
        }
    if (!known)
        throw Error("unknown map '" + name + "'");
    texture.file = json.at("file");
    texture.channels = json.at("channels").get<std::vector<std::string>>();
    texture.type = json.at("pixel_type") == "half" ? PixelType::half : PixelType::float32;
    get(json, "half_error", texture.half_error);
    get(json, "float_error", texture.float_error);
    return texture;
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

MapTableRecord table_from_json(const Json& json)
{
    MapTableRecord table;
    table.columns = json.at("columns");
    table.rows = json.at("rows");
    table.low = json.at("mean_range").at(0);
    table.high = json.at("mean_range").at(1);
    table.widest = json.at("widest_deviation");
    table.tolerance = json.at("tolerance");
    table.rms_error = json.at("rms_error");
    table.largest_error = json.at("largest_error");
    get(json, "shortcut_rms", table.shortcut_rms);
    get(json, "shortcut_largest", table.shortcut_largest);
    return table;
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

ColorMapRecord color_map_from_json(const Json& json)
{
    ColorMapRecord map;
    map.by = json.at("by");
    map.first = json.at("range").at(0);
    map.last = json.at("range").at(1);
    map.azimuth_deg = json.value("azimuth_deg", 0.0);
    if (json.contains("table"))
        map.table = table_from_json(json.at("table"));
    return map;
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

ModelChoice choice_from_json(const Json& json)
{
    ModelChoice choice;
    choice.max_view_angle_deg = json.at("max_view_angle_deg");
    choice.tolerance = json.at("tolerance");
    for (const auto& model : json.at("models"))
        choice.models.push_back({model.at("model"), model.at("channels"), model.at("error"),
                                 model.at("rank_terms"), model.at("chosen")});
    return choice;
}

Json visibility_to_json(const VisibilityRecord& visibility)
{
    return {{"node_angles_deg", visibility.node_angles_deg},
            {"harmonics", visibility.harmonics},
            {"azimuths", visibility.azimuths}};
}

VisibilityRecord visibility_from_json(const Json& json)
{
    return {json.at("node_angles_deg"), json.at("harmonics"), json.at("azimuths")};
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

ColorFit fit_from_json(const Json& json)
{
    ColorFit fit;
    fit.sigma = json.at("sigma");
    get(json, "height_correlation", fit.height_correlation);
    get(json, "slope_correlation", fit.slope_correlation);
    get(json, "r2_height", fit.height);
    get(json, "r2_slope", fit.slope);
    get(json, "r2_rank1", fit.rank1);
    get(json, "r2_rank2", fit.rank2);
    get(json, "r2_rank4", fit.rank4);
    fit.residual = json.at("residual");
    return fit;
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
        json["model_errors"][error.model] = error.error;
    return json;
}

LevelSummary level_from_json(const Json& json)
{
    LevelSummary level;
    level.width = json.at("width");
    level.height = json.at("height");
    level.coverage = json.at("coverage");
    get(json, "mean_slope", level.mean_slope);
    get(json, "steepest", level.steepest);
    get(json, "rms_slope", level.rms_slope);
    get(json, "slope_sigma", level.slope_sigma);
    get(json, "kurtosis", level.kurtosis);
    get(json, "tau", level.tau);
    get(json, "height_sigma", level.height_sigma);
    get(json, "mean_color", level.mean_color);
    if (json.contains("color_fit"))
        level.color_fit = fit_from_json(json.at("color_fit"));
    if (json.contains("exponent")) {
        const Json& exponent = json.at("exponent");
        level.exponent = {exponent.at("gain"), exponent.at("power"), exponent.at("threshold")};
    }
    if (json.contains("model_errors"))
        for (const auto& [model, error] : json.at("model_errors").items())
            level.model_errors.push_back({model, error});
    return level;
}

Json manifest_to_json(const Manifest& m)
{
    Json json;
    json["format"] = "scree texture set";
    json["format_version"] = Manifest::kFormatVersion;
    json["program"] = kProgram + m.program_version;
    json["name"] = m.name;
    json["width"] = m.width;
    json["height"] = m.height;
    json["axes"] = "s to the right, t down; slope = dh/ds, dh/dt in world units";
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
    json["levels"] = Json::array();
    for (const auto& level : m.levels)
        json["levels"].push_back(level_to_json(level));
    json["options"] = m.options;
    json["warnings"] = m.warnings;
    return json;
}

Manifest manifest_from_json(const Json& json)
{
    if (json.value("format", "") != "scree texture set")
        throw Error("not a Scree manifest");
    const int version = json.at("format_version");
    if (version > Manifest::kFormatVersion)
        throw Error(fmt::format("format version {}, this program reads up to {}; use a newer scree",
                                version, Manifest::kFormatVersion));
    Manifest m;
    m.name = json.at("name");
    const std::string program = json.at("program");
    m.program_version = program.rfind(kProgram, 0) == 0 ? program.substr(kProgram.size()) : program;
    m.width = json.at("width");
    m.height = json.at("height");
    m.wrap_s = json.at("wrap").at(0);
    m.wrap_t = json.at("wrap").at(1);
    m.texel_width = json.at("texel_size").at(0);
    m.texel_height = json.at("texel_size").at(1);
    m.height_scale = json.at("height_scale");
    m.height_offset = json.at("height_offset");
    m.reconstruction = json.at("reconstruction");
    m.layout = json.at("layout");
    m.compression = json.at("compression");
    m.has_height = json.contains("h0");
    if (m.has_height) {
        m.h0 = json.at("h0");
        m.h1 = json.at("h1");
        m.height_min = json.at("height_range").at(0);
        m.height_max = json.at("height_range").at(1);
        m.integer_bits = json.at("height_bits");
        m.quantum = json.at("height_quantum");
    }
    m.working_space = json.value("working_space", "");
    m.no_data_texels = json.at("no_data_texels");
    m.half_tolerance = json.at("half_tolerance");
    if (json.contains("color_map"))
        m.color_map = color_map_from_json(json.at("color_map"));
    if (json.contains("model_choice"))
        m.model_choice = choice_from_json(json.at("model_choice"));
    if (json.contains("visibility"))
        m.visibility = visibility_from_json(json.at("visibility"));
    for (const auto& input : json.at("inputs"))
        m.inputs.push_back(input_from_json(input));
    for (const auto& texture : json.at("textures"))
        m.textures.push_back(texture_from_json(texture));
    for (const auto& level : json.at("levels"))
        m.levels.push_back(level_from_json(level));
    m.options = json.at("options").get<std::map<std::string, std::string>>();
    m.warnings = json.at("warnings").get<std::vector<std::string>>();
    return m;
}

} // namespace

std::string to_json(const Manifest& manifest) { return manifest_to_json(manifest).dump(2) + "\n"; }

Manifest manifest_of(const std::string& json)
{
    try {
        return manifest_from_json(Json::parse(json));
    } catch (const nlohmann::json::exception& e) {
        throw Error(fmt::format("damaged manifest: {}", e.what()));
    }
}

} // namespace scree
