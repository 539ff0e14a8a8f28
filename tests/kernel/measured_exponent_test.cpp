// The exponent as it was measured of an asset, through the C++ front.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/filter.h"

namespace scree::test {
namespace {

using Imath::V3d;

const double kPi = std::acos(-1.0);

V3d toward(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Smith 1967: Lambda of Gaussian slopes of mean 0 and deviation sigma along the azimuth.
double smith_lambda(double theta, double sigma)
{
    const double nu = 1 / (std::tan(theta) * sigma * std::sqrt(2.0));
    return std::exp(-nu * nu) / (2 * nu * std::sqrt(kPi)) - std::erfc(nu) / 2;
}

// A mean plane that tilts towards the viewer, away from him, out of his sight: it counts as spread.
// Tolerance: the kernel's fit of Lambda, 1e-8 relative, and the cancellation of the oracle, 1e-16.
TEST(MeasuredExponent, IsByDefaultSmithsLambdaOfTheSecondMoments)
{
    for (const double tilt : {-3.0, -0.4, 0.0, 0.4, 3.0})
        for (const double theta : {0.3, 0.9, 1.4, 1.56})
            for (const double phi : {0.0, 0.7, -2.5}) {
                const double ms = tilt, mt = 0.5 * tilt;
                const double ss = 0.09 + ms * ms, st = 0.03 + ms * mt, tt = 0.04 + mt * mt;
                const double c = std::cos(phi), s = std::sin(phi);
                const double sigma = std::sqrt(c * c * ss + 2 * c * s * st + s * s * tt);
                const double want = smith_lambda(theta, sigma);
                EXPECT_NEAR(filter::measured_exponent(toward(theta, phi), {ms, ss, st, mt, tt}, 0.0,
                                                      filter::Exponent<double>()),
                            want, 2e-8 * want + 1e-15)
                    << "tilt " << tilt << " theta " << theta << " phi " << phi;
            }
}

TEST(MeasuredExponent, TakesTheTailsAsTheyAre)
{
    filter::Slopes<double> slopes;
    slopes.covariance = {0.09, 0.03, 0.04};
    slopes.tau = 0.4;
    const V3d w = toward(1.2, 0.5);
    EXPECT_DOUBLE_EQ(
        filter::measured_exponent(w, {0.0, 0.09, 0.03, 0.0, 0.04}, 0.4, filter::Exponent<double>()),
        filter::masking(w, slopes).lambda);
}

TEST(MeasuredExponent, IsAPowerOfWhatIsAboveItsThreshold)
{
    EXPECT_DOUBLE_EQ(kernel::scree_measured_exponent(0.35, 3.0, 2.0, 0.1), 3.0 * 0.25 * 0.25);
    EXPECT_DOUBLE_EQ(kernel::scree_measured_exponent(4.0, 2.0, 0.5, 0.0), 4.0);
    EXPECT_DOUBLE_EQ(kernel::scree_measured_exponent(1e-12, 1.0, 0.5, 0.0), 1e-6);
    EXPECT_EQ(kernel::scree_measured_exponent(1e6, 0.0, 3.0, 0.0), 0) << "the mean color";
    EXPECT_EQ(kernel::scree_measured_exponent(1e6F, 8.0F, 3.0F, 0.0F), 1e6F) << "infinity stays";
    for (const double power : {0.1, 1.0, 3.0})
        for (const double lambda : {0.0, 0.1, 0.3}) // 0^power is 0, less than nothing too
            EXPECT_EQ(kernel::scree_measured_exponent(lambda, 8.0, power, 0.3), 0)
                << lambda << ' ' << power;
}

// Filters with negative lobes, halves that overflowed, views along and under the plane.
TEST(MeasuredExponent, IsFiniteWhateverIsLookedUp)
{
    const float infinite = std::numeric_limits<float>::infinity();
    const filter::SlopeMoments<float> looked_up[] = {{0, -1e-3F, 0.2F, 0, 0.04F},
                                                     {0, 0, 0, 0, 0},
                                                     {9, 1e-20F, 0, 9, 1e-20F},
                                                     {100, infinite, 0, 100, infinite}};
    for (const auto& raw : looked_up)
        for (const double theta : {0.0, 1.0, kPi / 2, 2.0})
            for (const float power : {0.1F, 3.0F}) {
                const float got = filter::measured_exponent(Imath::V3f(toward(theta, 0.5)), raw,
                                                            0.2F, {8.0F, power, 0.05F});
                EXPECT_TRUE(got >= 0 && got <= 1e6F) << got << " at " << theta << ' ' << raw.ss;
            }
}

} // namespace
} // namespace scree::test
