#include "shaders/sample_set.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "pipeline/bake.h"
#include "support/sample_source.h"

namespace scree::test {

namespace {

using Imath::V2f;
using Imath::V3f;

/// A color map of linear pieces that differ between the channels.
std::filesystem::path write_color_map(const std::filesystem::path& folder)
{
    std::ofstream(folder / "map.spi1d") << "Version 1\nFrom 0 1\nLength 6\nComponents 3\n{\n"
                                           "0.02 0.10 0.40\n0.10 0.35 0.45\n0.55 0.40 0.15\n"
                                           "0.30 0.60 0.10\n0.60 0.55 0.50\n0.95 0.90 0.85\n}\n";
    return folder / "map.spi1d";
}

/// Bilinear, clamped, as a texture unit reads.
V3f bilinear(const Image& image, const V2f& at)
{
    const auto place = [](float coordinate, int size) {
        return std::clamp(static_cast<double>(coordinate) * size - 0.5, 0.0, size - 1.0);
    };
    const double x = place(at.x, image.width), y = place(at.y, image.height);
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, image.width - 1), y1 = std::min(y0 + 1, image.height - 1);
    const auto part = [&](int column, int row, double weight) {
        return rgb(image, column, row) * static_cast<float>(weight);
    };
    const double a = x - x0, b = y - y0;
    return part(x0, y0, (1 - a) * (1 - b)) + part(x1, y0, a * (1 - b)) + part(x0, y1, (1 - a) * b) +
           part(x1, y1, a * b);
}

/// Where the table of a color map is to be looked up.
V2f map_coordinates(const SampleSet& set, const filter::VisibleSlopes<float>& seen, float h,
                    float hh, float exponent)
{
    if (set.map_by == "height") {
        const float sigma = filter::height_sigma(h, hh);
        const auto visible = filter::visible_height(exponent);
        return filter::color_map_coordinates(h + sigma * visible.mean,
                                             sigma * std::sqrt(visible.variance), set.map_table);
    }
    EXPECT_TRUE(set.map_by == "slope" || set.map_by == "slope magnitude") << set.map_by;
    const V2f direction(std::cos(set.map_azimuth_rad), std::sin(set.map_azimuth_rad));
    const auto slope = set.map_by == "slope"
                           ? filter::slope_along(direction, seen.mean, seen.covariance)
                           : filter::slope_magnitude(seen.mean, seen.covariance);
    return filter::color_map_coordinates(slope.mean, slope.deviation, set.map_table);
}

/// By visibility tables.
V3f table_color(const SampleSet& set, size_t level, int x, int y, const V3f& view,
                const ColorLook& look)
{
    const V3f c = rgb(set.color[level], x, y);
    const std::vector<float> values = set.visible.values(level, x, y);
    const auto table = set.visible.table(values);
    const V3f seen = filter::visible_color(c, table, view);
    if (look.light == V3f(0))
        return seen;
    return filter::color_seen_and_lit(c, seen, filter::visible_color(c, table, look.light), view,
                                      look.light);
}

/// The measured exponent, of the view, and of the light where there is one.
float measured_exponent(const SampleSet& set, size_t level, int x, int y, const V3f& view,
                        const ColorLook& look)
{
    const auto number = [&](const char* name) { return value(set.exponent[level], x, y, name); };
    const filter::Exponent<float> measured{number("gain"), number("power"), number("threshold")};
    const auto raw = slope_moments_of(set, level, x, y, look.height_scale);
    const float tau = value(set.tail[level], x, y, "tau");
    float exponent = filter::measured_exponent(view, raw, tau, measured);
    if (look.light != V3f(0))
        exponent += filter::measured_exponent(look.light, raw, tau, measured);
    return exponent;
}

} // namespace

SampleSet read_set(const std::filesystem::path& folder)
{
    const Manifest manifest = read_manifest(folder);
    const auto levels = [&](const std::string& map) {
        return read_levels(folder / (manifest.name + "." + map + ".exr"));
    };
    SampleSet set;
    set.world_width = static_cast<float>(manifest.width * manifest.texel_width);
    set.world_height = static_cast<float>(manifest.height * manifest.texel_height);
    set.slope = levels("slope");
    set.height = levels("height");
    set.color = levels("color");
    set.colorheight = levels("colorheight");
    set.colorslope = levels("colorslope");
    set.rank = levels("rank");
    set.tail = levels("tail");
    const auto visible = folder / (manifest.name + ".visible.exr");
    if (std::filesystem::exists(visible))
        set.visible = read_visible_tables(visible);
    if (std::filesystem::exists(folder / (manifest.name + ".exponent.exr")))
        set.exponent = levels("exponent");
    if (!manifest.color_map)
        return set;
    set.map = levels("map").at(0);
    const MapTableRecord table = manifest.color_map->table.value();
    set.map_table = {static_cast<float>(table.low), static_cast<float>(table.high),
                     static_cast<float>(table.widest), set.map.width, set.map.height};
    set.map_by = manifest.color_map->by;
    set.map_azimuth_rad = static_cast<float>(manifest.color_map->azimuth_deg) * 0.0174532925F;
    return set;
}

