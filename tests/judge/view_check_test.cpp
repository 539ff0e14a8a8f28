#include "judge/view_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "chart/errors.h"
#include "judge/original.h"
#include "judge/picked_texels.h"
#include "pipeline/bake.h"
#include "support/files.h"
#include "support/memory_source.h"

namespace scree::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

BakeOptions unit_texels(const TempFolder& temp)
{
    BakeOptions options;
    options.output = temp / "set";
    options.texel_size = {1, 1};
    options.pixel_type = PixelTypeChoice::float32;
    return options;
}

/// Bakes a surface, compares what views see.
ViewCheck checked(MemorySource source, const BakeOptions& options, const ViewPlan& plan)
{
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
    SetReader set(options.output);
    return check_views(set, reference::DisplacedSurface(read_original(source, options, {}).relief),
                       plan, {});
}

/// Ridges along t, slopes +-0.5, vertices at texel centres.
MemorySource grooves(int size)
{
    MemorySource source;
    source.map_width = source.map_height = size;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            source.heights.push_back(0.5 * std::abs(x % 16 - 8));
    return source;
}

TEST(ViewCheck, OnAPlaneTheSetIsTheReference)
{
    const TempFolder temp;
    MemorySource source;
    source.map_width = source.map_height = 16;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            source.heights.push_back(0.25 * x - 0.5 * y);
            source.colors.push_back({0.25, 0.5, 0.75});
        }
    BakeOptions options = unit_texels(temp);
    options.wrap_s = options.wrap_t = Wrap::clamp;
    ViewPlan plan;
    plan.grid = 4;
    plan.footprints = 4;
    plan.material.f0 = 1; // the lobe at its most
    const ViewCheck check = checked(source, options, plan);
    ASSERT_EQ(check.all.size(), plan.angles_deg.size() + 1);
    ASSERT_EQ(check.levels.size(), plan.angles_deg.size() * 5);
    for (const ViewErrors& errors : check.all) {
        // Rounding of the kernel's single precision.
        EXPECT_LT(errors.color.set, 1e-6) << errors.angle_deg;
        EXPECT_LT(errors.radiance.set, 1e-5) << errors.angle_deg;
        EXPECT_LT(errors.masking.set, 1e-6) << errors.angle_deg;
        EXPECT_LT(errors.slope.set, 1e-6) << errors.angle_deg;
        EXPECT_LT(errors.covariance.set, 1e-6) << errors.angle_deg;
        EXPECT_GT(errors.footprints, 0);
    }
}

TEST(ViewCheck, ReportsTheErrorThatGaussianMaskingHasOnGrooves)
{
    const TempFolder temp;
    const int size = 64;
    ViewPlan plan;
    plan.angles_deg = {70, 75, 80};
    plan.azimuths = 4; // across, along, across, along
    const ViewCheck check = checked(grooves(size), unit_texels(temp), plan);
    for (const ViewErrors& errors : check.levels) {
        if (errors.level < 4) // footprints of less than a period
            continue;
        const double wx = std::sin(errors.angle_deg * kPi / 180);
        const double wz = std::cos(errors.angle_deg * kPi / 180);
        // Across: the two sides show max(0, wz +- wx / 2), all together wz; along: all is seen.
        const double facing = std::max(wz - wx / 2, 0.0) / 2 + std::max(wz + wx / 2, 0.0) / 2;
        const double g1 = wz / facing;
        filter::Slopes<double> gaussian;
        gaussian.covariance.ss = 0.25;
        const double error = filter::masking<double>({wx, 0, wz}, gaussian).g1 - g1;
        const double expected = std::abs(error) * std::sqrt(facing / (facing + wz));
        // The reference's noise at 32x32 samples on a period's two sides.
        EXPECT_NEAR(errors.masking.set, expected, 0.01)
            << "level " << errors.level << ", " << errors.angle_deg << " degrees";
        EXPECT_NEAR(errors.masking.plain, (1 - g1) * std::sqrt(facing / (facing + wz)), 0.01);
    }
}

