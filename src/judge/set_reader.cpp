#include "judge/set_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/error.h"
#include "pipeline/options.h"
#include "texset/mip_reader.h"

namespace scree {

namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;

MapTable read_table(const MapTableRecord& record, MipReader& file)
{
    MapTable table;
    table.columns = file.width(0);
    table.rows = file.height(0);
    table.low = record.low;
    table.high = record.high;
    table.widest = record.widest;
    const std::vector<float> pixels = file.rows(0, 0, table.rows);
    for (size_t i = 0; i + 2 < pixels.size(); i += 3)
        table.colors.push_back({static_cast<double>(pixels[i]), static_cast<double>(pixels[i + 1]),
                                static_cast<double>(pixels[i + 2])});
    return table;
}

void expect_finite(const MapTable& table, const std::filesystem::path& file)
{
    for (const Rgb& color : table.colors)
        if (!std::isfinite(color[0] + color[1] + color[2]))
            throw Error(fmt::format("{}: has colors that are no numbers; bake the set again",
                                    file.string()));
}

/// What the manifest tells of the tables of visibility, made ready for lookups.
void describe_nodes(const std::optional<VisibilityRecord>& record, const TextureRecord& texture,
                    const std::filesystem::path& folder, SetColors& colors)
{
    const auto nodes = record ? static_cast<int>(record->node_angles_deg.size()) : 0;
    if (nodes < 1 || nodes > kMaxNodes || record->harmonics < 0 ||
        record->harmonics > kMaxHarmonics ||
        (record->axis_deg ? visible_channels_along_axes(nodes)
                          : visible_channels(nodes, record->harmonics)) != texture.channels)
        throw Error(fmt::format("{}: has other nodes or terms than its manifest says; bake the "
                                "set again",
                                (folder / texture.file).string()));
    double before = 0;
    for (const double angle_deg : record->node_angles_deg) {
        if (!(angle_deg > before && angle_deg < 90))
            throw Error(fmt::format("{}: nodes at {} degrees in its manifest, expected rising ones "
                                    "below 90; bake the set again",
                                    (folder / texture.file).string(),
                                    fmt::join(record->node_angles_deg, ", ")));
        before = angle_deg;
    }
    for (const double angle_deg : record->node_angles_deg)
        colors.node_cosines.push_back(static_cast<float>(std::cos(angle_deg * kRadPerDegree)));
    colors.harmonics = record->harmonics;
    if (record->axis_deg) {
        colors.axes = true;
        colors.axis_s = static_cast<float>(std::cos(*record->axis_deg * kRadPerDegree));
        colors.axis_t = static_cast<float>(std::sin(*record->axis_deg * kRadPerDegree));
    }
}

} // namespace

struct SetReader::Texture {
    Map map;
    MipReader file;
    /// The rows last read: decoding goes by tiles.
    int level = -1, first = 0, count = 0;
    std::vector<float> rows;

    const float* row(int of_level, int y)
    {
        if (of_level != level || y < first || y >= first + count) {
            level = of_level;
            first = y - y % kTileSize;
            count = std::min(kTileSize, file.height(level) - first);
            rows = file.rows(level, first, count);
        }
        return rows.data() + static_cast<size_t>(y - first) *
                                 static_cast<size_t>(file.width(level)) * file.channels().size();
    }
};

SetReader::SetReader(const std::filesystem::path& set, int tile)
    : folder_(std::filesystem::is_directory(set) ? set : set.parent_path()),
      manifest_(manifest_of_map(read_manifest(set), tile))
{
    colors_.models = {ColorModel::mean};
    for (const TextureRecord& record : manifest_.textures) {
        MipReader file(folder_ / record.file);
        if (file.channels() != record.channels)
            throw Error(fmt::format("{}: has other channels than its manifest says; bake the set "
                                    "again",
                                    (folder_ / record.file).string()));
        if (record.map == Map::map) {
            if (!manifest_.color_map || !manifest_.color_map->table)
                throw Error(fmt::format("{}: has a color map's table of which the manifest knows "
                                        "nothing; bake the set again",
                                        (folder_ / record.file).string()));
            colors_.table = read_table(*manifest_.color_map->table, file);
            expect_finite(colors_.table, folder_ / record.file);
            continue;
        }
        if (record.map == Map::visible)
            describe_nodes(manifest_.visibility, record, folder_, colors_);
        if (file.width(0) != manifest_.width || file.height(0) != manifest_.height ||
            file.levels() != static_cast<int>(manifest_.levels.size()))
            throw Error(fmt::format("{}: is {}x{} with {} levels, its manifest says {}x{} with {}; "
                                    "bake the set again",
                                    (folder_ / record.file).string(), file.width(0), file.height(0),
                                    file.levels(), manifest_.width, manifest_.height,
                                    manifest_.levels.size()));
        textures_.push_back({record.map, std::move(file), -1, 0, 0, {}});
    }
    auto has = [this](Map map) {
        return std::any_of(manifest_.textures.begin(), manifest_.textures.end(),
                           [map](const TextureRecord& record) { return record.map == map; });
    };
    has_color_ = has(Map::color);
    colors_.has_slope = has(Map::colorslope);
    if (has(Map::colorheight))
        colors_.models.push_back(ColorModel::height);
    if (has(Map::rank))
        colors_.models.push_back(ColorModel::rank);
    if (has(Map::colorheight) && has(Map::exponent))
        colors_.models.push_back(ColorModel::exponent);
    if (has(Map::map)) {
        colors_.models.push_back(ColorModel::map);
        colors_.map_by = manifest_.color_map->by;
        const double azimuth = manifest_.color_map->azimuth_deg * kRadPerDegree;
        colors_.azimuth_s = static_cast<float>(std::cos(azimuth));
        colors_.azimuth_t = static_cast<float>(std::sin(azimuth));
    }
    if (has(Map::visible) && has_color_) // tables tell differences from the mean color
        colors_.models.push_back(ColorModel::visible);
}

SetReader::~SetReader() = default;
SetReader::SetReader(SetReader&&) noexcept = default;

std::vector<SetTexel> SetReader::row(int level, int y)
{
    const int width = std::max(1, manifest_.width >> level);
    SetTexel blank;
    if (!has_color_)
        blank.color = {1, 1, 1};
    std::vector<SetTexel> texels(static_cast<size_t>(width), blank);
    for (Texture& texture : textures_) {
        const size_t channels = texture.file.channels().size();
        const float* values = texture.row(level, y);
        for (size_t x = 0; x < texels.size(); ++x)
            put_channels(texels[x], texture.map, values + x * channels, channels);
    }
    return texels;
}

} // namespace scree
