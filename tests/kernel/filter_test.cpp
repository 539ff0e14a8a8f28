// The C++ front on Imath vectors: raw moments in, and its limits.

#include "kernel/filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

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

// Directions next to upright and next to grazing, variances from nothing to the largest, slopes to
// a million, covariances that are none.
TEST(Front, EveryResultIsFiniteForFiniteInputs)
{
    std::mt19937 random(9);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    const auto magnitude = [&](double low, double high) { // powers of ten, or 0
        return random() % 8 == 0 ? 0.0 : std::pow(10.0, uniform(low, high));
    };
    const auto direction = [&] {
        const double sine = std::min(1.0, magnitude(-30, 0));
        // Every third along an axis: long thin covariances are seen along their short side there.
        const double phi = random() % 3 == 0 ? std::acos(0.0) * static_cast<double>(random() % 4)
                                             : uniform(-3.2, 3.2);
        return V3f(static_cast<float>(sine * std::cos(phi)),
                   static_cast<float>(sine * std::sin(phi)),
                   static_cast<float>(std::sqrt(1 - sine * sine)));
    };
    const auto sign = [&] { return random() % 2 == 0 ? 1.0 : -1.0; };
    for (int k = 0; k < 300000; ++k) {
        filter::Slopes<float> slopes;
        slopes.mean = {static_cast<float>(sign() * magnitude(-20, 6)),
                       static_cast<float>(sign() * magnitude(-20, 6))};
        const double ss = magnitude(-18, 12), tt = magnitude(-18, 12);
        slopes.covariance = {static_cast<float>(ss),
                             static_cast<float>(uniform(-1.1, 1.1) * std::sqrt(ss * tt)),
                             static_cast<float>(tt)};
        slopes.tau = k % 3 == 0 ? static_cast<float>(uniform(0, 1)) : 0;
        const V3f wo = direction(), wi = direction();
        const auto visible = filter::visible_slopes(wo, slopes);
        const auto masking = filter::masking(wo, slopes);
        const auto lobe = filter::beckmann_roughness(slopes.covariance, 0.1F);
        const V3f color = filter::color_by_slope(V3f(0.5F), V3f(0.1F), V3f(-0.1F), wo, slopes);
        const float numbers[] = {visible.area,
                                 visible.mean.x,
                                 visible.mean.y,
                                 visible.covariance.ss,
                                 visible.covariance.st,
                                 visible.covariance.tt,
                                 masking.lambda,
                                 masking.g1,
                                 lobe.alpha_x,
                                 lobe.alpha_y,
                                 lobe.angle_rad,
                                 color[0],
                                 filter::specular(wo, wi, slopes, 0.1F),
                                 filter::diffuse(wo, wi, slopes)};
        for (size_t i = 0; i < std::size(numbers); ++i)
            ASSERT_TRUE(std::isfinite(numbers[i]))
                << "number " << i << " wo " << wo << " wi " << wi << " mean " << slopes.mean
                << " covariance " << slopes.covariance.ss << ' ' << slopes.covariance.st << ' '
                << slopes.covariance.tt << " tau " << slopes.tau;
    }
}

} // namespace
} // namespace scree::test
