// Color maps averaged over normal densities.

#include "color/normal_average.h"

#include <gtest/gtest.h>

#include <cmath>

#include "color/maps.h"
#include "math/normal.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

TEST(NormalAverage, OfAStepIsTheDistributionFunction)
{
    for (const double deviation : {1e-6, 0.1, 1.0, 1e3})
        for (double z = -8; z <= 8; z += 0.25) {
            const Rgb got = normal_average(step_map(3), 3 + z * deviation, deviation);
            const double want = std::erfc(-z / std::sqrt(2.0)) / 2;
            // 3 + z deviation is rounded: up to 4e-16 of 3, in deviations
            EXPECT_NEAR(got[0], want, 1e-15 + 2e-16 / deviation) << z << " " << deviation;
            EXPECT_NEAR(got[2], -2 * want, 2e-15 + 4e-16 / deviation);
        }
}

// E[X; 0 < X < 1] + P(X > 1), by hand.
TEST(NormalAverage, OfARampIsItsClosedForm)
{
    for (const double mean : {-1.0, 0.0, 0.3, 1.0, 2.5})
        for (const double s : {0.01, 0.3, 2.0, 40.0}) {
            const auto phi = [](double z) { return std::exp(-z * z / 2) / std::sqrt(2 * kPi); };
            const auto cdf = [](double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; };
            const double a = -mean / s, b = (1 - mean) / s;
            const double want = mean * (cdf(b) - cdf(a)) + s * (phi(a) - phi(b)) + 1 - cdf(b);
            EXPECT_NEAR(normal_average(ramp_map(0, 1), mean, s)[0], want, 1e-14 * (1 + s)) << mean;
        }
}

TEST(NormalAverage, WithoutDeviationItIsTheMap)
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const ColorMap map = random_map(seed);
        for (double x = -0.5; x < 1.5; x += 0.01)
            EXPECT_EQ(normal_average(map, x, 0), map.at(x));
        for (const Knot& k : map.knots())
            EXPECT_EQ(normal_average(map, k.x, 0), map.at(k.x));
    }
}

TEST(NormalAverage, MatchesQuadratureOnMapsAtRandom)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const ColorMap map = random_map(seed);
        for (const double mean : {-1.0, 0.0, 0.123, 0.5, 0.9, 1.7})
            for (const double deviation : {1e-4, 0.003, 0.03, 0.3, 3.0, 100.0}) {
                const Rgb got = normal_average(map, mean, deviation);
                const Rgb want = normal_by_quadrature(map, mean, deviation);
                EXPECT_LT(largest_difference(got, want), 1e-12)
                    << "seed " << seed << " mean " << mean << " deviation " << deviation;
            }
    }
}

TEST(NormalAverage, MatchesQuadratureOnRealMaps)
{
    const auto maps = real_maps();
    if (maps.empty())
        GTEST_SKIP() << "no folder of real data";
    for (const auto& [name, map] : maps) {
        const double width = map.last() - map.first(), span = color_span(map, -1e9, 1e9);
        for (const double at : {0.0, 0.31, 0.5, 1.05})
            for (const double share : {0.001, 0.04, 0.5}) {
                const double mean = map.first() + at * width, deviation = share * width;
                const Rgb got = normal_average(map, mean, deviation);
                const Rgb want = normal_by_quadrature(map, mean, deviation);
                EXPECT_LT(largest_difference(got, want), 1e-12 * span)
                    << name << " mean " << mean << " deviation " << deviation;
            }
    }
}

TEST(NormalAverage, MovesAndScalesWithTheMap)
{
    const ColorMap map = random_map(7), moved = map.stretched(50, 90);
    for (double mean = -0.5; mean < 1.5; mean += 0.1)
        for (const double deviation : {0.01, 0.2, 1.0})
            EXPECT_LT(largest_difference(normal_average(map, mean, deviation),
                                         normal_average(moved, 50 + 40 * mean, 40 * deviation)),
                      1e-12);
}

// A narrower density averaged over a normal one is the wider one.
TEST(NormalAverage, AveragesOfAveragesAreAverages)
{
    const ColorMap map = random_map(9);
    const double inner = 0.05, outer = 0.12, mean = 0.4;
    Rgb sum{};
    double weights = 0;
    for (double z = -10; z <= 10; z += 0.05) { // evenly spaced: exact to rounding for such
        const double w = std::exp(-z * z / 2);
        const Rgb color = normal_average(map, mean + outer * z, inner);
        weights += w;
        for (size_t c = 0; c < 3; ++c)
            sum[c] += w * color[c];
    }
    for (double& c : sum)
        c /= weights;
    EXPECT_LT(largest_difference(sum, normal_average(map, mean, std::hypot(inner, outer))), 1e-12);
}

TEST(NormalAverage, OneColorStaysThatColor)
{
    const ColorMap one({{0, {.1, .2, .3}}, {1, {.1, .2, .3}}});
    for (const double deviation : {0.0, 1e-300, 1e-9, 1.0, 1e9, 1e300})
        EXPECT_EQ(normal_average(one, 0.3, deviation), (Rgb{.1, .2, .3})) << deviation;
}

TEST(NormalLaw, TheLogarithmHoldsBothTails)
{
    EXPECT_NEAR(log_normal_cdf(9) / -1.1285884059538405e-19, 1, 1e-13);
    EXPECT_NEAR(log_normal_cdf(-9) / std::log(1.1285884059538405e-19), 1, 1e-15);
    for (double z = -8; z < 5; z += 0.1)
        EXPECT_NEAR(std::exp(log_normal_cdf(z)) / normal_cdf(z), 1, 1e-14) << z;
    EXPECT_NEAR(normal_pdf(1), 0.24197072451914337, 1e-16);
}

} // namespace
} // namespace scree::test