void bake_sample_into(const std::filesystem::path& folder, const std::string& kind, int width,
                      int height, std::optional<MapBy> colored_by)
{
    const TempFolder temp;
    const auto field = make_sample(kind, width, height);
    MemorySource source = sample_source(*field, width, height);
    BakeOptions options;
    options.output = folder;
    options.pixel_type = PixelTypeChoice::float32;
    options.texel_size = {field->info().world_width / width, field->info().world_height / height};
    if (colored_by) {
        source.colors.clear();
        options.colormap_file = write_color_map(temp.path());
        options.map_by = *colored_by;
        options.map_azimuth_deg = 35; // of MapBy::slope
        if (*colored_by == MapBy::slope)
            options.map_range = {{-0.7, 0.8}};
        if (*colored_by == MapBy::slope_magnitude)
            options.map_range = {{0, 0.9}};
    }
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
}

SampleSet bake_sample(const std::string& kind, int width, int height,
                      std::optional<MapBy> colored_by)
{
    const TempFolder temp;
    bake_sample_into(temp / "set", kind, width, height, colored_by);
    return read_set(temp / "set");
}

float value(const Image& image, int x, int y, const std::string& channel)
{
    const auto at = std::find(image.channels.begin(), image.channels.end(), channel);
    if (at == image.channels.end()) {
        ADD_FAILURE() << "no channel " << channel;
        return 0;
    }
    return image.at(x, y, static_cast<int>(at - image.channels.begin()));
}

V3f rgb(const Image& image, int x, int y)
{
    return {value(image, x, y, "R"), value(image, x, y, "G"), value(image, x, y, "B")};
}

filter::SlopeMoments<float> slope_moments_of(const SampleSet& set, size_t level, int x, int y,
                                             float height_scale)
{
    const auto slope = [&](const char* name) { return value(set.slope[level], x, y, name); };
    const float square = height_scale * height_scale;
    return {height_scale * slope("s"), square * slope("ss"), square * slope("st"),
            height_scale * slope("t"), square * slope("tt")};
}

filter::Slopes<float> slopes_of(const SampleSet& set, size_t level, int x, int y,
                                float height_scale)
{
    return filter::slopes(slope_moments_of(set, level, x, y, height_scale),
                          value(set.tail[level], x, y, "tau"));
}

V3f visible_color(const SampleSet& set, size_t level, int x, int y, const V3f& view,
                  const ColorLook& look)
{
    const filter::Slopes<float> slopes = slopes_of(set, level, x, y, look.height_scale);
    const bool measured = look.color_model == 5;
    const float exponent = measured ? measured_exponent(set, level, x, y, view, look)
                                    : filter::masking(view, slopes).lambda + look.light_exponent;
    const float h = value(set.height[level], x, y, "h"), hh = value(set.height[level], x, y, "hh");
    const V3f c = rgb(set.color[level], x, y);
    V3f result = c;
    if (look.color_model == 1 || measured)
        result = filter::color_by_height(c, rgb(set.colorheight[level], x, y), h, hh,
                                         filter::visible_height(exponent));
    if (look.color_model == 2) {
        const int terms = static_cast<int>(set.rank[level].channels.size()) / 3;
        std::vector<V3f> a;
        for (int n = 1; n <= terms; ++n) {
            const auto term = [&](char channel) {
                return value(set.rank[level], x, y, fmt::format("{}{}", channel, n));
            };
            a.emplace_back(term('R'), term('G'), term('B'));
        }
        result = filter::color_by_rank(c, a.data(), terms, exponent);
    }
    if (look.color_model == 3)
        result = bilinear(
            set.map, map_coordinates(set, filter::visible_slopes(view, slopes), h, hh, exponent));
    if (look.color_model == 4)
        result = table_color(set, level, x, y, view, look);
    if (look.slope_color && look.color_model != 4 &&
        (look.color_model != 3 || set.map_by == "height")) {
        const auto along = [&](const char* r, const char* g, const char* b) {
            const Image& map = set.colorslope[level];
            return V3f(value(map, x, y, r), value(map, x, y, g), value(map, x, y, b)) *
                   look.height_scale;
        };
        result += filter::color_by_slope(c, along("Rs", "Gs", "Bs"), along("Rt", "Gt", "Bt"), view,
                                         slopes) -
                  c;
        for (int i = 0; i < 3; ++i)
            result[i] = std::max(result[i], 0.0F);
    }
    return result;
}

} // namespace scree::test
