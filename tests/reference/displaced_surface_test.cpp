#include "reference/displaced_surface.h"

#include <gtest/gtest.h>

#include "reference/reliefs.h"

namespace scree::reference {
namespace {

TEST(DisplacedSurface, RaysFromAboveMeetTheHeightBelow)
{
    const Relief relief = test::rough_relief(33, 17, 2);
    const DisplacedSurface surface(relief);
    test::Uniform uniform(3);
    for (int k = 0; k < 1000; ++k) {
        const double s = uniform() * 33, t = uniform() * 17;
        const auto hit = surface.hit({s, t, 7}, {0, 0, -1});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->distance, 7 - surface.at(s, t).height, 1e-12);
        EXPECT_NEAR(hit->s, s, 1e-12);
        EXPECT_NEAR(hit->t, t, 1e-12);
    }
}

} // namespace
} // namespace scree::reference
