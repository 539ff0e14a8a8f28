// Whole bakes, read back from their files.

#include "pipeline/bake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "math/error.h"
#include "support/files.h"
#include "support/oracle_case.h"
#include "support/truth.h"

namespace scree::test {
namespace {

struct Baked {
    Manifest manifest;
    std::filesystem::path folder;

    std::vector<Image> levels(const std::string& map) const
    {
        return read_levels(folder / ("test." + map + ".exr"));
    }
};

Baked bake_case(const OracleCase& c, const std::filesystem::path& folder)
{
    MemorySource source = c.source();
    BakeOptions options = c.options;
    options.output = folder;
    Manifest manifest;
    manifest.name = "test";
    return {bake(source, options, manifest), folder};
}

/// Covariance of the slope that a reader recovers: ss, tt, st.
std::array<double, 3> recovered(const Image& slope, int x, int y)
{
    const auto s = static_cast<double>(slope.at(x, y, 0));
    const auto t = static_cast<double>(slope.at(x, y, 3));
    return {static_cast<double>(slope.at(x, y, 1)) - s * s,
            static_cast<double>(slope.at(x, y, 4)) - t * t,
            static_cast<double>(slope.at(x, y, 2)) - s * t};
}

const std::pair<int, int> kSizes[] = {{1, 1},   {1, 7},     {3, 3},    {17, 31},
                                      {99, 99}, {100, 128}, {640, 480}};

TEST(Bake, CovarianceInFloatFilesIsWithin1e5OfBruteForce)
{
    unsigned seed = 5;
    for (const auto& [width, height] : kSizes) {
        TempFolder temp;
        OracleCase c = random_case(width, height, seed++);
        c.options.pixel_type = PixelTypeChoice::float32;
        const Baked baked = bake_case(c, temp / "set");
        const auto truth = brute_force(c.input);
        const auto levels = baked.levels("slope");
        ASSERT_EQ(levels.size(), truth.levels.size()) << c.title;
        for (size_t l = 0; l < levels.size(); ++l) {
            double largest = 0, worst = 0;
            for (int y = 0; y < levels[l].height; ++y)
                for (int x = 0; x < levels[l].width; ++x) {
                    const auto& t = truth.levels[l].at(x, y);
                    const auto cov = recovered(levels[l], x, y);
                    for (size_t k = 0; k < 3; ++k)
                        worst = std::max(worst, std::abs(cov[k] - t.cov_slope[k]));
                    largest = std::max({largest, t.cov_slope[0], t.cov_slope[1]});
                }
            EXPECT_LE(worst, 1e-5 * largest) << c.title << " level " << l;
        }
    }
}

/// Every map but the slope, which the test above has, against the oracle; color with the rounding
/// of float, 2^-24, products with that of their factors.
TEST(Bake, EveryMapHoldsItsRawMomentsToRounding)
{
    TempFolder temp;
    OracleCase c = holes_case(99, 77, 3);
    c.options.pixel_type = PixelTypeChoice::float32;
    const Baked baked = bake_case(c, temp / "set");
    const auto truth = brute_force(c.input);
    const auto color = baked.levels("color"), colorheight = baked.levels("colorheight"),
               colorslope = baked.levels("colorslope"), height = baked.levels("height"),
               tail = baked.levels("tail"), coverage = baked.levels("coverage");
    constexpr double kFloat = 1.2e-7;
    for (size_t l = 0; l < truth.levels.size(); ++l)
        for (int y = 0; y < truth.levels[l].height; ++y)
            for (int x = 0; x < truth.levels[l].width; ++x) {
                const auto& t = truth.levels[l].at(x, y);
                EXPECT_NEAR(coverage[l].at(x, y, 0), t.coverage, kFloat);
                if (t.coverage == 0)
                    continue;
                EXPECT_NEAR(height[l].at(x, y, 0), t.mean_hn, kFloat * 5);
                EXPECT_NEAR(height[l].at(x, y, 1), t.var_hn + t.mean_hn * t.mean_hn, kFloat * 25);
                // tau jumps where C turns singular; compare where it is well away from that
                const double trace = t.cov_slope[0] + t.cov_slope[1];
                if (t.cov_slope[0] * t.cov_slope[1] - t.cov_slope[2] * t.cov_slope[2] >
                    1e-4 * trace * trace) {
                    EXPECT_NEAR(tail[l].at(x, y, 0), t.tau, 1e-6);
                }
                for (int k = 0; k < 3; ++k) {
                    const auto i = static_cast<size_t>(k);
                    EXPECT_NEAR(color[l].at(x, y, k), t.mean_color[i], kFloat);
                    EXPECT_NEAR(colorheight[l].at(x, y, k),
                                t.cov_color_hn[i] + t.mean_color[i] * t.mean_hn, kFloat * 5);
                    EXPECT_NEAR(colorslope[l].at(x, y, 4 - 2 * k),
                                t.cov_color_s[i] + t.mean_color[i] * t.mean_slope[0], kFloat * 5);
                    EXPECT_NEAR(colorslope[l].at(x, y, 5 - 2 * k),
                                t.cov_color_t[i] + t.mean_color[i] * t.mean_slope[1], kFloat * 5);
                }
            }
}

TEST(Bake, WeightedMeanOfEveryLinearChannelIsTheSameAtAllLevels)
{
    for (const bool holes : {false, true})
        for (const auto& [width, height] : kSizes) {
            TempFolder temp;
            OracleCase c = holes ? holes_case(width, height, 21) : random_case(width, height, 22);
            c.options.pixel_type = PixelTypeChoice::float32;
            const Baked baked = bake_case(c, temp / "set");
            const bool covered = std::filesystem::exists(baked.folder / "test.coverage.exr");
            const auto coverage = covered ? baked.levels("coverage") : std::vector<Image>();
            for (const std::string map :
                 {"slope", "height", "color", "colorheight", "colorslope"}) {
                const auto levels = baked.levels(map);
                for (int channel = 0; channel < static_cast<int>(levels[0].channels.size());
                     ++channel) {
                    double first = 0, first_size = 0;
                    for (size_t l = 0; l < levels.size(); ++l) {
                        double sum = 0, weight = 0, size = 0;
                        for (int y = 0; y < levels[l].height; ++y)
                            for (int x = 0; x < levels[l].width; ++x) {
                                const double w =
                                    covered ? static_cast<double>(coverage[l].at(x, y, 0)) : 1;
                                const double v = levels[l].at(x, y, channel);
                                sum += w * v;
                                weight += w;
                                size += w * std::abs(v);
                            }
                        if (l == 0) {
                            first = sum / weight;
                            first_size = size / weight;
                        }
                        // A float is within 2^-24 of its value, on level 0 and on this one, and so
                        // is the coverage; E[xx] about the rounded mean shifts by two such steps.
                        EXPECT_NEAR(sum / weight, first,
                                    4 * std::ldexp(1.0, -24) * (first_size + size / weight))
                            << c.title << " " << map << " channel " << channel << " level " << l;
                    }
                }
            }
        }
}

/// Rank-1 covariances (det 0 before rounding) on large means: the hardest case for rounding.
OracleCase groove_case(double amplitude, double mean_s, double mean_t)
{
    OracleCase c;
    c.title = "groove";
    c.input.relief.width = c.input.relief.height = 96;
    std::mt19937 random(4);
    std::normal_distribution<double> noise;
    for (int i = 0; i < 96 * 96; ++i) {
        const double n = amplitude * noise(random);
        c.input.slopes.push_back({mean_s + 3 * n, mean_t + n});
    }
    return c;
}

TEST(Bake, NoTexelHasNegativeVarianceOrDeterminant)
{
    for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::half})
        for (const auto& [amplitude, mean_s, mean_t] :
             {std::array{0.3, 0.0, 0.0}, std::array{0.01, 2.0, 1.0}, std::array{1e-4, 0.1, -0.7},
              std::array{1e-3, 30.0, 0.001}, std::array{0.01, -100.0, 33.0}}) {
            TempFolder temp;
            OracleCase c = groove_case(amplitude, mean_s, mean_t);
            c.options.pixel_type = type;
            c.options.maps = {Map::slope};
            const Baked baked = bake_case(c, temp / "set");
            for (const Image& level : baked.levels("slope"))
                for (int y = 0; y < level.height; ++y)
                    for (int x = 0; x < level.width; ++x) {
                        const auto cov = recovered(level, x, y);
                        ASSERT_GE(cov[0], 0) << mean_s << " level " << level.width;
                        ASSERT_GE(cov[1], 0) << mean_s << " level " << level.width;
                        ASSERT_GE(cov[0] * cov[1] - cov[2] * cov[2], 0)
                            << "mean " << mean_s << " amplitude " << amplitude << " level of "
                            << level.width << " texel " << x << "," << y;
                        const float s = level.at(x, y, 0); // and for a reader in float32
                        ASSERT_GE(level.at(x, y, 1) - s * s, 0.0F);
                    }
        }
}

