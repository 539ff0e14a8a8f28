// Color maps by the length of a normal vector.

#include "color/magnitude_average.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>

#include "color/maps.h"
#include "color/normal_average.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

TEST(MagnitudeAverage, BesselFunctionMatchesItsIntegral)
{
    using boost::math::quadrature::gauss_kronrod;
    for (double x = 0; x < 1e6; x = x * 1.07 + 0.01) {
        const auto around = [x](double t) {
            return std::exp(-2 * x * std::pow(std::sin(t / 2), 2));
        };
        const double peak = std::min(kPi, 12 / std::sqrt(x + 1)); // e^-72 is left beyond
        double want = 0;
        for (int i = 0; i < 8; ++i)
            want +=
                gauss_kronrod<double, 31>::integrate(around, peak * i / 8, peak * (i + 1) / 8, 0) /
                kPi;
        EXPECT_NEAR(scaled_bessel_i0(x) / want, 1, 1e-13) << x;
    }
}

// Around zero the length follows Rayleigh's law.
TEST(MagnitudeAverage, AroundZeroItIsRayleighs)
{
    for (const double s : {1e-3, 0.2, 1.0, 30.0}) {
        for (const double r : {0.1, 0.5, 1.0, 3.0})
            EXPECT_NEAR(magnitude_average(step_map(r), 0, s)[0], std::exp(-r * r / (2 * s * s)),
                        1e-9)
                << s << " " << r;
        const double all = 100 * s; // a ramp over everything: the mean length
        EXPECT_NEAR(magnitude_average(ramp_map(0, all), 0, s)[0] * all, std::sqrt(kPi / 2) * s,
                    1e-9 * s);
    }
}

// Far from zero only the component along the mean is left, and mean + s^2 / (2 mean) for it.
TEST(MagnitudeAverage, FarFromZeroItIsNormal)
{
    const ColorMap map = hat_map(0.97, 1.0, 1.02);
    for (const double s : {1e-2, 1e-3, 1e-5})
        for (const double mean : {0.98, 1.0, 1.013}) {
            const Rgb want = normal_average(map, mean + s * s / (2 * mean), s);
            // what is left is of the order of (s / mean)^3 times the steepest slope
            EXPECT_LT(largest_difference(magnitude_average(map, mean, s), want),
                      100 * s * s * s + 2e-9)
                << s << " " << mean;
        }
}

TEST(MagnitudeAverage, WithoutDeviationItIsTheMap)
{
    const ColorMap map = random_map(2);
    for (double x = 0; x < 1.5; x += 0.01)
        EXPECT_EQ(magnitude_average(map, x, 0), map.at(x));
}

TEST(MagnitudeAverage, MatchesQuadratureOnMapsAtRandom)
{
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const ColorMap map = random_map(seed);
        for (const double mean : {0.0, 0.05, 0.4, 1.1})
            for (const double deviation : {0.06, 0.3, 2.0}) {
                const Rgb got = magnitude_average(map, mean, deviation);
                const Rgb want = magnitude_by_quadrature(map, mean, deviation);
                EXPECT_LT(largest_difference(got, want), 5e-9)
                    << "seed " << seed << " mean " << mean << " deviation " << deviation;
            }
    }
}

// The integral ends 9 deviations above the mean: here on a jump, whose far side is outside.
TEST(MagnitudeAverage, AJumpAtTheEndOfWhatIsIntegratedDoesNotCount)
{
    const ColorMap jump({{0, {}}, {9, {1, 1, 1}}, {9, {1000, 1000, 1000}}});
    EXPECT_NEAR(magnitude_average(jump, 0, 1)[0], std::sqrt(kPi / 2) / 9, 1e-9);
}

TEST(MagnitudeAverage, MatchesQuadratureOnRealMaps)
{
    const auto maps = real_maps();
    if (maps.empty())
        GTEST_SKIP() << "no folder of real data";
    for (const auto& [name, map] : maps) {
        const ColorMap slope = map.stretched(0, 2);
        const double span = color_span(slope, 0, 2);
        for (const double mean : {0.0, 0.7})
            for (const double deviation : {0.15, 0.8})
                EXPECT_LT(largest_difference(magnitude_average(slope, mean, deviation),
                                             magnitude_by_quadrature(slope, mean, deviation)),
                          5e-9 * span)
                    << name << " mean " << mean << " deviation " << deviation;
    }
}

TEST(MagnitudeAverage, OneColorStaysThatColor)
{
    const ColorMap one({{0, {.1, .2, .3}}, {1, {.1, .2, .3}}});
    for (const double mean : {0.0, 0.5, 1e6})
        for (const double deviation : {1e-6, 1.0, 1e6})
            EXPECT_LT(largest_difference(magnitude_average(one, mean, deviation), {.1, .2, .3}),
                      1e-15);
}

} // namespace
} // namespace scree::test
