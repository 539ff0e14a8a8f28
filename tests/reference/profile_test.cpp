// Reliefs that vary along s alone, where masking has a closed form.

#include <gtest/gtest.h>

#include <cmath>

#include "reference/gather.h"
#include "reference/gathered.h"
#include "reference/reliefs.h"
#include "reference/rough_plane.h"

namespace scree::reference {
namespace {

using test::direction;
using test::kPi;
using test::radians;
using test::whole;

constexpr int kPeriod = 16;    // texels
constexpr double kSlope = 0.5; // of the groove's sides, + and -

/// V-grooves along t: ridges at texel centre 0, valleys at texel centre 8, so the bilinear surface
/// is the grooves exactly. Texels 1 to 7, which face +s, are red, 9 to 15 blue, 0 and 8 green.
Relief grooves()
{
    Relief relief = test::relief_of(kPeriod, kPeriod,
                                    [](int x, int) { return kSlope * std::abs(x - kPeriod / 2); });
    for (int i = 0; i < kPeriod * kPeriod; ++i) {
        const int x = i % kPeriod;
        relief.colors.push_back(x % 8 == 0 ? Rgb{0, 1, 0} : x < 8 ? Rgb{1, 0, 0} : Rgb{0, 0, 1});
    }
    return relief;
}

/// Masking of the grooves across: where c = cot(theta) <= slope the far sides are turned away, the
/// near ones have projected area (cos + slope sin) / 2 and what is seen is the projection cos, so
///   G1 = 2 c / (c + slope);
/// where c > slope nothing hides anything.
double groove_g1(double theta)
{
    const double c = 1 / std::tan(radians(theta));
    return c > kSlope ? 1 : 2 * c / (c + kSlope);
}

// Of 256 strata along s one, the shadow's border, is a matter of chance in each of 256 rows: the
// standard deviation of G1 is at most 0.5 / 128 / 16 = 2.5e-4; 4 of these.
constexpr int kGrid = 256;
constexpr double kAccuracy = 1e-3;

TEST(Grooves, MaskingHasItsClosedForm)
{
    const Relief relief = grooves();
    const DisplacedSurface surface(relief);
    const double thetas[] = {60, 70, 75, 80, 85};
    const double rounded[] = {1.000, 0.843, 0.698, 0.521, 0.298};
    GatherPlan plan;
    plan.grid = kGrid;
    for (const double theta : thetas)
        for (const double azimuth : {0.0, 180.0, 90.0, 270.0})
            plan.views.push_back(direction(theta, azimuth));
    const Estimate estimate = gather(surface, whole(relief), plan, 0);
    EXPECT_EQ(estimate.samples, kGrid * kGrid);
    for (size_t v = 0; v < plan.views.size(); ++v) {
        const double theta = thetas[v / 4];
        EXPECT_NEAR(groove_g1(theta), rounded[v / 4], 5e-4) << theta;
        const double g1 = estimate.all.seen[v].g1();
        if (v % 4 < 2)
            EXPECT_NEAR(g1, groove_g1(theta), kAccuracy) << theta << " across " << v % 4;
        else
            EXPECT_EQ(g1, 1) << theta << " along " << v % 4;
    }
}

// What is seen where the far sides show (45 degrees) and where they do not (70).
TEST(Grooves, SlopesAndColorsSeenHaveTheirClosedForm)
{
    const Relief relief = grooves();
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = kGrid;
    plan.views = {direction(45, 0), direction(70, 0)};
    const Gathered all = gather(surface, whole(relief), plan, 0).all;

    // cot = 1: near sides (slope -0.5) show with weight 1.5, far ones with 0.5.
    EXPECT_NEAR(all.seen[0].slope.x, (-0.5 * 1.5 + 0.5 * 0.5) / 2, 1e-12);
    EXPECT_NEAR(all.seen[0].covariance[0], 0.25 * 0.75, 1e-12);
    EXPECT_NEAR(all.seen[0].covariance[1], 0, 1e-12);
    EXPECT_NEAR(all.seen[0].covariance[2], 0, 1e-12);
    EXPECT_NEAR(all.seen[0].color[0], 0.75 * 7 / 8, 1e-12);
    EXPECT_NEAR(all.seen[0].color[1], 1.0 / 8, 1e-12);
    EXPECT_NEAR(all.seen[0].color[2], 0.25 * 7 / 8, 1e-12);

    // Near sides alone, from the ridge down to where its shadow ends: half a green texel, then red.
    const double seen = 8 * groove_g1(70);
    EXPECT_NEAR(all.seen[1].area, std::cos(radians(70)), kAccuracy);
    EXPECT_NEAR(all.seen[1].slope.x, -0.5, 1e-12);
    EXPECT_NEAR(all.seen[1].covariance[0], 0, 1e-12);
    EXPECT_NEAR(all.seen[1].color[0], (seen - 0.5) / seen, kAccuracy);
    EXPECT_NEAR(all.seen[1].color[1], 0.5 / seen, kAccuracy);
    EXPECT_EQ(all.seen[1].color[2], 0);
}

// Seen along the grooves, where nothing is hidden and both sides show alike, with the light across.
TEST(Grooves, LightAcrossHasItsClosedForm)
{
    const Relief relief = grooves();
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = kGrid;
    plan.base_alpha = 0.3;
    plan.views = {direction(60, 90)};
    plan.lights = {direction(75, 0), direction(75, 180)};
    const Gathered all = gather(surface, whole(relief), plan, 0).all;
    for (size_t l = 0; l < 2; ++l) {
        const Lit& lit = all.lit[l];
        const Vec3 wo = plan.views[0], wi = plan.lights[l];
        const double slope = l == 0 ? -kSlope : kSlope; // of the sides that face the light
        const double share = groove_g1(75) / 2;         // of them, and half the area is theirs
        EXPECT_NEAR(lit.share, share, kAccuracy);

        const double length = 8 * groove_g1(75); // half a green texel, then red or blue
        const double cosine = (wi.z - wi.x * slope) / std::sqrt(1 + slope * slope);
        EXPECT_NEAR(lit.color[1], 0.5 / length, kAccuracy);
        EXPECT_NEAR(lit.color[2 * l], (length - 0.5) / length, kAccuracy);
        EXPECT_EQ(lit.color[2 - 2 * l], 0);
        EXPECT_NEAR(lit.diffuse[1], 0.5 / 16 * cosine / kPi, kAccuracy);
        EXPECT_NEAR(lit.diffuse[2 * l], (length - 0.5) / 16 * cosine / kPi, kAccuracy);
        EXPECT_NEAR(lit.white, length / 16 * cosine / kPi, kAccuracy);

        const double each = test::mirrored_by_plane(wo, wi, {slope, 0}, plan.base_alpha);
        EXPECT_NEAR(lit.specular, share * each, kAccuracy * each);
    }
}

// Who looks along the light sees no shadow.
TEST(Grooves, WhatIsSeenFromTheLightIsLit)
{
    const Relief relief = grooves();
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.views = plan.lights = {direction(80, 20)};
    const Gathered all = gather(surface, whole(relief), plan, 0).all;
    EXPECT_LT(all.seen[0].g1(), 0.8);
    EXPECT_EQ(all.lit[0].share, 1);
    EXPECT_EQ(all.lit[0].color, all.seen[0].color);
}

/// Share of a period of a sin(x) in shadow, by root finding: from where the surface turns away from
/// the light, a cos(x) = cot(theta) on the far side of the crest, to where the ray over that point
/// comes down on the surface again.
double sine_shadow(double amplitude, double theta)
{
    const double c = 1 / std::tan(radians(theta));
    if (amplitude <= c)
        return 0;
    // The light comes from +x, so shadows lie on the side where the height grows with x.
    const double touch = std::acos(c / amplitude); // a cos = c, before the crest at pi / 2
    auto above = [&](double x) {
        return amplitude * std::sin(touch) + c * (x - touch) - amplitude * std::sin(x);
    };
    double low = -touch, high = touch - 2 * kPi; // in between above() is positive at first
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = (low + high) / 2;
        (above(middle) > 0 ? low : high) = middle;
    }
    return (touch - low) / (2 * kPi);
}

// Half a texel, 1 / 1024 of the period, on either side: the surface is flat between texel centres.
TEST(Sine, ShadowsHaveTheLengthThatRootFindingGives)
{
    constexpr int kTexels = 512;
    const double height = 0.8; // slopes up to 0.8
    const Relief relief = test::relief_of(kTexels, 1, [&](int x, int) {
        return height * kTexels / (2 * kPi) * std::sin(2 * kPi * x / kTexels);
    });
    const DisplacedSurface surface(relief);
    constexpr int kPoints = 20000;
    for (const double theta : {45.0, 55.0, 60.0, 70.0, 80.0, 85.0, 89.0})
        for (const double azimuth : {0.0, 180.0}) {
            int hidden = 0;
            for (int k = 0; k < kPoints; ++k)
                hidden +=
                    !surface.is_open((k + 0.5) * kTexels / kPoints, 0.5, direction(theta, azimuth));
            EXPECT_NEAR(static_cast<double>(hidden) / kPoints, sine_shadow(height, theta),
                        1.0 / kTexels + 1.0 / kPoints)
                << theta << " " << azimuth;
        }
    EXPECT_GT(sine_shadow(height, 55), 0.05);
}

} // namespace
} // namespace scree::reference