TEST(Bake, AutoTakesFloatForSteepOrFaintSlopesAndHalfForOrdinaryOnes)
{
    struct Case {
        double amplitude, mean;
        PixelType expected;
    };
    for (const Case& k : {Case{300, 0, PixelType::float32}, Case{1e-4, 0, PixelType::float32},
                          Case{0.05, 2, PixelType::float32}, Case{0.3, 0, PixelType::half}}) {
        TempFolder temp;
        OracleCase c = random_case(64, 64, 8);
        std::mt19937 random(6);
        std::uniform_real_distribution<double> noise(-k.amplitude, k.amplitude);
        for (int i = 0; i < 64 * 64; ++i)
            c.input.slopes.push_back({k.mean + noise(random), noise(random)});
        c.input.relief.heights.clear();
        c.options.maps = {Map::slope};
        const Baked baked = bake_case(c, temp / "set");
        const TextureRecord& slope = baked.manifest.textures.front();
        EXPECT_EQ(slope.type, k.expected) << k.amplitude << " " << *slope.half_error;
        // Worst for mean 2 and variance 0.05^2 / 3: 2^-23 2^2 / 8e-4.
        EXPECT_LT(*slope.float_error, 6e-4) << k.amplitude;
        EXPECT_LT(*slope.float_error, *slope.half_error);

        // Whatever was chosen, the slopes survive.
        const auto truth = brute_force(c.input).levels.back().at(0, 0);
        const auto cov = recovered(baked.levels("slope").back(), 0, 0);
        EXPECT_NEAR(cov[0] / truth.cov_slope[0], 1, c.options.half_tolerance) << k.amplitude;
    }
}

