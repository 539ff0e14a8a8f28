// Surfaces whose statistics are known in closed form, baked and read back.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/error.h"
#include "pipeline/bake.h"
#include "sample/field.h"
#include "support/files.h"
#include "support/memory_source.h"

namespace scree::test {
namespace {

std::vector<Image> slopes_of(const MemorySource& given, BakeOptions options)
{
    TempFolder temp;
    MemorySource source = given;
    options.output = temp / "set";
    options.maps = {Map::slope};
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
    return read_levels(temp / "set" / "test.slope.exr");
}

MemorySource heights_of(int width, int height, double (*h)(int x, int y))
{
    MemorySource source;
    source.map_width = width;
    source.map_height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            source.heights.push_back(h(x, y));
    return source;
}

BakeOptions unit_texels(Wrap wrap)
{
    BakeOptions options;
    options.texel_size = {1, 1};
    options.wrap_s = options.wrap_t = wrap;
    return options;
}

double variance(const Image& level, int x, int y, int mean, int square)
{
    const auto m = static_cast<double>(level.at(x, y, mean));
    return static_cast<double>(level.at(x, y, square)) - m * m;
}

TEST(KnownAnswers, PlaneIsExactAtEveryTexelOfEveryLevel)
{
    // Slopes 2 and -0.75: every number is exact in float, so the variance is 0, not only small.
    const auto source = heights_of(64, 64, [](int x, int y) { return 2.0 * x - 0.75 * y; });
    for (const Image& level : slopes_of(source, unit_texels(Wrap::clamp)))
        for (int y = 0; y < level.height; ++y)
            for (int x = 0; x < level.width; ++x) {
                EXPECT_EQ(level.at(x, y, 0), 2.0F) << level.width << " " << x << "," << y;
                EXPECT_EQ(level.at(x, y, 3), -0.75F);
                EXPECT_EQ(variance(level, x, y, 0, 1), 0);
                EXPECT_EQ(variance(level, x, y, 3, 4), 0);
                EXPECT_EQ(level.at(x, y, 2), -1.5F);
            }
}

TEST(KnownAnswers, PlaneOfOddSizeAndOddSlopeIsExactToRounding)
{
    const auto source = heights_of(99, 31, [](int x, int y) { return 0.3 * x + 0.7 * y; });
    for (const Image& level : slopes_of(source, unit_texels(Wrap::clamp)))
        for (int y = 0; y < level.height; ++y)
            for (int x = 0; x < level.width; ++x) {
                EXPECT_FLOAT_EQ(level.at(x, y, 0), 0.3F);
                EXPECT_FLOAT_EQ(level.at(x, y, 3), 0.7F);
                // half a unit in the last place of 0.09 and 0.49
                EXPECT_NEAR(variance(level, x, y, 0, 1), 0, 4e-9);
                EXPECT_NEAR(variance(level, x, y, 3, 4), 0, 3e-8);
                EXPECT_GE(variance(level, x, y, 0, 1), 0);
            }
}

TEST(KnownAnswers, VGrooveHasMeanZeroAndVarianceAQuarter)
{
    const auto source = heights_of(64, 16, [](int x, int /*y*/) {
        const int phase = x % 16; // ridges on texel centres 0, 16, ...; valleys on 8, 24, ...
        return -0.5 * (phase < 8 ? phase : 16 - phase);
    });
    const auto levels = slopes_of(source, unit_texels(Wrap::periodic));
    for (size_t l = 0; l < levels.size(); ++l)
        for (int x = 0; x < levels[l].width; ++x) {
            // E[ss] is 0.25 everywhere, also in texels that a ridge halves.
            EXPECT_EQ(levels[l].at(x, 0, 1), 0.25F) << "level " << l << " texel " << x;
            EXPECT_EQ(levels[l].at(x, 0, 4), 0.0F);
        }
    EXPECT_EQ(levels[0].at(0, 0, 0), 0.0F) << "a ridge texel: half of it +0.5, half -0.5";
    EXPECT_EQ(levels[0].at(3, 0, 0), -0.5F);
    EXPECT_EQ(levels.back().at(0, 0, 0), 0.0F);
}

TEST(KnownAnswers, RampAcrossAPeriodicBorderFallsInOneTexelAndAHalfOnEachSide)
{
    // h = x on 0..15: slope 1 but for the cell between texels 15 and 0, where it is -15. Half of
    // that cell lies in each of the two texels: mean (1 - 15) / 2, variance 8^2.
    const auto source = heights_of(16, 4, [](int x, int /*y*/) { return static_cast<double>(x); });
    const auto levels = slopes_of(source, unit_texels(Wrap::periodic));
    for (int x = 0; x < 16; ++x) {
        const bool border = x == 0 || x == 15;
        EXPECT_EQ(levels[0].at(x, 1, 0), border ? -7.0F : 1.0F);
        EXPECT_EQ(variance(levels[0], x, 1, 0, 1), border ? 64 : 0);
    }
    EXPECT_EQ(levels.back().at(0, 0, 0), 0.0F) << "a periodic map returns to where it began";
    EXPECT_EQ(levels.back().at(0, 0, 1), (15 + 15.0F * 15) / 16);
}

TEST(KnownAnswers, MirrorAndBlackBordersAreTheOnesAsked)
{
    const auto source = heights_of(8, 8, [](int x, int /*y*/) { return 1.0 + x; });
    const auto mirror = slopes_of(source, unit_texels(Wrap::mirror))[0];
    EXPECT_EQ(mirror.at(0, 3, 0), 0.5F) << "flat outside, slope 1 inside";
    EXPECT_EQ(variance(mirror, 0, 3, 0, 1), 0.25);
    const auto black = slopes_of(source, unit_texels(Wrap::black))[0];
    EXPECT_EQ(black.at(0, 3, 0), 1.0F) << "from 0 up to 1";
    EXPECT_EQ(black.at(7, 3, 0), 0.5F * (1 - 8)) << "from 8 down to 0";
}

TEST(KnownAnswers, NonSquareTexelsScaleTheTwoSlopesApart)
{
    const auto source = heights_of(32, 32, [](int x, int y) { return 2.0 * x + 4.0 * y; });
    BakeOptions options = unit_texels(Wrap::clamp);
    options.texel_size = {0.5, 8};
    const auto top = slopes_of(source, options).back();
    EXPECT_EQ(top.at(0, 0, 0), 4.0F);
    EXPECT_EQ(top.at(0, 0, 3), 0.5F);
    options.texel_size.reset();
    options.world_size = {16, 256};
    EXPECT_EQ(slopes_of(source, options).back().pixels, top.pixels);
}

/// Built-in samples against the closed forms that stand in their docstrings.
TEST(KnownAnswers, BuiltInSamplesBakeToWhatTheyPromise)
{
    for (const std::string kind : {"sine", "vgroove", "plane"})
        for (const auto& [width, height] : {std::pair(256, 256), std::pair(160, 96)}) {
            const auto field = make_sample(kind, width, height);
            const SampleInfo& info = field->info();
            MemorySource source;
            source.map_width = width;
            source.map_height = height;
            std::vector<float> row(static_cast<size_t>(width));
            for (int y = 0; y < height; ++y) {
                field->row(y, row.data(), nullptr);
                source.heights.insert(source.heights.end(), row.begin(), row.end());
            }
            BakeOptions options;
            options.world_size = {info.world_width, info.world_height};
            options.wrap_s = wrap_named(info.wrap_s);
            options.wrap_t = wrap_named(info.wrap_t);
            const auto top = slopes_of(source, options).back();
            const KnownAnswers& known = info.bilinear;
            // Heights are floats: their rounding, 2^-24 of the range, over a texel of the map.
            const double rounding = 1e-6;
            EXPECT_NEAR(top.at(0, 0, 0), known.mean_s, rounding) << kind;
            EXPECT_NEAR(top.at(0, 0, 3), known.mean_t, rounding) << kind;
            EXPECT_NEAR(variance(top, 0, 0, 0, 1), known.var_ss, rounding) << kind;
            EXPECT_NEAR(variance(top, 0, 0, 3, 4), known.var_tt, rounding) << kind;
        }
}

TEST(KnownAnswers, FlatMapBakesToZeros)
{
    const auto source = heights_of(5, 3, [](int, int) { return 7.0; });
    for (const Image& level : slopes_of(source, unit_texels(Wrap::periodic)))
        for (const float v : level.pixels)
            EXPECT_EQ(v, 0.0F);
}

TEST(KnownAnswers, AMapWithoutAnyDataIsAnError)
{
    const auto source = heights_of(4, 4, [](int, int) { return std::nan(""); });
    EXPECT_THROW(slopes_of(source, unit_texels(Wrap::periodic)), Error);
}

} // namespace
} // namespace scree::test
