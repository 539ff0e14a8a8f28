// Figures of assets against closed forms, and what is said of them.
#include "judge/asset_flags.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "judge/asset_measures.h"
#include "sample/field.h"
#include "support/files.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

Original surface_of(int width, int height, const std::function<double(int, int)>& h)
{
    Original original;
    original.relief.width = width;
    original.relief.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            original.relief.heights.push_back(h(x, y));
    return original;
}

/// A normal map of given slopes.
Original slopes_of(int size, const std::function<std::array<double, 2>()>& slope)
{
    Original original;
    original.relief.width = original.relief.height = size;
    for (int i = 0; i < size * size; ++i)
        original.slopes.push_back(slope());
    return original;
}

AssetMeasures measured(const Original& original)
{
    return measure_asset(original, Reconstruction::bilinear);
}

bool says(const std::vector<std::string>& flags, const std::string& words)
{
    for (const std::string& flag : flags)
        if (flag.find(words) != std::string::npos)
            return true;
    return false;
}

std::vector<std::string> flags_of(const Original& original)
{
    return asset_flags(original, Reconstruction::bilinear);
}

TEST(AssetMeasures, OfHeightsWithKnownLawsAreTheirClosedForms)
{
    std::mt19937 random(1);
    // Evenly spread: halves of variance 1/48 in one of 1/12. Steps of 1/4096 of the range.
    const auto even = measured(surface_of(64, 64, [](int x, int y) { return x * 64 + y; }));
    EXPECT_NEAR(even.modes->explained, 0.75, 1e-6);
    EXPECT_NEAR(even.modes->low_share, 0.5, 1e-12);
    EXPECT_NEAR(even.modes->low, 1023.5, 1e-9);
    EXPECT_NEAR(even.modes->high, 3071.5, 1e-9);
    EXPECT_EQ(even.steps->values, 4096U);
    EXPECT_EQ(even.steps->level_share, 0);
    // A sine: halves of mean +-2/pi in a variance of 1/2, with an error of the second order.
    const auto sine = measured(
        surface_of(512, 2, [](int x, int) { return std::sin(2 * kPi * (x + 0.5) / 512); }));
    EXPECT_NEAR(sine.modes->explained, 8 / (kPi * kPi), 1e-4);
    EXPECT_LT(sine.steps->level_share, 0.01); // though level along t
    // Two heights, nothing else, as a checkerboard of 3x3 and in 9 of 36 parts.
    const auto two = measured(surface_of(
        60, 60, [](int x, int y) { return x / 3 % 2 == 1 && y / 3 % 2 == 1 ? 4.0 : 1.0; }));
    EXPECT_NEAR(two.modes->explained, 1, 1e-12);
    EXPECT_NEAR(two.modes->low_share, 0.75, 1e-12);
    EXPECT_NEAR(two.modes->high, 4, 1e-12);
    EXPECT_EQ(two.steps->values, 2U);
    // Along s every third border is an edge in the rows that have peaks: 19 of 59 in half of them.
    EXPECT_NEAR(two.steps->level_share, 1 - 0.5 * 19 / 59, 1e-12);
    // Normal: 2/pi; of 64k samples to a percent.
    std::normal_distribution<double> normal;
    const auto noise = measured(surface_of(256, 256, [&](int, int) { return normal(random); }));
    EXPECT_NEAR(noise.modes->explained, 2 / kPi, 0.01);
    // The docstring's claim: 3.8 deviations apart.
    const auto mixed = measured(surface_of(
        256, 256, [&](int, int) { return normal(random) + (random() % 2 == 0 ? 1.9 : -1.9); }));
    EXPECT_NEAR(mixed.modes->explained, 0.8, 0.01);
    EXPECT_FALSE(measured(surface_of(9, 9, [](int, int) { return 3; })).modes);
}

TEST(AssetMeasures, OfSlopesWithKnownLawsAreTheirClosedForms)
{
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-1, 1);
    // Normal, 3 times as wide along 30 degrees: the squared slope of a round one is exponential,
    // 0.9 of it in the share p with p (1 - log p) = 0.9, 0.587.
    const auto round = measured(slopes_of(256, [&] {
        return std::array{0.2 * normal(random), 0.2 * normal(random)};
    }));
    EXPECT_NEAR(round.rms_slope, 0.2 * std::sqrt(2.0), 2e-3);
    EXPECT_NEAR(round.slope_ratio, 1, 0.02);
    EXPECT_NEAR(round.steep_share, 0.587, 0.01);
    EXPECT_EQ(round.footprint, 32);
    EXPECT_NEAR(*round.kurtosis, 8, 0.2);
    EXPECT_FALSE(round.modes);
    EXPECT_FALSE(round.steps);
    const double c = std::cos(kPi / 6), s = std::sin(kPi / 6);
    const auto along = measured(slopes_of(256, [&] {
        const double u = 0.3 * normal(random), v = 0.1 * normal(random);
        return std::array{c * u - s * v, s * u + c * v};
    }));
    EXPECT_NEAR(along.slope_ratio, 3, 0.05);
    EXPECT_NEAR(along.azimuth_deg, 30, 1);
    EXPECT_NEAR(*along.kurtosis, 8, 0.2) << "does not depend on directions";
    const auto even = measured(slopes_of(256, [&] {
        return std::array{uniform(random), uniform(random)};
    }));
    EXPECT_NEAR(*even.kurtosis, 2 * 9.0 / 5 + 2, 0.1);
}

