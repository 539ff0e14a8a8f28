#include "judge/view_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "judge/original.h"
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
ViewCheck checked(MemorySource source, BakeOptions options, const ViewPlan& plan)
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
    plan.material.f0 = 0; // the kernel's lobe hides parts of itself, the reference's does not
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

    // The narrower the lobe, the less that is, away from grazing angles.
    plan.angles_deg = {0, 30};
    plan.lights_deg = {{20, 30}};
    plan.material = {0.05F, 0.04F};
    EXPECT_LT(checked(source, options, plan).all.back().radiance.set, 1e-4);
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
