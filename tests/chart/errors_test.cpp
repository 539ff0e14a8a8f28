#include "chart/errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "chart/views.h"

namespace scree {
namespace {

/// Two footprints, two bands of one view each, two lights.
ErrorScale toy()
{
    ErrorScale yardstick;
    yardstick.views.views = {{0, 0, 1}, {0.6, 0, 0.8}};
    yardstick.views.lights = {{0, 0, 1}, {0, 0.6, 0.8}};
    yardstick.views.bands = {{0, 30, 0, 1}, {30, 60, 1, 1}};
    yardstick.truth = {{{{1, 0, 0}, {0, 2, 0}}, {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}},
                       {{{0, 0, 1}, {2, 0, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}};
    yardstick.area = {{1, 3}, {2, 1}};
    return yardstick;
}

TEST(RmsDifferences, AreOverViewsLightsAndChannelsByArea)
{
    const ErrorScale yardstick = toy();
    std::vector<Appearance> shown = yardstick.truth;
    shown[0].color[0] = {1, 0.5, 0};        // band 0, area 1: 0.25
    shown[1].color[0] = {0, 0, 2};          // band 0, area 2: 1
    shown[0].color[1] = {1, 2, 0};          // band 1, area 3: 1
    shown[0].radiance[1] = {2, 2, 3};       // band 0, area 1, second light: 1
    shown[1].radiance[2] = {0.5, 0.5, 0.5}; // band 1, area 1, first light: 3 / 4
    const auto errors = rms_differences(yardstick, shown, yardstick.truth);
    ASSERT_EQ(errors.size(), 2U);
    // Truth: color 1 * 1 + 2 * 1, 3 * 4 + 1 * 4; radiance 1 * (3 + 12) + 2 * (1 + 1),
    // 3 * (27 + 48) + 1 * (1 + 1).
    EXPECT_DOUBLE_EQ(errors[0].color, std::sqrt((0.25 + 2) / 3));
    EXPECT_DOUBLE_EQ(errors[1].color, std::sqrt(3.0 / 16));
    EXPECT_DOUBLE_EQ(errors[0].radiance, std::sqrt(1.0 / 19));
    EXPECT_DOUBLE_EQ(errors[1].radiance, std::sqrt(0.75 / 227));
}

TEST(RmsDifferences, OfTheTruthFromItselfAreNone)
{
    const ErrorScale yardstick = toy();
    for (const RelativeErrors& errors :
         rms_differences(yardstick, yardstick.truth, yardstick.truth)) {
        EXPECT_EQ(errors.color, 0);
        EXPECT_EQ(errors.radiance, 0);
    }
}

TEST(RmsDifferences, WhatIsNotSeenDoesNotCount)
{
    ErrorScale yardstick = toy();
    yardstick.area[0][0] = 0;
    std::vector<Appearance> shown = yardstick.truth;
    shown[0].color[0] = {9, 9, 9};
    EXPECT_EQ(rms_differences(yardstick, shown, yardstick.truth)[0].color, 0);
}

TEST(Appearance, OfTheReferenceAddsItsLobe)
{
    reference::Gathered gathered;
    gathered.seen.resize(1);
    gathered.seen[0].color = {0.5, 0.25, 1};
    gathered.lit.resize(1);
    gathered.lit[0].diffuse = {0.1, 0.2, 0.3};
    gathered.lit[0].specular = 2;
    const Appearance appearance = appearance_of(gathered, 0.5F);
    EXPECT_EQ(appearance.color[0], (Rgb{0.5, 0.25, 1}));
    EXPECT_EQ(appearance.radiance[0], (Rgb{1.1, 1.2, 1.3}));
}

TEST(ChartViews, LieInTheirBands)
{
    const ChartViews all = chart_views();
    ASSERT_EQ(all.bands.size(), 4U);
    size_t next = 0;
    for (const ViewBand& band : all.bands) {
        EXPECT_EQ(band.first, next);
        next += band.count;
        for (size_t i = band.first; i < next; ++i) {
            const Vec3& view = all.views[i];
            const double angle = std::acos(view.z) * 180 / 3.14159265358979323846;
            EXPECT_NEAR(view.length(), 1, 1e-12);
            EXPECT_GT(angle, band.from_deg);
            EXPECT_LT(angle, band.to_deg);
        }
    }
    EXPECT_EQ(next, all.views.size());
    EXPECT_EQ(all.bands.back().name(), "75-85");
}

// No view in the plane of a light, nor along an axis: a dropped cross term would not show there.
TEST(ChartViews, FavourNoDirection)
{
    const ChartViews all = chart_views();
    for (const Vec3& view : all.views) {
        EXPECT_GT(std::abs(view.x * view.y), 0.01 * (view.x * view.x + view.y * view.y));
        for (const Vec3& light : all.lights)
            EXPECT_GT(std::abs(view.x * light.y - view.y * light.x),
                      0.05 * std::hypot(view.x, view.y) * std::hypot(light.x, light.y));
    }
}

} // namespace
} // namespace scree
