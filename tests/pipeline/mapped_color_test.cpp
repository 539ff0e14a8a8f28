// A color map in a bake: where it lies, what the color texture and the table then hold.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <vector>

#include "kernel/filter.h"
#include "math/error.h"
#include "math/normal.h"
#include "pipeline/bake.h"
#include "support/files.h"
#include "support/memory_source.h"
#include "support/set_slopes.h"

namespace scree::test {
namespace {

/// A gray LUT in scene-linear numbers, on [0, 1] unless its domain is given.
std::filesystem::path write_lut(const TempFolder& temp, const std::vector<double>& entries,
                                const std::string& domain = "0.0 1.0")
{
    const auto file = temp / "map.spi1d";
    std::ofstream out(file);
    out << "Version 1\nFrom " << domain << "\nLength " << entries.size() << "\nComponents 1\n{\n";
    for (const double e : entries)
        out << e << "\n";
    out << "}\n";
    return file;
}

MemorySource noise(int width, int height, double mean, double deviation)
{
    MemorySource source;
    source.map_width = width;
    source.map_height = height;
    std::mt19937 random(3);
    std::normal_distribution<double> h(mean, deviation);
    for (int i = 0; i < width * height; ++i)
        source.heights.push_back(static_cast<double>(static_cast<float>(h(random))));
    return source;
}

struct Set {
    Manifest manifest;
    TempFolder temp;
    std::vector<Image> levels(const std::string& map) const
    {
        return read_levels(temp / "set" / ("test." + map + ".exr"));
    }
};

void bake_set(Set& set, MemorySource source, BakeOptions options)
{
    options.output = set.temp / "set";
    options.texel_size = {1, 1};
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "test";
    set.manifest = bake(source, options, manifest);
}

TEST(MappedColor, ANormalisedMapIsStretchedOverTheHeightsThereAre)
{
    Set set;
    BakeOptions options;
    options.colormap_file = write_lut(set.temp, {0.25, 0.75});
    const MemorySource source = noise(32, 16, 100, 20);
    bake_set(set, source, options);
    const auto [low, high] = std::minmax_element(source.heights.begin(), source.heights.end());
    EXPECT_EQ(set.manifest.color_map->first, *low);
    EXPECT_EQ(set.manifest.color_map->last, *high);
    const Image color = set.levels("color")[0];
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const double u =
                (source.heights[static_cast<size_t>(y * 32 + x)] - *low) / (*high - *low);
            EXPECT_NEAR(color.at(x, y, 1), 0.25 + 0.5 * u, 1e-6);
        }
}

TEST(MappedColor, AStatedDomainIsInHeightUnitsAndAGivenRangeGoesBeforeIt)
{
    for (const bool given : {false, true}) {
        Set set;
        BakeOptions options;
        options.colormap_file = write_lut(set.temp, {0, 1}, "90.0 110.0");
        if (given)
            options.map_range = {60, 140};
        const MemorySource source = noise(16, 16, 100, 20);
        bake_set(set, source, options);
        const double low = given ? 60 : 90, high = given ? 140 : 110;
        const Image color = set.levels("color")[0];
        for (size_t i = 0; i < source.heights.size(); ++i)
            EXPECT_NEAR(color.pixels[3 * i],
                        std::clamp((source.heights[i] - low) / (high - low), 0.0, 1.0), 2e-6);
    }
}

TEST(MappedColor, BySlopeItIsTheSlopeAlongTheAzimuthOrItsLength)
{
    // A plane: slope (0.3, 0.4) everywhere.
    MemorySource source;
    source.map_width = source.map_height = 8;
    for (int i = 0; i < 64; ++i)
        source.heights.push_back(0.3 * (i % 8) + 0.4 * (i / 8));
    struct Case {
        MapBy by;
        double azimuth_deg, slope;
    };
    for (const Case& c : {Case{MapBy::slope_magnitude, 0, 0.5}, Case{MapBy::slope, 0, 0.3},
                          Case{MapBy::slope, 90, 0.4}, Case{MapBy::slope, 180, -0.3},
                          Case{MapBy::slope, 45, 0.7 / std::sqrt(2.0)}}) {
        Set set;
        BakeOptions options;
        options.colormap_file = write_lut(set.temp, {0, 1});
        options.map_by = c.by;
        options.map_azimuth_deg = c.azimuth_deg;
        options.map_range = {-1, 1};
        options.wrap_s = options.wrap_t = Wrap::clamp;
        options.maps = {Map::color, Map::map}; // no slope map; the slope is there all the same
        bake_set(set, source, options);
        const Image color = set.levels("color")[0];
        for (const float v : color.pixels)
            EXPECT_NEAR(v, 0.5 + c.slope / 2, 1e-6) << c.azimuth_deg;
    }
}

TEST(MappedColor, AMapBySlopeNeedsARangeAndOneByHeightNeedsHeights)
{
    Set set;
    BakeOptions options;
    options.colormap_file = write_lut(set.temp, {0, 1});
    options.map_by = MapBy::slope_magnitude;
    EXPECT_THROW(bake_set(set, noise(4, 4, 0, 1), options), Error);
    options.map_by = MapBy::height;
    MemorySource normals;
    normals.map_width = normals.map_height = 4;
    normals.slopes.assign(16, {0.1, 0.2});
    EXPECT_THROW(bake_set(set, normals, options), Error);
    EXPECT_FALSE(std::filesystem::exists(set.temp / "set"));
}

TEST(MappedColor, TexelsWithoutDataTakeNoPart)
{
    Set set;
    BakeOptions options;
    options.colormap_file = write_lut(set.temp, {0, 1}, "-10.0 10.0");
    MemorySource source = noise(8, 8, 0, 1);
    source.heights[9] = std::nan("");
    bake_set(set, source, options);
    double sum = 0;
    for (const double h : source.heights)
        sum += std::isnan(h) ? 0 : 0.5 + h / 20;
    EXPECT_NEAR(set.levels("color").back().at(0, 0, 0), sum / 63, 1e-6);
    EXPECT_NEAR(set.levels("color")[0].at(1, 1, 0), 0.5, 0.03) << "about the mean color";
}

/// Bilinear, clamped, as a texture unit reads the table at (mean, deviation).
double looked_up(const Image& table, const MapTableRecord& record, double mean, double deviation)
{
    const filter::ColorMapTable<double> shape{record.low, record.high, record.widest,
                                              record.columns, record.rows};
    const auto uv = filter::color_map_coordinates(mean, deviation, shape);
    const double x = uv.x * table.width - 0.5, y = uv.y * table.height - 0.5;
    const int i = std::min(static_cast<int>(x), table.width - 2),
              j = std::min(static_cast<int>(y), table.height - 2);
    const double fx = x - i, fy = y - j;
    return (1 - fy) * ((1 - fx) * table.at(i, j, 0) + fx * table.at(i + 1, j, 0)) +
           fy * ((1 - fx) * table.at(i, j + 1, 0) + fx * table.at(i + 1, j + 1, 0));
}

TEST(MappedColor, ATableBySlopeShowsTheMeanColorFromAboveHoweverNarrowTheMap)
{
    // Gaussian slopes of deviation 0.2 about 0.05; "grass below 0.3, rock above", and a wide ramp.
    MemorySource source;
    source.map_width = source.map_height = 128;
    std::mt19937 random(8);
    std::normal_distribution<double> slope(0, 0.2);
    for (int i = 0; i < 128 * 128; ++i)
        source.slopes.push_back({0.05 + slope(random), slope(random)});
    for (const auto by : {MapBy::slope, MapBy::slope_magnitude})
        for (const auto& [low, high] : {std::pair(0.29, 0.31), std::pair(-2.0, 2.0)}) {
            Set set;
            BakeOptions options;
            options.colormap_file = write_lut(set.temp, {0, 1});
            options.map_by = by;
            options.map_range = {low, high};
            bake_set(set, source, options);
            const auto slopes = slopes_at(set.levels("slope").back(), 0, 0);
            const auto along =
                by == MapBy::slope
                    ? filter::slope_along<double>({1, 0}, slopes.mean, slopes.covariance)
                    : filter::slope_magnitude(slopes.mean, slopes.covariance);
            const double shown = looked_up(set.levels("map")[0], *set.manifest.color_map->table,
                                           along.mean, along.deviation);
            // The table's tolerance, and the sample's: 128^2 slopes of a normal law.
            EXPECT_NEAR(shown, set.levels("color").back().at(0, 0, 0), 0.015)
                << low << " to " << high << (by == MapBy::slope ? " along" : " length");
        }
}

/// What a renderer looks up, against the footprint itself: Gaussian heights, color a step at 0.
///
///   visible share above 0 = 1 - P^(1 + L),  P the share of heights below 0
TEST(MappedColor, TheTableShowsAStepOverGaussianHeightsAsItIsSeen)
{
    Set set;
    BakeOptions options;
    options.colormap_file = write_lut(set.temp, {0, 0, 1, 1}, "-0.15 0.15"); // a step at 0
    options.map_tolerance = 0.005;
    const MemorySource source = noise(256, 256, 20, 100);
    bake_set(set, source, options);

    const MapTableRecord& record = *set.manifest.color_map->table;
    const Image table = set.levels("map")[0];
    ASSERT_EQ(table.width, record.columns);
    ASSERT_EQ(table.height, record.rows);
    ASSERT_EQ(set.levels("map").size(), 1U);
    EXPECT_LE(record.rms_error, 0.005);
    const Image height = set.levels("height").back();
    const double h = static_cast<double>(height.at(0, 0, 0));
    const double sigma = filter::height_sigma(h, static_cast<double>(height.at(0, 0, 1)));
    double below = 0;
    for (const double v : source.heights)
        below += v < 0 ? 1.0 / (256 * 256) : 0;
    for (const double L : {0.0, 0.5, 2.0, 10.0, 50.0}) {
        const auto visible = filter::visible_height(L);
        const double shown =
            looked_up(table, record, h + sigma * visible.mean, sigma * std::sqrt(visible.variance));
        // The step averaged over a normal law, in closed form: the table's tolerance. Heights are
        // in units of h1 here, the step lies at -h0 / h1.
        const double step = -set.manifest.h0 / set.manifest.h1;
        const double normal =
            normal_cdf((h + sigma * visible.mean - step) / (sigma * std::sqrt(visible.variance)));
        EXPECT_NEAR(shown, normal, 2 * record.tolerance) << L;
        // The truth, within what taking visible heights as normal costs, and the sample's noise.
        EXPECT_NEAR(normal, 1 - std::pow(below, 1 + L), *record.shortcut_largest + 0.005) << L;
    }
    EXPECT_LT(*record.shortcut_largest, 0.07);
}

} // namespace
} // namespace scree::test
