// NAME.visible.exr and NAME.exponent.exr as the baker writes them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "math/error.h"
#include "reference/gather.h"
#include "support/files.h"
#include "support/memory_bake.h"

namespace scree::test {
namespace {

constexpr int kSize = 64;
constexpr double kRadian = 3.14159265358979323846 / 180;

/// Smooth noise, high parts bright.
MemorySource snowy()
{
    MemorySource source;
    source.map_width = source.map_height = kSize;
    std::mt19937 random(4);
    std::normal_distribution<double> number;
    std::vector<double> noise;
    for (int i = 0; i < kSize * kSize; ++i)
        noise.push_back(number(random));
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            double h = 0;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    h += noise[static_cast<size_t>((y + j + kSize) % kSize * kSize +
                                                   (x + i + kSize) % kSize)];
            source.heights.push_back(0.3 * h);
            source.colors.push_back({h > 0 ? 0.9 : 0.2, 0.5, h > 1 ? 0.7 : 0.3});
        }
    return source;
}

TEST(VisibilityTable, HoldsWhatTheReferenceSees)
{
    TempFolder temp;
    BakeOptions options;
    options.visibility = Visibility::tables;
    options.table = {{60, 80}, 0, 8};
    options.move_nodes = false;
    options.pixel_type = PixelTypeChoice::float32;
    const MemorySource source = snowy();
    const Manifest m = bake_memory(temp / "set", source, options);
    const auto levels = read_levels(temp / "set" / "test.visible.exr");
    ASSERT_EQ(levels[0].channels, visible_channels(2, 0));

    const reference::DisplacedSurface surface(source.statistics_input().relief);
    constexpr int kLevel = 4; // 16x16 texels
    reference::GatherPlan plan;
    plan.grid = 96;
    for (const double angle : options.table.node_angles_deg)
        for (int j = 0; j < 8; ++j) {
            const double azimuth = (j + 0.25) * 45 * kRadian, theta = angle * kRadian;
            plan.views.emplace_back(std::sin(theta) * std::cos(azimuth),
                                    std::sin(theta) * std::sin(azimuth), std::cos(theta));
        }
    const Image& level = levels[kLevel];
    double squares = 0, noise = 0, signal = 0;
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) {
            const auto footprint = reference::footprint_of(kSize, kSize, kLevel, x, y);
            const auto truth = reference::gather(surface, footprint, plan,
                                                 static_cast<uint64_t>(level.width * y + x));
            double mean[3] = {};
            for (int j = 0; j < 16; ++j)
                for (int i = 0; i < 16; ++i)
                    for (size_t c = 0; c < 3; ++c)
                        mean[c] +=
                            source
                                .colors[static_cast<size_t>((16 * y + j) * kSize + 16 * x + i)][c] /
                            256;
            for (size_t node = 0; node < 2; ++node) {
                const double z = std::cos(options.table.node_angles_deg[node] * kRadian);
                double sum[3][4] = {}; // of all samples and of the halves: A, R, G, B
                for (size_t j = 0; j < 8; ++j)
                    for (size_t part = 0; part < 3; ++part) {
                        const auto& seen =
                            (part == 0 ? truth.all : truth.halves[part - 1]).seen[8 * node + j];
                        sum[part][0] += seen.area / z / 8;
                        for (size_t c = 0; c < 3; ++c)
                            sum[part][c + 1] += seen.area / z * seen.color[c] / 8;
                    }
                for (size_t i = 0; i < 4; ++i) {
                    const double expected = sum[0][i] - (i == 0 ? 1 : mean[i - 1]);
                    const int channel = static_cast<int>(4 * node + (i == 0 ? 0 : 4 - i)); // ABGR
                    squares += std::pow(static_cast<double>(level.at(x, y, channel)) - expected, 2);
                    noise += std::pow((sum[1][i] - sum[2][i]) / 2, 2);
                    signal += expected * expected;
                }
            }
        }
    // The reference's own noise, and that of two lines a texel over 8 azimuths.
    EXPECT_LT(std::sqrt(squares), 1.5 * std::sqrt(noise) + 0.03 * std::sqrt(signal));
    EXPECT_GT(std::sqrt(signal), 20 * std::sqrt(noise)) << "the test tells something";
    EXPECT_EQ(m.visibility->node_angles_deg, options.table.node_angles_deg);
}

