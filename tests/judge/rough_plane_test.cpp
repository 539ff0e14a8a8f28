// What the kernel reflects of a plane is what the reference does.

#include <gtest/gtest.h>

#include "kernel/filter.h"
#include "reference/gather.h"
#include "reference/gathered.h"
#include "reference/reliefs.h"

namespace scree::test {
namespace {

// The kernel's formulas in double have an error of 4e-8 (scree_gaussian_view).
TEST(RoughPlane, TheKernelsLobeIsTheReferences)
{
    reference::GatherPlan plan;
    plan.grid = 1;
    for (const double azimuth : {0.0, 100.0, 190.0})
        for (const double theta : {0.0, 55.0, 74.0, 84.0, 87.0})
            plan.views.push_back(direction(theta, azimuth));
    for (const double azimuth : {20.0, 170.0, 260.0})
        for (const double theta : {5.0, 45.0, 70.0, 86.0})
            plan.lights.push_back(direction(theta, azimuth));
    int compared = 0;
    for (const Vec2& slope : {Vec2(0, 0), Vec2(0.25, -0.5), Vec2(-1.5, 1)})
        for (const double base_alpha : {0.1, 0.3, 0.8}) {
            reference::Relief relief =
                relief_of(4, 4, [&](int x, int y) { return slope.x * x + slope.y * y; });
            relief.beyond_s = relief.beyond_t = reference::Beyond::extends;
            plan.base_alpha = base_alpha;
            const reference::Gathered all =
                gather(reference::DisplacedSurface(relief), whole(relief), plan, 0).all;
            filter::Slopes<double> slopes;
            slopes.mean = slope;
            for (size_t i = 0; i < all.lit.size(); ++i) {
                const Vec3& wo = plan.views[i / plan.lights.size()];
                const Vec3& wi = plan.lights[i % plan.lights.size()];
                if (wo.z - wo.x * slope.x - wo.y * slope.y <= 0)
                    continue; // the kernel's facets show on where their mean does not
                const double kernel = filter::specular(wo, wi, slopes, base_alpha);
                EXPECT_NEAR(all.lit[i].specular, kernel, 1e-7 * kernel + 1e-100)
                    << slope.x << " " << base_alpha << " pair " << i;
                compared += kernel > 1e-6 ? 1 : 0;
            }
        }
    EXPECT_GT(compared, 500);
}

} // namespace
} // namespace scree::test