TEST(ViewCheck, PutsEveryLevelInThePoolWithTheWeightOfItsFootprints)
{
    const TempFolder temp;
    ViewPlan plan;
    plan.grid = 4;
    plan.footprints = 5;
    plan.angles_deg = {60};
    const ViewCheck check = checked(grooves(16), unit_texels(temp), plan);
    int footprints = 0;
    double least = 1e9, most = 0;
    for (const ViewErrors& errors : check.levels) {
        footprints += errors.footprints;
        least = std::min(least, errors.radiance.set);
        most = std::max(most, errors.radiance.set);
    }
    EXPECT_EQ(footprints, 5 + 5 + 5 + 4 + 1);
    EXPECT_EQ(check.all.front().footprints, footprints);
    EXPECT_GE(check.all.front().radiance.set, least);
    EXPECT_LE(check.all.front().radiance.set, most);
    EXPECT_EQ(check.samples, footprints * 16);
}

/// Steep noise whose color goes with height and with slope.
MemorySource colored_noise(int size)
{
    MemorySource source;
    source.map_width = source.map_height = size;
    uint64_t state = 7;
    auto random = [&state] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 40) * 0x1p-24;
    };
    for (int i = 0; i < size * size; ++i)
        source.heights.push_back(1.5 * random());
    for (int i = 0; i < size * size; ++i) {
        const auto at = [&](int k) { return source.heights[static_cast<size_t>(k)] / 1.5; };
        const int next = i % size == size - 1 ? i + 1 - size : i + 1;
        const double rise = 0.5 + 0.5 * (at(next) - at(i));
        source.colors.push_back({at(i), rise, 0.2 + 0.5 * at(i) * rise});
    }
    return source;
}

const Method& method_named(const std::string& name)
{
    return *std::find_if(methods().begin(), methods().end(),
                         [&name](const Method& method) { return method.name == name; });
}

