// The C++ front on Imath vectors: raw moments in, and its limits.

#include "kernel/filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::test {
namespace {

using Imath::V2f;
using Imath::V3d;
using Imath::V3f;

TEST(Slopes, OfRawMomentsAreMeanAndCovariance)
{
    // Slopes (0, 0) and (1, 0.5), evenly: moments exact in float.
    const auto slopes = filter::slopes<float>({0.5F, 0.5F, 0.25F, 0.25F, 0.125F}, 0.25F);
    EXPECT_EQ(slopes.mean, V2f(0.5F, 0.25F));
    EXPECT_EQ(slopes.covariance.ss, 0.25F);
    EXPECT_EQ(slopes.covariance.st, 0.125F);
    EXPECT_EQ(slopes.covariance.tt, 0.0625F);
    EXPECT_EQ(slopes.tau, 0.25F);
}

// Negative lobes of a filter, half floats: variance below 0, covariance too large.
TEST(Slopes, ThatNoSurfaceHasAreMendedToTheNearestThatOneCould)
{
    const auto negative = filter::slopes<float>({1, 0.9F, 0.5F, 0, 0.04F});
    EXPECT_EQ(negative.covariance.ss, 0);
    EXPECT_EQ(negative.covariance.st, 0);
    EXPECT_FLOAT_EQ(negative.covariance.tt, 0.04F);
    const auto crossed = filter::slopes<float>({0, 0.04F, -0.5F, 0, 0.09F});
    EXPECT_FLOAT_EQ(crossed.covariance.st, -0.06F);
}

TEST(Slopes, OfOverflownHalfFloatsAreFinite)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const auto slopes = filter::slopes<float>({300, infinity, infinity, -300, infinity});
    const auto visible = filter::visible_slopes(V3f(0.6F, 0, 0.8F), slopes);
    for (const float value : {slopes.covariance.ss, slopes.covariance.st, visible.area,
                              visible.mean.x, visible.covariance.tt})
        EXPECT_TRUE(std::isfinite(value));
}

// At mean slope 1, sigma 0.05 the raw moments hold 1.0025: the variance survives in float32.
TEST(Slopes, KeepTheDigitsThatTheMomentsHave)
{
    const float mean = 1.1F;
    const float second = mean * mean + 0.0025F;
    const double exact = static_cast<double>(second) - static_cast<double>(mean) * mean;
    const auto slopes = filter::slopes<float>({mean, second, 0, 0, 0.01F});
    EXPECT_NEAR(static_cast<double>(slopes.covariance.ss) / exact, 1, 1e-7);
}

TEST(Front, GivesWhatTheKernelGives)
{
    filter::Slopes<double> slopes;
    slopes.mean = {0.1, -0.3};
    slopes.covariance = {0.2, 0.05, 0.1};
    slopes.tau = 0.3;
    const V3d w = V3d(0.7, -0.2, 0.4).normalized();
    double area = 0, s = 0, t = 0, ss = 0, st = 0, tt = 0, lambda = 0, g1 = 0;
    kernel::scree_visible_slopes(w.x, w.y, w.z, 0.1, -0.3, 0.2, 0.05, 0.1, 0.3, area, s, t, ss, st,
                                 tt);
    const auto visible = filter::visible_slopes(w, slopes);
    EXPECT_EQ(visible.area, area);
    EXPECT_EQ(visible.mean.x, s);
    EXPECT_EQ(visible.mean.y, t);
    EXPECT_EQ(visible.covariance.ss, ss);
    EXPECT_EQ(visible.covariance.st, st);
    EXPECT_EQ(visible.covariance.tt, tt);
    EXPECT_EQ(filter::projected_area(w, slopes), area);
    kernel::scree_masking(w.x, w.y, w.z, 0.1, -0.3, 0.2, 0.05, 0.1, 0.3, lambda, g1);
    EXPECT_EQ(filter::masking(w, slopes).lambda, lambda);
    EXPECT_EQ(filter::masking(w, slopes).g1, g1);
    EXPECT_EQ(filter::g2(filter::Masking<double>{1, 0}, filter::Masking<double>{2, 0}), 0.25);
}

// Case 6 of the failures: a groove at +45 degrees mirrors one at -45.
TEST(Front, MirroredSurfacesLookMirrored)
{
    filter::Slopes<double> up, down;
    up.covariance = {0.2, 0.19, 0.2};
    down.covariance = {0.2, -0.19, 0.2};
    up.mean = {0.1, 0.2};
    down.mean = {0.1, -0.2};
    for (double phi = -3; phi < 3; phi += 0.5) {
        const double theta = 1.3, x = std::sin(theta) * std::cos(phi),
                     y = std::sin(theta) * std::sin(phi), z = std::cos(theta);
        const auto a = filter::visible_slopes(V3d(x, y, z), up);
        const auto b = filter::visible_slopes(V3d(x, -y, z), down);
        EXPECT_NEAR(a.area, b.area, 1e-15);
        EXPECT_NEAR(a.mean.x, b.mean.x, 1e-15);
        EXPECT_NEAR(a.mean.y, -b.mean.y, 1e-15);
        EXPECT_NEAR(a.covariance.st, -b.covariance.st, 1e-15);
    }
}

// Case 7: Gaussian masking of a V-groove of slopes +-0.5, figures from a closed form in erf.
TEST(Front, GaussianMaskingOfAGrooveIsWhatGaussianMaskingIs)
{
    filter::Slopes<double> groove;
    groove.covariance = {0.25, 0, 0};
    for (const auto& [degrees, want] :
         {std::pair(60.0, 0.949), std::pair(70.0, 0.842), std::pair(75.0, 0.741),
          std::pair(80.0, 0.588), std::pair(85.0, 0.355)}) {
        const double theta = degrees * std::acos(-1.0) / 180;
        EXPECT_NEAR(filter::masking(V3d(std::sin(theta), 0, std::cos(theta)), groove).g1, want,
                    5e-4)
            << degrees;
    }
}

} // namespace
} // namespace scree::test