// One color a texel: nothing to tell, and three quarters of the file compress to nothing.
TEST(VisibilityTable, HoldsNothingOfSingleTexels)
{
    TempFolder temp;
    BakeOptions options;
    options.visibility = Visibility::tables;
    bake_memory(temp / "set", snowy(), options);
    const auto levels = read_levels(temp / "set" / "test.visible.exr");
    for (const float value : levels[0].pixels)
        ASSERT_EQ(value, 0);
    const auto zeros = std::count(levels[1].pixels.begin(), levels[1].pixels.end(), 0.0F);
    EXPECT_LT(zeros, levels[1].pixels.size() / 10);
}

TEST(VisibilityTable, OfAWholeMapThatGoesOnSeesAllOfIt)
{
    TempFolder temp;
    BakeOptions options;
    options.visibility = Visibility::tables;
    options.table = {best_node_angles(4), 1, 8};
    options.pixel_type = PixelTypeChoice::float32;
    bake_memory(temp / "set", snowy(), options);
    const Image last = read_levels(temp / "set" / "test.visible.exr").back();
    for (int node = 0; node < 4; ++node)
        for (int term = 0; term < 3; ++term)
            // Lines end between the lines that others begin with, at 87 degrees 19 times as far.
            EXPECT_NEAR(static_cast<double>(last.at(0, 0, 12 * node + 4 * term)), 0, 2e-3);
}

TEST(VisibilityTable, TakesThePlaceOfOtherModelsOfColor)
{
    TempFolder temp;
    BakeOptions options;
    options.visibility = Visibility::tables;
    const auto maps = maps_of(bake_memory(temp / "set", snowy(), options));
    EXPECT_EQ(maps, (std::set<Map>{Map::slope, Map::height, Map::color, Map::visible, Map::tail}));
    options.visibility = Visibility::corrected;
    const Manifest m = bake_memory(temp / "corrected", snowy(), options);
    EXPECT_EQ(maps_of(m), (std::set<Map>{Map::slope, Map::height, Map::color, Map::colorheight,
                                         Map::exponent, Map::tail}));
    const auto levels = read_levels(temp / "corrected" / "test.exponent.exr");
    for (size_t l = 0; l < levels.size(); ++l) {
        const ExponentFit& fit = *m.levels[l].exponent;
        const int x = levels[l].width - 1, y = levels[l].height - 1;
        EXPECT_EQ(levels[l].at(x, y, 0), static_cast<float>(fit.gain));
        EXPECT_EQ(levels[l].at(x, y, 1), static_cast<float>(fit.power));
        EXPECT_EQ(levels[l].at(x, y, 2), static_cast<float>(fit.threshold));
    }
}

TEST(VisibilityTable, EveryLevelSaysWhatTheModelsLeaveAndNoneIsWorseThanTheMean)
{
    TempFolder temp;
    BakeOptions options;
    options.auto_maps = true;
    options.table.harmonics = 2;
    const Manifest m = bake_memory(temp / "set", snowy(), options);
    for (size_t l = 1; l < m.levels.size(); ++l) {
        const auto& errors = m.levels[l].model_errors;
        auto error = [&errors](const std::string& model) {
            return std::find_if(errors.begin(), errors.end(),
                                [&model](const auto& e) { return e.model == model; })
                ->error;
        };
        EXPECT_GT(error("mean color"), 0.03) << "level " << l;
        EXPECT_LE(error("exponent"), error("mean color") * 1.001) << "level " << l;
        EXPECT_LT(error("visible 4x5"), error("mean color")) << "level " << l;
    }
}

