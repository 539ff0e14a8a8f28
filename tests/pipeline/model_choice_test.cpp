// `--maps auto`: what is kept, on surfaces where the answer is known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <set>

#include "kernel/filter.h"
#include "math/normal.h"
#include "pipeline/measured_views.h"
#include "reference/gather.h"
#include "support/files.h"
#include "support/memory_bake.h"
#include "support/set_slopes.h"

namespace scree::test {
namespace {

Manifest bake_auto(const MemorySource& source, const std::filesystem::path& folder,
                   BakeOptions options = {})
{
    options.auto_maps = true;
    return bake_memory(folder, source, options);
}

double error_of(const Manifest& manifest, const std::string& model)
{
    for (const ModelRecord& record : manifest.model_choice->models)
        if (record.model == model)
            return record.error;
    ADD_FAILURE() << model << " was not judged";
    return -1;
}

/// Of the whole map.
double last_error_of(const Manifest& manifest, const std::string& model)
{
    for (const LevelError& error : manifest.levels.back().model_errors)
        if (error.model == model)
            return error.error;
    ADD_FAILURE() << model << " was not judged";
    return -1;
}

std::string chosen_of(const Manifest& manifest)
{
    std::string chosen;
    for (const ModelRecord& record : manifest.model_choice->models)
        if (record.chosen && record.model.rfind("without", 0) != 0)
            chosen += record.model;
    return chosen;
}

constexpr double kPi = 3.14159265358979323846;

/// Gaussian noise of slopes about `steepness`; a color a height.
template <class Color>
MemorySource surface(double steepness, Color color)
{
    MemorySource source;
    source.map_width = source.map_height = 64;
    std::mt19937 random(5);
    std::normal_distribution<double> height;
    for (int i = 0; i < 64 * 64; ++i) {
        const double h = height(random);
        source.heights.push_back(steepness * h);
        const double c = color(h);
        source.colors.push_back({c, c, c});
    }
    return source;
}

TEST(ModelChoice, OneColorNeedsNoModelOfColor)
{
    TempFolder temp;
    const Manifest m = bake_auto(surface(0.3, [](double) { return 0.5; }), temp / "set");
    EXPECT_EQ(chosen_of(m), "mean color");
    const auto maps = maps_of(m);
    EXPECT_EQ(maps.count(Map::slope) + maps.count(Map::color), 2U);
    for (const Map map : {Map::height, Map::colorheight, Map::colorslope, Map::rank})
        EXPECT_EQ(maps.count(map), 0U) << map_info(map).name;
}

TEST(ModelChoice, FromAboveNothingIsHidden)
{
    TempFolder temp;
    BakeOptions options;
    options.max_view_angle_deg = 0;
    const Manifest m =
        bake_auto(surface(0.3, [](double h) { return h > 0 ? 1 : 0.1; }), temp / "set", options);
    EXPECT_EQ(chosen_of(m), "mean color");
    EXPECT_LT(error_of(m, "mean color"), 1e-5); // a sweep looks from a hundredth of a degree
    EXPECT_EQ(maps_of(m).count(Map::colorslope), 0U);
}

TEST(ModelChoice, TheCheapestWithinTheToleranceIsKeptAndTheRestDropped)
{
    auto snow = [](double h) { return h > 0 ? 1 : 0.1; };
    std::set<std::string> chosen;
    for (const double tolerance : {1.0, 0.1, 0.025, 1e-3}) {
        TempFolder temp;
        BakeOptions options;
        options.max_view_angle_deg = 75;
        options.model_tolerance = tolerance;
        const Manifest m = bake_auto(surface(0.3, snow), temp / "set", options);
        // By the recorded errors: it is within the tolerance and none cheaper is; or, where none
        // is, within it of the best.
        int chosen_channels = -1;
        double chosen_error = 0, best = 1e9;
        for (const ModelRecord& record : m.model_choice->models) {
            if (record.model.rfind("without", 0) == 0)
                continue;
            best = std::min(best, record.error);
            if (record.chosen) {
                chosen_channels = record.channels;
                chosen_error = record.error;
            }
        }
        ASSERT_GE(chosen_channels, 0);
        const double limit = best <= tolerance ? tolerance : best + tolerance;
        EXPECT_LE(chosen_error, limit);
        for (const ModelRecord& record : m.model_choice->models)
            EXPECT_TRUE(record.model.rfind("without", 0) == 0 || record.error > limit ||
                        record.channels >= chosen_channels)
                << record.model;
        EXPECT_EQ(maps_of(m).count(Map::rank), chosen_of(m).rfind("rank", 0) == 0 ? 1U : 0U);
        // What was recorded is what stands in the folder.
        for (const TextureRecord& texture : m.textures)
            EXPECT_EQ(read_levels(temp / "set" / texture.file)[0].channels.size(),
                      texture.channels.size())
                << texture.file;
        EXPECT_TRUE(m.levels.back().color_fit->rank4) << "the report knows of what was dropped";
        chosen.insert(chosen_of(m));
    }
    EXPECT_GE(chosen.size(), 2U) << "the tolerance decides";
}

/// Oracle for the errors of the mean color and of a color map: hills, seen by the reference from
/// the views that are measured.
TEST(ModelChoice, ErrorsAreWhatTheModelsDoNotShowOfHills)
{
    TempFolder temp;
    MemorySource source;
    source.map_width = source.map_height = 64;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            source.heights.push_back(1.5 + 1.5 * std::cos(x * kPi / 8) * std::cos(y * kPi / 8));
    BakeOptions options;
    options.max_view_angle_deg = 80;
    options.map_tolerance = 1e-4;
    options.colormap_file = temp / "ramp.spi1d"; // from 0.2 on the lower height to 0.8
    std::ofstream(options.colormap_file) << "Version 1\nFrom 0 1\nLength 2\nComponents 1\n"
                                            "{\n0.2\n0.8\n}\n";
    const Manifest m = bake_auto(source, temp / "set", options);

    BakeOptions all = options;
    all.pixel_type = PixelTypeChoice::float32;
    bake_memory(temp / "all", source, all);
    const Image slope = read_levels(temp / "all" / "test.slope.exr").back();
    const Image tail = read_levels(temp / "all" / "test.tail.exr").back();
    const auto slopes = slopes_at(slope, 0, 0, static_cast<double>(tail.at(0, 0, 0)));

    reference::Relief relief = source.statistics_input().relief;
    for (const double h : source.heights)
        relief.colors.push_back({0.2 + 0.2 * h, 0, 0});
    const reference::DisplacedSurface surface(relief);
    const MeasuredViews views(options.max_view_angle_deg);
    reference::GatherPlan plan;
    plan.grid = 400;
    for (const MeasuredView& view : views.views)
        plan.views.emplace_back(view.x, view.y, view.z);
    const auto seen =
        reference::gather(surface, reference::footprint_of(64, 64, 6, 0, 0), plan, 0).all.seen;

    std::vector<double> without(views.elevations_deg.size()), by_map(without);
    for (size_t i = 0; i < seen.size(); ++i) {
        const MeasuredView& view = views.views[i];
        const double truth = seen[i].color[0];
        const double lambda =
            filter::masking(filter::Vec3<double>(view.x, view.y, view.z), slopes).lambda;
        // Heights are of mean 1.5 and deviation 0.75; normalised, the ramp is 0.5 + 0.15 h from -2
        // to 2, constant beyond. Its mean over a normal law, with overshoot(c) = E[max(0, X - c)].
        const auto visible = filter::visible_height(lambda);
        const double s = std::sqrt(visible.variance);
        auto overshoot = [s](double c) { return s * normal_pdf(c / s) - c * normal_cdf(-c / s); };
        const double mapped =
            0.5 + 0.15 * (visible.mean - overshoot(2 - visible.mean) + overshoot(2 + visible.mean));
        const auto e = static_cast<size_t>(view.elevation);
        without[e] += (truth - 0.5) * (truth - 0.5) / 4;
        by_map[e] += (mapped - truth) * (mapped - truth) / 4;
    }
    const double of_mean = std::sqrt(*std::max_element(without.begin(), without.end())) / 0.5;
    const double of_map = std::sqrt(*std::max_element(by_map.begin(), by_map.end())) / 0.5;
    EXPECT_GT(of_mean, 0.02);
    // 160000 rays a view: a share of 0.5 is known to 0.00125; sweeps follow 2 lines a texel.
    EXPECT_NEAR(last_error_of(m, "mean color"), of_mean, 0.004);
    EXPECT_NEAR(last_error_of(m, "map"), of_map, 0.004);
}

TEST(ModelChoice, TailGoesWhereSlopesAreGaussianAndStaysWhereTheyAreNot)
{
    // Slopes of a normal map, one a texel: Gaussian, or one in 20 five times as steep.
    for (const bool heavy : {false, true}) {
        MemorySource source;
        source.map_width = source.map_height = 128;
        std::mt19937 random(6);
        std::normal_distribution<double> slope(0, 0.2);
        for (int i = 0; i < 128 * 128; ++i) {
            const double scale = heavy && random() % 20 == 0 ? 5 : 1;
            source.slopes.push_back({scale * slope(random), scale * slope(random)});
        }
        TempFolder temp;
        BakeOptions options;
        options.max_view_angle_deg = 80;
        options.model_tolerance = 0.02;
        const Manifest m = bake_auto(source, temp / "set", options);
        EXPECT_EQ(maps_of(m).count(Map::tail), heavy ? 1U : 0U)
            << error_of(m, "without tail") << (heavy ? " heavy" : " gaussian");
    }
}

TEST(ModelChoice, DoesNotDependOnTheNumberOfThreads)
{
    std::string first;
    for (const int threads : {1, 3}) {
        TempFolder temp;
        BakeOptions options;
        options.threads = threads;
        const Manifest m =
            bake_auto(surface(0.3, [](double h) { return 0.5 + 0.1 * h; }), temp / "set", options);
        const std::string json = to_json(m);
        if (first.empty())
            first = json;
        EXPECT_EQ(json, first);
    }
}

} // namespace
} // namespace scree::test
