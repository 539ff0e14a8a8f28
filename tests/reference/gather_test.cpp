#include "reference/gather.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "math/error.h"
#include "reference/gathered.h"
#include "reference/reliefs.h"
#include "reference/rough_plane.h"

namespace scree::reference {
namespace {

using test::direction;
using test::kPi;
using test::radians;
using test::values;
using test::whole;

Relief ramp(double slope_s, double slope_t)
{
    Relief relief = test::relief_of(8, 5, [&](int x, int y) { return slope_s * x + slope_t * y; });
    relief.beyond_s = relief.beyond_t = Beyond::extends;
    return relief;
}

TEST(Gather, PlanesAreSeenWhole)
{
    GatherPlan plan;
    plan.views = {direction(0, 0), direction(60, 30), direction(89.9, 200)};
    plan.lights = {direction(45, 100), direction(89.9, 10)};
    const Vec2 slopes[] = {{0, 0}, {0.001, -0.0005}, {-0.25, 0.125}};
    for (const Vec2& slope : slopes)
        for (const Beyond beyond : {Beyond::extends, Beyond::repeats}) {
            Relief relief = ramp(slope.x, slope.y);
            if (beyond == Beyond::repeats && slope.length() > 0)
                continue; // a ramp that repeats is a saw
            relief.beyond_s = relief.beyond_t = beyond;
            const DisplacedSurface surface(relief);
            const Gathered all = gather(surface, whole(relief), plan, 0).all;
            const double length = std::sqrt(1 + slope.length2());
            for (size_t v = 0; v < plan.views.size(); ++v) {
                const Vec3 w = plan.views[v];
                const double area = w.z - w.x * slope.x - w.y * slope.y;
                const Seen& seen = all.seen[v];
                EXPECT_NEAR(seen.area, std::max(0.0, area), 1e-13) << v;
                EXPECT_EQ(seen.g1(), area > 0 ? 1 : 0) << v;
                if (area <= 0)
                    continue;
                EXPECT_NEAR((seen.slope - slope).length(), 0, 1e-13) << v;
                EXPECT_NEAR(seen.covariance[0] + seen.covariance[2], 0, 1e-13) << v;
                for (size_t l = 0; l < plan.lights.size(); ++l) {
                    const Vec3 light = plan.lights[l];
                    const double cosine =
                        (light.z - light.x * slope.x - light.y * slope.y) / length;
                    const Lit& lit = all.lit[v * plan.lights.size() + l];
                    EXPECT_EQ(lit.share, cosine > 0 ? 1 : 0) << v << " " << l;
                    EXPECT_NEAR(lit.diffuse[0], std::max(0.0, cosine) / kPi, 1e-13) << v;
                    EXPECT_EQ(lit.white, lit.diffuse[0]) << v; // the plane is white
                    const double specular =
                        cosine > 0 ? test::mirrored_by_plane(w, light, slope, plan.base_alpha) : 0;
                    EXPECT_NEAR(lit.specular, specular, 1e-12 * specular) << v << " " << l;
                }
            }
        }
}

/// Share of the light from a direction that a plane of perfect mirrors gives back above the
/// texture plane; by exchange of view and light, which a BRDF does not feel.
double albedo(const Vec3& wo, const Vec2& slope, double base_alpha)
{
    constexpr int kSteps = 120; // midpoints, of both angles
    GatherPlan plan;
    plan.grid = 1;
    plan.base_alpha = base_alpha;
    plan.views = {wo};
    std::vector<double> solid_angles;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < 2 * kSteps; ++j) {
            const double theta = 90 * (i + 0.5) / kSteps;
            plan.lights.push_back(direction(theta, 180 * (j + 0.5) / kSteps));
            solid_angles.push_back(std::sin(radians(theta)) * kPi / 2 / kSteps * kPi / kSteps);
        }
    const Relief relief = ramp(slope.x, slope.y);
    const Gathered all = gather(DisplacedSurface(relief), whole(relief), plan, 0).all;
    double sum = 0;
    for (size_t l = 0; l < solid_angles.size(); ++l)
        sum += all.lit[l].specular * solid_angles[l];
    return sum;
}

// From above nothing is hidden of the view, and little lies in shadow. Anywhere else a plane must
// not give more light than it gets, and loses at most what meets another facet.
TEST(Gather, PlanesMirrorNoMoreLightThanTheyGet)
{
    EXPECT_NEAR(albedo(direction(0, 0), {0, 0}, 0.2), 1, 0.005);
    const Vec2 slopes[] = {{0, 0}, {0.25, 0}, {-0.25, 0.125}};
    for (const Vec2& slope : slopes)
        for (const double theta : {0.0, 55.0, 74.0, 84.0, 87.0}) {
            const Vec3 wo = direction(theta, 180);
            if (wo.z - wo.x * slope.x < 0.02)
                continue; // turned away
            const double share = albedo(wo, slope, 0.3);
            EXPECT_LE(share, 1) << theta << " slope " << slope.x;
            EXPECT_GT(share, 0.5) << theta << " slope " << slope.x;
        }
}

TEST(Gather, WhereNothingIsSeenAllIsZero)
{
    GatherPlan plan;
    plan.views = {direction(60, 0), direction(60, 180)};
    plan.lights = {direction(60, 0), direction(60, 180)};
    const Relief steep = ramp(5, 0); // turned away from +s
    const DisplacedSurface surface(steep);
    const Gathered away = gather(surface, whole(steep), plan, 0).all;
    for (const double value : values({{away.seen[0]}, {away.lit[0], away.lit[1]}}))
        EXPECT_EQ(value, 0);
    EXPECT_EQ(away.seen[0].g1(), 0);
    EXPECT_GT(away.seen[1].area, 0);
    EXPECT_EQ(away.lit[2].share, 0); // seen, but not lit
    EXPECT_EQ(away.lit[2].color, Rgb{});
    EXPECT_EQ(away.lit[3].share, 1);

    Relief empty = ramp(0, 0);
    empty.weights.assign(empty.heights.size(), 0.0F);
    const Estimate nothing = gather(DisplacedSurface(empty), whole(empty), plan, 0);
    EXPECT_EQ(nothing.samples, 0);
    EXPECT_EQ(nothing.rays, 0);
    for (const double value : values(nothing.all))
        EXPECT_EQ(value, 0);

    plan.grid = 1; // one sample: a half is of none
    const Relief flat = ramp(0, 0);
    const Estimate one = gather(DisplacedSurface(flat), whole(flat), plan, 0);
    EXPECT_EQ(one.halves[0].seen[0].g1() + one.halves[1].seen[0].g1(), 1);
    for (const Gathered& half : one.halves)
        for (const double value : values(half))
            EXPECT_TRUE(std::isfinite(value));
    EXPECT_EQ(one.all.seen[0].g1(), 1);
}

bool same_bytes(const Gathered& a, const Gathered& b)
{
    const std::vector<double> x = values(a), y = values(b);
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

TEST(Gather, ThreadsChangeNoByte)
{
    const Relief relief = test::rough_relief(33, 17, 12);
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = 8;
    plan.views = {direction(30, 0), direction(80, 50)};
    plan.lights = {direction(60, 100)};
    std::vector<Footprint> footprints;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            footprints.push_back(footprint_of(33, 17, 1, x, y));

    std::vector<std::vector<Estimate>> runs;
    for (const size_t threads : {1u, 2u, 5u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        runs.push_back(gather_all(surface, footprints, plan));
    }
    for (size_t i = 0; i < footprints.size(); ++i) {
        const Estimate alone = gather(surface, footprints[i], plan, i);
        for (const auto& run : runs) {
            EXPECT_TRUE(same_bytes(run[i].all, alone.all)) << i;
            EXPECT_TRUE(same_bytes(run[i].halves[0], alone.halves[0])) << i;
            EXPECT_TRUE(same_bytes(run[i].halves[1], alone.halves[1])) << i;
            EXPECT_EQ(run[i].rays, alone.rays) << i;
        }
    }
    // Equal footprints have jitter of their own, and so has another seed.
    const double area = runs[0][0].all.seen[1].area;
    EXPECT_GT(std::abs(gather(surface, footprints[0], plan, 1).all.seen[1].area - area), 1e-6);
    plan.seed = 2;
    EXPECT_GT(std::abs(gather(surface, footprints[0], plan, 0).all.seen[1].area - area), 1e-6);
}

// A common factor of the weights, a power of two so that nothing is rounded, cancels.
TEST(Gather, OnlyRatiosOfWeightsCount)
{
    Relief relief = test::rough_relief(16, 16, 14);
    GatherPlan plan;
    plan.views = {direction(30, 0), direction(80, 50)};
    plan.lights = {direction(60, 100), direction(20, 10)};
    const Gathered full = gather(DisplacedSurface(relief), whole(relief), plan, 0).all;
    relief.weights.assign(relief.heights.size(), 0.25F);
    const Gathered quarter = gather(DisplacedSurface(relief), whole(relief), plan, 0).all;
    EXPECT_TRUE(same_bytes(full, quarter));
}

TEST(Gather, ProgressIsToldAndMayStop)
{
    const Relief relief = test::rough_relief(16, 16, 13);
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.views = {direction(30, 0)};
    const std::vector<Footprint> footprints(50, whole(relief));
    double last = 0;
    gather_all(surface, footprints, plan, [&](double done) {
        EXPECT_GT(done, last);
        last = done;
    });
    EXPECT_EQ(last, 1);
    EXPECT_THROW(gather_all(surface, footprints, plan, [](double) { throw Cancelled(); }),
                 Cancelled);
}

// Rays: a view that a face is turned away from costs none, nor does a light behind it.
TEST(Gather, CountsTheRaysItCasts)
{
    const Relief relief = ramp(1, 0);
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = 4;
    plan.views = {direction(60, 180), direction(70, 0), direction(0, 0)};
    plan.lights = {direction(60, 180), direction(70, 0)};
    EXPECT_EQ(gather(surface, whole(relief), plan, 0).rays, 16 * 3);
}

} // namespace
} // namespace scree::reference
