// The fit report against sums over the texels of every footprint, and on surfaces whose fit is
// known.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "pipeline/bake.h"
#include "stats/ranks.h"
#include "support/files.h"
#include "support/memory_source.h"
#include "support/oracle_case.h"
#include "support/truth.h"

namespace scree::test {
namespace {

std::vector<LevelSummary> levels_of(MemorySource source, BakeOptions options = {})
{
    TempFolder temp;
    options.output = temp / "set";
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "test";
    return bake(source, options, manifest).levels;
}

/// White noise heights without ties; the colors by the caller.
MemorySource noise(int size, unsigned seed)
{
    MemorySource source;
    source.map_width = source.map_height = size;
    std::mt19937 random(seed);
    std::normal_distribution<double> height;
    for (int i = 0; i < size * size; ++i)
        source.heights.push_back(height(random));
    return source;
}

template <class Color>
void color_by_height(MemorySource& source, Color color)
{
    for (const double h : source.heights) {
        const double c = color(h);
        source.colors.push_back({c, 0.5 * c, 0.25});
    }
}

TEST(ColorFit, ItsSharesAreThoseOfTheOraclesMoments)
{
    const OracleCase c = holes_case(50, 40, 2);
    const auto levels = levels_of(c.source(), c.options);
    const auto truth = brute_force(c.input);
    ASSERT_EQ(levels.size(), truth.levels.size());
    EXPECT_FALSE(levels[0].color_fit) << "one texel has one color";
    for (size_t l = 1; l < levels.size(); ++l) {
        double weight = 0, variance = 0, by_height = 0, by_slope = 0, red = 0, red_by_slope = 0;
        for (const auto& t : truth.levels[l].texels)
            for (size_t k = 0; k < 3; ++k) {
                if (t.coverage == 0)
                    continue;
                weight += t.coverage;
                variance += t.coverage * t.var_color[k];
                if (t.var_hn > 1e-20)
                    by_height += t.coverage * t.cov_color_hn[k] * t.cov_color_hn[k] / t.var_hn;
                // The least squares plane in s and t, by Cramer's rule.
                const auto& [ss, tt, st] = t.cov_slope;
                const double u = t.cov_color_s[k], v = t.cov_color_t[k];
                const double plane =
                    (u * (tt * u - st * v) + v * (ss * v - st * u)) / (ss * tt - st * st);
                by_slope += t.coverage * plane;
                red += k == 0 ? t.coverage * t.var_color[k] : 0;
                red_by_slope += k == 0 ? t.coverage * plane : 0;
            }
        const ColorFit& fit = *levels[l].color_fit;
        EXPECT_NEAR(fit.sigma, std::sqrt(variance / weight), 1e-9) << "level " << l;
        EXPECT_NEAR(*fit.height, by_height / variance, 1e-9) << "level " << l;
        EXPECT_NEAR(*fit.slope, by_slope / variance, 1e-9) << "level " << l;
        EXPECT_NEAR((*fit.slope_correlation)[0], std::sqrt(red_by_slope / red), 1e-9);
        const double best = std::max({*fit.height, *fit.slope, *fit.rank4});
        EXPECT_NEAR(fit.residual, fit.sigma * std::sqrt(1 - best), 1e-12);
    }
}

TEST(ColorFit, ColorLinearInHeightIsExplainedWholly)
{
    MemorySource source = noise(64, 1);
    color_by_height(source, [](double h) { return 3 + 0.25 * h; });
    const auto levels = levels_of(source);
    for (size_t l = 1; l < levels.size(); ++l) {
        const ColorFit& fit = *levels[l].color_fit;
        EXPECT_NEAR(*fit.height, 1, 1e-5) << "level " << l; // color is a float, about 3
        EXPECT_NEAR((*fit.height_correlation)[1], 1, 1e-5);
        EXPECT_EQ((*fit.height_correlation)[2], 0) << "blue is constant";
        EXPECT_LT(fit.residual, 0.25 * 3e-3);
    }
}

TEST(ColorFit, AStepAtTheMedianHasTheSharesOfTheLegendreSeries)
{
    // Of sign(u - 1/2), variance 1: a_1 = 3/2, a_2 = 0, a_3 = -7/8, so a_1^2 / 3 = 3/4 and
    // a_3^2 / 7 = 7/64. A normal height explains the square of E[|z|], 2/pi.
    MemorySource source = noise(256, 2);
    color_by_height(source, [](double h) { return h > 0 ? 1.0 : 0.0; });
    const ColorFit fit = *levels_of(source).back().color_fit;
    const double chance = 5 / std::sqrt(256.0 * 256); // the sample's median is not 0
    EXPECT_NEAR(*fit.rank1, 0.75, chance);
    EXPECT_NEAR(*fit.rank2, 0.75, chance);
    EXPECT_NEAR(*fit.rank4, 0.75 + 7.0 / 64, chance);
    EXPECT_NEAR(*fit.height, 2 / 3.14159265358979, chance);
}

TEST(ColorFit, AShuffledColorFitsNoBetterThanChance)
{
    // R^2 of noise is 1 / (texels - 1) a term: of the 16384 texels of the last level nothing, of
    // the 64 of a texel at level 3 1.6 %.
    MemorySource source = noise(128, 3);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> any;
    for (size_t i = 0; i < source.heights.size(); ++i)
        source.colors.push_back({any(random), any(random), any(random)});
    const auto levels = levels_of(source);
    const ColorFit& top = *levels.back().color_fit;
    EXPECT_LT(*top.height, 25.0 / 16384); // five standard deviations
    EXPECT_LT(*top.rank4, 4 * 25.0 / 16384);
    for (const double r : *top.height_correlation)
        EXPECT_LT(std::abs(r), 5.0 / 128);
    EXPECT_NEAR(*levels[3].color_fit->height, 1.0 / 63, 2e-3);
    // Of the slope's variance 19/64 of 4/3 (docs/statistics.md) lies between texels, where the
    // color can follow it.
    EXPECT_NEAR(*levels[3].color_fit->slope, 2.0 / 63 * (19.0 / 64) / (4.0 / 3), 1e-3);
}

TEST(ColorFit, IsAbsentWhereNothingIsToBeFitted)
{
    MemorySource source = noise(16, 4);
    for (const auto& level : levels_of(source))
        EXPECT_FALSE(level.color_fit) << "no color";
    color_by_height(source, [](double /*h*/) { return 0.5; });
    for (const auto& level : levels_of(source))
        EXPECT_FALSE(level.color_fit) << "one color";
}

} // namespace
} // namespace scree::test