TEST(Bake, BumpslopesAreFloatWhereHalfLosesTheWorldHeights)
{
    struct Case {
        double offset;
        PixelType expected;
    };
    // Half resolves 2^-10 of the height: the last two beyond a hundredth of the deviation, one of
    // them beyond the largest half.
    for (const Case& k : {Case{0, PixelType::half}, Case{1000, PixelType::float32},
                          Case{1e6, PixelType::float32}}) {
        OracleCase c = random_case(40, 24, 5);
        MemorySource source = c.source();
        for (double& height : source.heights)
            height += k.offset;
        const TempFolder temp;
        c.options.output = temp / "set";
        c.options.layout = Layout::bumpslopes;
        c.options.pixel_type = PixelTypeChoice::automatic;
        const Manifest manifest = bake(source, c.options, {});
        EXPECT_EQ(manifest.textures.front().type, k.expected) << k.offset;
    }
}

TEST(Bake, MeasuredErrorIsTheOneTheFilesHave)
{
    for (const auto type : {PixelTypeChoice::half, PixelTypeChoice::float32}) {
        TempFolder temp;
        OracleCase c = random_case(64, 48, 18);
        c.options.maps = {Map::slope};
        c.options.half_tolerance = type == PixelTypeChoice::half ? 1e9 : 0;
        const Baked baked = bake_case(c, temp / "set"); // auto, forced by the tolerance
        const TextureRecord& slope = baked.manifest.textures.front();
        const auto truth = brute_force(c.input);
        const auto levels = baked.levels("slope");
        std::vector<double> largest(levels.size() + 1), worst(levels.size());
        for (size_t l = 0; l < levels.size(); ++l)
            for (int y = 0; y < levels[l].height; ++y)
                for (int x = 0; x < levels[l].width; ++x) {
                    const auto& t = truth.levels[l].at(x, y);
                    const auto cov = recovered(levels[l], x, y);
                    for (size_t k = 0; k < 3; ++k)
                        worst[l] = std::max(worst[l], std::abs(cov[k] - t.cov_slope[k]));
                    largest[l] = std::max({largest[l], t.cov_slope[0], t.cov_slope[1]});
                }
        double error = 0;
        for (size_t l = 0; l < levels.size(); ++l)
            error = std::max(error, worst[l] / std::max(largest[l], largest[l + 1]));
        const double recorded =
            type == PixelTypeChoice::half ? *slope.half_error : *slope.float_error;
        EXPECT_NEAR(recorded / error, 1, 1e-3);
    }
}

