#include "texset/table_manifest.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "math/error.h"
#include "texset/json_object.h"
#include "texset/manifest_file.h"

namespace scree {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kSuffix = ".scree-table.json";
constexpr const char* kLayout =
    "columns: first axis; rows: the other axes, the second one fastest; every axis as its "
    "coordinates are listed, first column and uppermost row first";

Json axis_to_json(const TableAxis& axis)
{
    return {{"name", axis.name},
            {"unit", axis.unit},
            {"meaning", axis.meaning},
            {"size", axis.coordinates.size()},
            {"range", {axis.coordinates.front(), axis.coordinates.back()}},
            {"coordinates", axis.coordinates}};
}

std::string to_json(const TableManifest& manifest)
{
    Json json = {{"format", "scree table"},
                 {"version", TableManifest::kFormatVersion},
                 {"program", "scree " + manifest.program_version},
                 {"kind", manifest.kind},
                 {"description", manifest.description},
                 {"file", manifest.texture_file()},
                 {"width", manifest.width()},
                 {"height", manifest.height()},
                 {"layout", kLayout},
                 {"axes", Json::array()},
                 {"channels", Json::array()},
                 {"options", manifest.options},
                 {"figures", Json::object()}};
    for (const TableAxis& axis : manifest.axes)
        json["axes"].push_back(axis_to_json(axis));
    for (const TableChannel& channel : manifest.channels)
        json["channels"].push_back({{"name", channel.name},
                                    {"quantity", channel.quantity},
                                    {"unit", channel.unit},
                                    {"meaning", channel.meaning}});
    for (const TableFigure& figure : manifest.figures)
        json["figures"][figure.name] = figure.value;
    return json.dump(2) + "\n";
}

std::vector<TableFigure> figures_of(const Json& json)
{
    std::vector<TableFigure> figures;
    if (!json.contains("figures"))
        return figures;
    const JsonObject object(json["figures"], "figures");
    for (const auto& [name, value] : json["figures"].items())
        object.get(name, figures.emplace_back(TableFigure{name}).value);
    return figures;
}

void expect_known_format(const JsonObject& json)
{
    std::string format;
    int version = 0;
    json.get("format", format);
    json.get("version", version);
    if (format != "scree table")
        throw Error(fmt::format("is of the format '{}', expected 'scree table'", format));
    if (version > TableManifest::kFormatVersion)
        throw Error(fmt::format("is of format version {}, this Scree reads up to {}; take a later "
                                "one",
                                version, TableManifest::kFormatVersion));
}

TableManifest manifest_of(const std::string& text)
{
    const Json parsed = Json::parse(text, nullptr, false);
    if (parsed.is_discarded())
        throw Error("is no JSON; is the file damaged?");
    const JsonObject json(parsed, "");
    expect_known_format(json);
    TableManifest manifest;
    json.get("kind", manifest.kind);
    json.get("description", manifest.description);
    json.get_if_there("options", manifest.options);
    std::string program;
    json.get("program", program);
    manifest.program_version = program.substr(program.find(' ') + 1);
    for (const JsonObject& axis : json.objects("axes")) {
        TableAxis& out = manifest.axes.emplace_back();
        axis.get("name", out.name);
        axis.get("unit", out.unit);
        axis.get("meaning", out.meaning);
        axis.get("coordinates", out.coordinates);
        if (out.coordinates.empty())
            throw Error(
                fmt::format("axis '{}' has no coordinates; is the file damaged?", out.name));
    }
    if (manifest.axes.empty())
        throw Error("has no axes; is the file damaged?");
    for (const JsonObject& channel : json.objects("channels")) {
        TableChannel& out = manifest.channels.emplace_back();
        channel.get("name", out.name);
        channel.get("quantity", out.quantity);
        channel.get("unit", out.unit);
        channel.get("meaning", out.meaning);
    }
    manifest.figures = figures_of(parsed);
    return manifest;
}

} // namespace

int TableManifest::width() const { return static_cast<int>(axes.front().coordinates.size()); }

int TableManifest::height() const
{
    size_t rows = 1;
    for (size_t i = 1; i < axes.size(); ++i)
        rows *= axes[i].coordinates.size();
    return static_cast<int>(rows);
}

void write_table_manifest(const TableManifest& manifest, const fs::path& folder)
{
    const fs::path path = folder / (manifest.kind + kSuffix);
    write_manifest_file(path, to_json(manifest));
}

TableManifest read_table_manifest(const fs::path& table)
{
    const fs::path path = find_manifest(table, kSuffix, "table");
    const std::string text = read_manifest_file(path);
    try {
        return manifest_of(text);
    } catch (const Error& e) {
        throw Error(fmt::format("{}: {}", path.string(), e.what()));
    }
}

std::set<std::string> files_of_table(const fs::path& folder)
{
    try {
        const fs::path path = find_manifest(folder, kSuffix, "table");
        return {path.filename().string(), read_table_manifest(path).texture_file()};
    } catch (const Error&) {
        return {}; // no table, or none we can read: not ours to replace
    }
}

} // namespace scree
