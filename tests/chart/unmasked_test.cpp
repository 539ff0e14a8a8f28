#include "chart/unmasked.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {
namespace {

TEST(Toksvig, FullLengthAddsNothing)
{
    const auto slopes = toksvig_slopes(filter::normal(filter::Vec2<float>(0.5F, -0.25F)), 0.3F);
    EXPECT_NEAR(slopes.mean.x, 0.5, 1e-6);
    EXPECT_NEAR(slopes.mean.y, -0.25, 1e-6);
    EXPECT_NEAR(slopes.covariance.ss, 0, 1e-6);
    EXPECT_NEAR(slopes.covariance.tt, 0, 1e-6);
}

// By hand: s = 2 / 0.09 - 2 = 20.2222, times 0.5 / (0.5 + 0.5 s) is 0.952880; its roughness squared
// 2 / 2.952880 = 0.677305, of which 0.09 are the material's.
TEST(Toksvig, HasTheValueOfItsFormula)
{
    const auto slopes = toksvig_slopes({0, 0, 0.5F}, 0.3F);
    EXPECT_NEAR(slopes.covariance.ss, (0.677305 - 0.09) / 2, 1e-5);
}

// Oracle: the mean normal of Gaussian slopes of deviation sigma by quadrature in polar coordinates,
// E[(1 + r^2)^(-1/2)]. To first order in sigma^2 the covariance comes back.
TEST(Toksvig, RecoversASmallSpread)
{
    for (const double sigma : {0.02, 0.05}) {
        double length = 0;
        const int steps = 20000;
        for (int i = 0; i < steps; ++i) {
            const double u = (i + 0.5) / steps; // P(r^2 > x) = exp(-x / (2 sigma^2))
            length += 1 / std::sqrt(1 - 2 * sigma * sigma * std::log(u)) / steps;
        }
        const auto slopes = toksvig_slopes({0, 0, static_cast<float>(length)}, 0.1F);
        // Powers and Beckmann roughness agree to first order in alpha^2, 0.01.
        EXPECT_NEAR(slopes.covariance.ss / (sigma * sigma), 1, 0.03) << sigma;
        EXPECT_EQ(slopes.covariance.ss, slopes.covariance.tt);
        EXPECT_EQ(slopes.covariance.st, 0);
    }
}

} // namespace
} // namespace scree