TEST(Bake, HalfThatOverflowsIsRefused)
{
    TempFolder temp;
    OracleCase c = groove_case(1, 300, 0); // 300^2 > 65504
    c.options.pixel_type = PixelTypeChoice::half;
    c.options.maps = {Map::slope};
    EXPECT_THROW(bake_case(c, temp / "set"), Error);
    EXPECT_FALSE(std::filesystem::exists(temp / "set"));
}

TEST(Bake, BytesDoNotDependOnTheNumberOfThreads)
{
    for (const auto& [width, height] : {std::pair(700, 333), std::pair(512, 256)}) {
        std::vector<std::string> first;
        for (const int threads : {1, 2, 3, 8}) {
            TempFolder temp;
            OracleCase c = holes_case(width, height, 30);
            c.options.threads = threads;
            const Baked baked = bake_case(c, temp / "set");
            std::vector<std::string> bytes;
            for (const auto& texture : baked.manifest.textures)
                bytes.push_back(read_bytes(baked.folder / texture.file));
            bytes.push_back(read_bytes(baked.folder / "test.scree.json"));
            if (first.empty())
                first = bytes;
            ASSERT_EQ(first.size(), bytes.size());
            for (size_t i = 0; i < bytes.size(); ++i)
                EXPECT_TRUE(first[i] == bytes[i]) << "file " << i << ", " << threads << " threads";
        }
    }
}

TEST(Bake, BakesOnlyWhatIsAskedFor)
{
    TempFolder temp;
    OracleCase c = random_case(16, 16, 1);
    c.options.maps = {Map::height, Map::slope};
    bake_case(c, temp / "few");
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(temp / "few"))
        files.insert(entry.path().filename().string());
    EXPECT_EQ(files,
              (std::set<std::string>{"test.height.exr", "test.slope.exr", "test.scree.json"}));

    c.options.maps.clear();
    c.input.relief.colors.clear();
    const Baked plain = bake_case(c, temp / "plain");
    EXPECT_EQ(plain.manifest.textures.size(), 3U) << "slope, height, tail: no color, no color maps";
}

TEST(Bake, LevelSummariesAreThoseOfTheOracle)
{
    TempFolder temp;
    OracleCase c = holes_case(50, 40, 2);
    const Baked baked = bake_case(c, temp / "set");
    const auto truth = brute_force(c.input);
    ASSERT_EQ(baked.manifest.levels.size(), truth.levels.size());
    for (size_t l = 0; l < truth.levels.size(); ++l) {
        const LevelSummary& ours = baked.manifest.levels[l];
        double steepest = 0;
        double weight = 0, s = 0, inside = 0, square = 0, height = 0, cov = 0, var = 0, hvar = 0;
        for (const auto& t : truth.levels[l].texels) {
            weight += t.coverage;
            s += t.coverage * t.mean_slope[0];
            steepest = std::max(steepest, t.coverage > 0 ? std::abs(t.mean_slope[1]) : 0);
            inside += t.coverage * (t.cov_slope[0] + t.cov_slope[1]);
            square += t.coverage *
                      (t.mean_slope[0] * t.mean_slope[0] + t.mean_slope[1] * t.mean_slope[1]);
            height += t.coverage * t.var_hn;
            cov += t.coverage * t.cov_color_hn[1];
            var += t.coverage * t.var_color[1];
            hvar += t.coverage * t.var_hn;
        }
        EXPECT_NEAR((*ours.mean_slope)[0], s / weight, 1e-12);
        EXPECT_NEAR((*ours.steepest)[1], steepest, 1e-12);
        EXPECT_NEAR(*ours.slope_sigma, std::sqrt(inside / weight), 1e-12);
        EXPECT_NEAR(*ours.rms_slope, std::sqrt((inside + square) / weight), 1e-12);
        EXPECT_NEAR(*ours.height_sigma, std::sqrt(height / weight) * truth.h1, 1e-10);
        if (l > 0) {
            EXPECT_NEAR((*ours.color_fit->height_correlation)[1], cov / std::sqrt(var * hvar),
                        1e-9);
        }
    }
}

} // namespace
} // namespace scree::test