// Oracle: the errors that `scree chart` has of the same texels, from its own table of methods and
// its own sums. Equal to the order of summing, and to float where a method takes other steps.
TEST(ViewCheck, HasTheErrorsThatAChartHasOfTheSameMaps)
{
    struct Case {
        std::vector<Map> maps;
        std::vector<const char*> twins; // of ViewCheck::models
    };
    const std::vector<Map> least{Map::slope, Map::color};
    const std::vector<Map> line{Map::slope, Map::color, Map::height, Map::colorheight};
    const std::vector<Map> leaning{Map::slope, Map::color, Map::height, Map::colorheight,
                                   Map::colorslope};
    const std::vector<Map> ranks{Map::slope, Map::color, Map::rank};
    for (const Case& maps :
         {Case{least, {"LEADR"}}, Case{line, {"LEADR", "linear"}},
          Case{leaning, {"", "linear + slope"}}, Case{ranks, {"LEADR", "rank 4"}}}) {
        const TempFolder temp;
        MemorySource source = colored_noise(32);
        BakeOptions options = unit_texels(temp);
        options.maps = maps.maps;
        ViewPlan plan;
        plan.angles_deg = {75};
        plan.grid = 6;
        plan.footprints = 6;
        const ViewCheck check = checked(source, options, plan);
        const ViewErrors& found = check.all.front();

        SetReader set(options.output);
        const reference::DisplacedSurface surface(read_original(source, options, {}).relief);
        reference::GatherPlan gathering;
        for (const PlannedView& view : views_of(plan))
            gathering.views.push_back(view.wo);
        gathering.lights = lights_of(plan);
        gathering.base_alpha = static_cast<double>(plan.material.base_alpha);
        gathering.grid = plan.grid;
        ErrorScale yardstick{{gathering.views, gathering.lights, {{75, 75, 0, 4}}}, {}, {}};
        std::vector<Appearance> halves[2], plain;
        int half_blind = 0;
        std::vector<std::vector<Appearance>> shown(maps.twins.size());
        const auto picked = pick_texels(set, 0, plan.footprints, plan.seed);
        for (size_t i = 0; i < picked.size(); ++i) {
            const auto truth = gather(surface, picked[i].footprint, gathering, i);
            yardstick.truth.push_back(appearance_of(truth.all, plan.material.f0));
            yardstick.area.emplace_back();
            for (const auto& seen : truth.all.seen)
                yardstick.area.back().push_back(seen.area);
            for (size_t half = 0; half < 2; ++half)
                halves[half].push_back(appearance_of(truth.halves[half], plan.material.f0));
            for (size_t v = 0; v < gathering.views.size(); ++v) {
                if (truth.halves[0].seen[v].area > 0 && truth.halves[1].seen[v].area > 0)
                    continue;
                ++half_blind; // a half that sees nothing tells no noise
                const size_t lights = gathering.lights.size();
                halves[1].back().color[v] = halves[0].back().color[v];
                for (size_t l = v * lights; l < (v + 1) * lights; ++l)
                    halves[1].back().radiance[l] = halves[0].back().radiance[l];
            }
            FootprintData data;
            data.set = picked[i].texel;
            data.normal = filter::normal(filter::Vec2<float>(data.set.slope.s, data.set.slope.t));
            const MethodSetting setting{plan.material, nullptr};
            plain.push_back(
                appearance_of(method_named("naive MIP"), data, setting, yardstick.views));
            for (size_t m = 0; m < shown.size(); ++m)
                if (*maps.twins[m] != 0)
                    shown[m].push_back(
                        appearance_of(method_named(maps.twins[m]), data, setting, yardstick.views));
        }
        const auto errors_of = [&](const std::vector<Appearance>& of) {
            return rms_differences(yardstick, of, yardstick.truth).front();
        };
        const RelativeErrors best = errors_of(shown.back()), mip = errors_of(plain);
        EXPECT_GT(half_blind, 0);
        const RelativeErrors noise = rms_differences(yardstick, halves[0], halves[1]).front();
        const char* name = maps.twins.back();
        constexpr double kSingle = 1e-5; // of errors of a tenth and more
        EXPECT_NEAR(found.color.set, best.color, kSingle) << name;
        EXPECT_NEAR(found.radiance.set, best.radiance, kSingle) << name;
        EXPECT_NEAR(found.color.plain, mip.color, kSingle) << name;
        EXPECT_NEAR(found.radiance.plain, mip.radiance, kSingle) << name;
        EXPECT_NEAR(found.color.noise, noise.color / 2, kSingle) << name;
        EXPECT_NEAR(found.radiance.noise, noise.radiance / 2, kSingle) << name;
        ASSERT_EQ(found.models.size(), maps.twins.size());
        for (size_t m = 0; m < shown.size(); ++m) {
            if (shown[m].empty())
                continue;
            EXPECT_NEAR(found.models[m], errors_of(shown[m]).color, kSingle) << name << m;
        }
        EXPECT_GT(found.color.plain, 0.05) << "a view that nothing is seen differently in";
    }
}

TEST(ViewCheck, ViewsGoRoundFromTheNormal)
{
    ViewPlan plan;
    plan.angles_deg = {0, 60};
    plan.azimuths = 3;
    const auto views = views_of(plan);
    ASSERT_EQ(views.size(), 4U);
    EXPECT_DOUBLE_EQ(views[0].wo.z, 1);
    for (size_t i = 1; i < 4; ++i) {
        EXPECT_NEAR(views[i].wo.z, 0.5, 1e-15);
        EXPECT_NEAR(views[i].wo.length(), 1, 1e-15);
        EXPECT_EQ(views[i].angle, 1U);
    }
    // From +s (right) towards +t (down).
    EXPECT_GT(views[2].wo.y, 0);
}

} // namespace
} // namespace scree::test