TEST(AssetMeasures, FollowHeightAndSteepness)
{
    // Along s a staircase whose flights steepen with height: h = x^2, slope 2x; h and slope^2 = 4
    // h.
    const int n = 200;
    Original parabola = surface_of(n, 4, [](int x, int) { return 0.01 * x * x; });
    parabola.relief.beyond_s = reference::Beyond::extends;
    EXPECT_NEAR(measured(parabola).height_steepness, 1, 1e-4);
    for (double& h : parabola.relief.heights)
        h = -h;
    EXPECT_NEAR(measured(parabola).height_steepness, -1, 1e-4);
    EXPECT_EQ(measured(surface_of(8, 8, [](int, int) { return 1; })).height_steepness, 0);
}

TEST(AssetMeasures, LeaveOutTexelsWithoutData)
{
    Original original = surface_of(64, 64, [](int x, int y) { return (x * 7 + y * 3) % 11; });
    for (size_t i = 0; i < 640; ++i)
        original.relief.heights[i] = std::nan("");
    const auto measures = measured(original);
    EXPECT_EQ(measures.texels, size_t{64} * 54);
    EXPECT_EQ(measures.steps->values, 11U);
    EXPECT_TRUE(std::isfinite(measures.modes->explained));
    EXPECT_TRUE(std::isfinite(measures.height_steepness));
}

TEST(AssetFlags, AreSilentOnNoiseThatTheModelsAreMadeFor)
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const auto flags =
        flags_of(surface_of(256, 256, [&](int, int) { return 0.2 * normal(random); }));
    EXPECT_TRUE(flags.empty()) << flags.front();
}

TEST(AssetFlags, SayWhatIsSpecialWithItsFigure)
{
    const Original groove =
        surface_of(64, 64, [](int x, int) { return 0.25 * std::abs(x % 16 - 8); });
    const auto of_groove = flags_of(groove);
    EXPECT_TRUE(says(of_groove, "kurtosis 2.7")); // 8 k1 / 3 with k1 = 1
    EXPECT_TRUE(says(of_groove, "0 degrees from +s"));
    EXPECT_FALSE(says(of_groove, "two modes"));
    EXPECT_FALSE(says(of_groove, "steep:"));

    const Original tiles =
        surface_of(64, 64, [](int x, int y) { return x % 16 == 0 || y % 16 == 0 ? 0.0 : 3.0; });
    const auto of_tiles = flags_of(tiles); // joints: 31 of 256
    EXPECT_TRUE(
        says(of_tiles, "two modes: 12 % of the area near 0, the rest near 3, explain 100 %"));
    EXPECT_TRUE(says(of_tiles, "only 2 different heights"));
    EXPECT_TRUE(says(of_tiles, "rms slope 1."));
    EXPECT_TRUE(says(of_tiles, "low parts are the steeper ones"));

    const auto of_bumps = flags_of(
        surface_of(64, 64, [](int x, int y) { return x % 16 == 5 && y % 16 == 9 ? 0.5 : 0.0; }));
    EXPECT_TRUE(says(of_bumps, "beyond Gaussian (8) and K0 (16)"));
    EXPECT_TRUE(says(of_bumps, "90 % of the squared slope lies in 2 %")); // 5 texels of 256
    EXPECT_TRUE(says(of_bumps, "high parts are the steeper ones"));

    const auto of_few =
        flags_of(surface_of(16, 16, [](int x, int y) { return 0.1 * ((x * y) % 5); }));
    EXPECT_TRUE(says(of_few, "only 256 texels"));
}

TEST(AssetFlags, FlagRealBricksForTheirTwoModes)
{
    const auto folder = data_folder();
    if (folder.empty())
        GTEST_SKIP() << "no data";
    BakeOptions options;
    options.height_file =
        folder / "heights" / "structured" / "bricks_02_256" / "bricks_02_height_2k_raw.exr";
    options.height_scale = 0.02; // of a map one unit wide: rms slope 0.46
    const auto flags = flags_of(read_original(options, {}));
    EXPECT_TRUE(says(flags, "two modes"));
    EXPECT_TRUE(says(flags, "low parts are the steeper ones"));
    EXPECT_TRUE(says(flags, "beyond Gaussian"));
    EXPECT_FALSE(says(flags, "terraces"));
    EXPECT_FALSE(says(flags, "is steep"));
}

} // namespace
} // namespace scree::test