// Smith's exponent, which models are measured with, takes slopes that the set need not hold.
TEST(VisibilityTable, ModelsAreMeasuredAlikeWithoutAMapOfSlopes)
{
    TempFolder temp;
    BakeOptions options;
    options.maps = {Map::height, Map::color, Map::colorheight, Map::visible};
    const Manifest without = bake_memory(temp / "without", snowy(), options);
    options.maps.push_back(Map::slope);
    const Manifest with = bake_memory(temp / "with", snowy(), options);
    for (size_t l = 1; l < with.levels.size(); ++l)
        for (size_t m = 0; m < with.levels[l].model_errors.size(); ++m)
            EXPECT_EQ(without.levels[l].model_errors.at(m).error,
                      with.levels[l].model_errors[m].error)
                << l << " " << with.levels[l].model_errors[m].model;
}

TEST(VisibilityTable, BytesDoNotDependOnTheNumberOfThreads)
{
    std::string first;
    for (const int threads : {1, 3}) {
        TempFolder temp;
        BakeOptions options;
        options.visibility = Visibility::tables;
        options.threads = threads;
        bake_memory(temp / "set", snowy(), options);
        const std::string bytes = read_bytes(temp / "set" / "test.visible.exr");
        if (first.empty())
            first = bytes;
        EXPECT_TRUE(bytes == first);
    }
}

TEST(VisibilityTable, TexelsWithoutDataNeitherHideNorAreSeen)
{
    TempFolder temp;
    MemorySource source = snowy();
    for (int y = 20; y < 30; ++y)
        for (int x = 10; x < 50; ++x)
            source.heights[static_cast<size_t>(y * kSize + x)] =
                std::numeric_limits<double>::quiet_NaN();
    BakeOptions options;
    options.visibility = Visibility::tables;
    options.pixel_type = PixelTypeChoice::float32;
    bake_memory(temp / "set", source, options);
    const auto levels = read_levels(temp / "set" / "test.visible.exr");
    for (const float value : levels[0].pixels)
        EXPECT_TRUE(std::isfinite(value));
    EXPECT_EQ(levels[0].at(30, 25, 0), 0) << "without data";
}

TEST(VisibilityTable, NeedsHeightsAndColors)
{
    TempFolder temp;
    MemorySource flat;
    flat.map_width = flat.map_height = 4;
    flat.slopes.assign(16, {0.1, 0});
    flat.colors.assign(16, {0.5, 0.5, 0.5});
    BakeOptions options;
    MemorySource colorless = snowy();
    colorless.colors.clear();
    options.maps = {Map::color, Map::visible};
    EXPECT_THROW(bake_memory(temp / "set", flat, options), Error);
    EXPECT_THROW(bake_memory(temp / "set", colorless, options), Error);
    options.maps = {};
    for (const Visibility visibility : {Visibility::tables, Visibility::corrected}) {
        options.visibility = visibility;
        EXPECT_THROW(bake_memory(temp / "set", flat, options), Error);
        EXPECT_THROW(bake_memory(temp / "set", colorless, options), Error);
    }
    EXPECT_FALSE(std::filesystem::exists(temp / "set"));
}

TEST(VisibilityTable, IsNotLeftOutInSilence)
{
    TempFolder temp;
    BakeOptions options;
    options.visibility = Visibility::tables;
    options.maps = {Map::slope, Map::color};
    EXPECT_THROW(bake_memory(temp / "set", snowy(), options), Error);
    options.visibility = Visibility::corrected;
    EXPECT_THROW(bake_memory(temp / "set", snowy(), options), Error);
    options.maps = {};
    options.layout = Layout::bumpslopes;
    EXPECT_THROW(bake_memory(temp / "set", snowy(), options), Error);
}

} // namespace
} // namespace scree::test
