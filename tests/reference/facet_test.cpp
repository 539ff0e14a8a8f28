// Rough faces, from the definitions.

#include "reference/facet.h"

#include <gtest/gtest.h>

#include "reference/reliefs.h"
#include "reference/rough_plane.h"

namespace scree::reference {
namespace {

using test::direction;
using test::kPi;
using test::radians;

TEST(Facet, OwnMaskingIsTheIntegralItStandsFor)
{
    for (const Vec2& slope : {Vec2(0, 0), Vec2(0.5, -0.25), Vec2(-2, 1)})
        for (const double theta : {0.0, 30.0, 60.0, 80.0, 89.9})
            for (const double base_alpha : {0.001, 0.1, 0.3, 1.0}) {
                const Vec3 w = direction(theta, 170);
                const double area = towards(w, slope);
                if (!(area > 0))
                    continue;
                const double expected = test::own_lambda(w, slope, base_alpha);
                EXPECT_NEAR(OwnMasking(w, base_alpha).lambda(area), expected,
                            1e-13 * (1 + expected))
                    << slope.x << " " << theta << " " << base_alpha;
            }
}

// Radiance goes by 1 / (a (1 + Lambda)): towards edge-on that is 1 over the mean of the areas that
// are turned to the view, of a Gaussian about 0. At 1e-6 it is short of that by 6e-6.
TEST(Facet, WhatMasksItselfStaysFiniteEdgeOn)
{
    const Vec3 wo = direction(80, 0), wi = direction(60, 100);
    const MirrorLobe lobe(wo, wi, 0.3);
    for (const double area : {1e-6, 1e-100, 1e-300}) {
        const Vec2 slope = {(wo.z - area) / wo.x, 0};
        const double lambda_o = OwnMasking(wo, 0.3).lambda(area);
        const double radiance = lobe.at(slope, lambda_o, 0) / area;
        const double spread = 0.3 / std::sqrt(2.0) * wo.x;
        const double seen = spread / std::sqrt(2 * kPi);
        EXPECT_NEAR(radiance, lobe.at(slope, 0, 0) / seen, 1e-5 * radiance) << area;
    }
}

// With the masking of the view alone all that a face shows mirrors some light, of above or below:
// over all of them the lobe adds up to 1, whatever the slope. This sum's midpoints do so to 3e-4.
TEST(Facet, LobesShowAllThatIsSeen)
{
    constexpr int kSteps = 300; // a right angle
    for (const Vec2& slope : {Vec2(0, 0), Vec2(0.5, -0.25), Vec2(-0.5, 0.5)})
        for (const double theta : {0.0, 60.0, 84.0}) {
            const Vec3 wo = direction(theta, 190);
            const double area = towards(wo, slope);
            if (!(area > 0))
                continue;
            const double lambda = OwnMasking(wo, 0.3).lambda(area);
            double sum = 0;
            for (int i = 0; i < 2 * kSteps; ++i)
                for (int j = 0; j < 2 * kSteps; ++j) {
                    const double from_above = 90 * (i + 0.5) / kSteps;
                    const Vec3 wi = direction(from_above, 180 * (j + 0.5) / kSteps);
                    if (!(wo.z + wi.z > 0))
                        continue; // mirrored by an overhang
                    const double solid_angle =
                        std::sin(radians(from_above)) * kPi / 2 / kSteps * kPi / kSteps;
                    sum += MirrorLobe(wo, wi, 0.3).at(slope, lambda, 0) / area * solid_angle;
                }
            EXPECT_NEAR(sum, 1, 4e-4) << slope.x << " " << theta;
        }
}

} // namespace
} // namespace scree::reference
