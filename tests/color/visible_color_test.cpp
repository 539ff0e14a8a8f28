// What a view sees of a color map over normal heights.

#include "color/visible_color.h"

#include <gtest/gtest.h>

#include <cmath>

#include "color/maps.h"
#include "color/normal_average.h"
#include "color/shortcut_error.h"
#include "kernel/filter.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

TEST(VisibleColor, SeenFromAboveItIsTheNormalAverage)
{
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const ColorMap map = random_map(seed);
        for (const double mean : {-0.3, 0.2, 0.8})
            for (const double deviation : {0.01, 0.2, 3.0})
                EXPECT_LT(largest_difference(visible_color(map, mean, deviation, 0),
                                             normal_average(map, mean, deviation)),
                          1e-9);
    }
}

// The largest of L + 1 normal numbers, known by other means.
TEST(VisibleColor, OfARampOverEverythingIsTheMeanOfTheLargest)
{
    const ColorMap map = ramp_map(-50, 50);
    const auto mean = [&](double exponent) {
        return visible_color(map, 0, 1, exponent)[0] * 100 - 50;
    };
    EXPECT_NEAR(mean(0), 0, 1e-7); // 1e-9 of a span of 100
    EXPECT_NEAR(mean(1), 1 / std::sqrt(kPi), 1e-7);
    EXPECT_NEAR(mean(2), 1.5 / std::sqrt(kPi), 1e-7);
    EXPECT_NEAR(mean(3), 3 / std::sqrt(kPi) * (0.5 + std::asin(1 / 3.0) / kPi), 1e-7);
}

TEST(VisibleColor, OfAStepIsAPowerOfTheDistributionFunction)
{
    for (const double exponent : {0.0, 0.3, 1.0, 2.0, 7.0, 1e3})
        for (double z = -3; z <= 6; z += 0.5) {
            const double below = std::erfc(z / std::sqrt(2.0)) / 2; // P(X > z)
            const double want = -std::expm1((1 + exponent) * std::log1p(-below));
            EXPECT_NEAR(visible_color(step_map(5 + 2 * z), 5, 2, exponent)[0], want, 1e-9)
                << exponent << " " << z;
        }
}

TEST(VisibleColor, MatchesQuadratureOnMapsAtRandom)
{
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const ColorMap map = random_map(seed);
        for (const double exponent : {0.0, 0.4, 1.0, 5.0, 30.0, 1e3, 1e4, 1e6})
            for (const double mean : {-0.4, 0.3, 0.9})
                for (const double deviation : {0.02, 0.3}) {
                    const Rgb got = visible_color(map, mean, deviation, exponent);
                    const Rgb want = visible_by_quadrature(map, mean, deviation, exponent);
                    EXPECT_LT(largest_difference(got, want), 1e-8)
                        << "seed " << seed << " mean " << mean << " deviation " << deviation
                        << " exponent " << exponent;
                }
    }
}

TEST(VisibleColor, MatchesQuadratureOnRealMaps)
{
    const auto maps = real_maps();
    if (maps.empty())
        GTEST_SKIP() << "no folder of real data";
    for (const auto& [name, map] : maps) {
        const double width = map.last() - map.first(), span = color_span(map, -1e9, 1e9);
        for (const double exponent : {0.7, 1e3})
            for (const double at : {0.2, 0.6}) {
                const double mean = map.first() + at * width, deviation = 0.1 * width;
                EXPECT_LT(largest_difference(visible_color(map, mean, deviation, exponent),
                                             visible_by_quadrature(map, mean, deviation, exponent)),
                          1e-8 * span)
                    << name << " exponent " << exponent << " mean " << mean;
            }
    }
}

TEST(VisibleColor, WithoutDeviationItIsTheMap)
{
    const ColorMap map = random_map(4);
    for (const double exponent : {0.0, 3.0, 1e6})
        EXPECT_EQ(visible_color(map, 0.37, 0, exponent), map.at(0.37));
}

// A line is all the table needs: it loses nothing but what the fit of mu loses.
TEST(ShortcutError, OfALineIsNothing)
{
    const ShortcutError error = shortcut_error(ramp_map(-9, 9), 0, 1, 0.5);
    EXPECT_LT(error.largest, 1e-5); // mu is fitted to 1e-6 of up to 4.9 deviations
    EXPECT_LE(error.rms, error.largest);
}

// Oracle: both colors by quadrature, at the place the result names.
TEST(ShortcutError, TheLargestIsFoundWhereItSays)
{
    for (const ColorMap& map : {step_map(0.4), hat_map(0.3, 0.5, 0.6), ramp_map(0.4, 0.6)}) {
        const ShortcutError error = shortcut_error(map, 0, 1, 0.3);
        EXPECT_GT(error.largest, 0.01); // a bend is what the shortcut is wrong at
        EXPECT_GT(error.rms, 0);
        EXPECT_LT(error.rms, error.largest);
        const auto visible = filter::visible_height(error.exponent);
        const Rgb shortcut = normal_by_quadrature(map, error.mean + error.deviation * visible.mean,
                                                  error.deviation * std::sqrt(visible.variance));
        const Rgb exact = visible_by_quadrature(map, error.mean, error.deviation, error.exponent);
        EXPECT_NEAR(largest_difference(shortcut, exact) / 2, error.largest, 1e-8); // span 2
    }
}

TEST(ShortcutError, OfOneColorIsNothing)
{
    EXPECT_EQ(shortcut_error(step_map(5), 0, 1, 0.1).largest, 0);
}

} // namespace
} // namespace scree::test
