#include "reference/gather.h"

#include <gtest/gtest.h>

#include "reference/reliefs.h"

namespace scree::reference {
namespace {

using test::direction;
using test::kPi;

Footprint whole(const Relief& relief)
{
    return footprint_of(relief.width, relief.height, level_count(relief.width, relief.height) - 1,
                        0, 0);
}

TEST(Gather, AFlatPlaneIsSeenWhole)
{
    const Relief relief = test::relief_of(8, 8, [](int, int) { return 3.0; });
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.views = {direction(0, 0), direction(60, 30), direction(89.9, 200)};
    plan.lights = {direction(45, 100)};
    const Estimate estimate = gather(surface, whole(relief), plan, 0);
    for (size_t v = 0; v < plan.views.size(); ++v) {
        const Seen& seen = estimate.all.seen[v];
        EXPECT_NEAR(seen.area, plan.views[v].z, 1e-14);
        EXPECT_EQ(seen.g1(), 1);
        EXPECT_NEAR(estimate.all.lit[v].diffuse[0], plan.lights[0].z / kPi, 1e-14);
        EXPECT_EQ(seen.slope, Vec2(0, 0));
    }
}

TEST(Gather, WhatIsSeenOfAPeriodicMapIsItsProjection)
{
    const Relief relief = test::rough_relief(16, 16, 1);
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = 128;
    for (double theta : {30.0, 60.0, 80.0, 88.0})
        for (int azimuth = 0; azimuth < 360; azimuth += 45)
            plan.views.push_back(direction(theta, azimuth));
    const Estimate estimate = gather(surface, whole(relief), plan, 0);
    for (size_t v = 0; v < plan.views.size(); ++v)
        EXPECT_NEAR(estimate.all.seen[v].area / plan.views[v].z, 1, 0.03) << v;
}

} // namespace
} // namespace scree::reference
