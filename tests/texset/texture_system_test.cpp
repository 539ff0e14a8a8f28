// A baked set as a renderer reads it: OpenImageIO's TextureSystem, filtering between levels.
//
// Levels: a lookup whose derivatives are one texel of level m along both axes is level m alone;
// between that and one texel of level m + 1 two levels are blended linearly in the derivative.

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/texture.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "pipeline/bake.h"
#include "support/files.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

using OIIO::ustring;

struct DestroyTextures {
    void operator()(OIIO::TextureSystem* textures) const
    {
        OIIO::TextureSystem::destroy(textures, true);
    }
};

/// A texture system of its own, so that nothing is cached from another test.
class Textures {
public:
    explicit Textures(const std::filesystem::path& set, const std::string& name)
        : prefix_((set / name).string()), system_(OIIO::TextureSystem::create(false))
    {}

    [[nodiscard]] ustring file(const std::string& map) const
    {
        return ustring(prefix_ + "." + map + ".exr");
    }

    /// One lookup: derivatives (ds, dt) along the picture's x and y.
    std::vector<float> lookup(const std::string& map, OIIO::TextureOpt options, double s, double t,
                              std::array<double, 2> dx, std::array<double, 2> dy, int channels)
    {
        std::vector<float> result(static_cast<size_t>(channels), -1e30F);
        auto f = [](double v) { return static_cast<float>(v); };
        EXPECT_TRUE(system_->texture(file(map), options, f(s), f(t), f(dx[0]), f(dx[1]), f(dy[0]),
                                     f(dy[1]), channels, result.data()))
            << system_->geterror();
        return result;
    }

    OIIO::TextureSystem& system() { return *system_; }

private:
    std::string prefix_;
    std::unique_ptr<OIIO::TextureSystem, DestroyTextures> system_;
};

OIIO::TextureOpt bilinear(OIIO::TextureOpt::MipMode mode = OIIO::TextureOpt::MipModeTrilinear)
{
    OIIO::TextureOpt options; // wraps stay at their default: what the file says
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.mipmode = mode;
    options.anisotropic = 32;
    return options;
}

/// A set baked from random heights and colors, and its files as stored.
struct Baked {
    TempFolder temp;
    Image height, color;
    Manifest manifest;

    Baked(int size, PixelTypeChoice type, Wrap wrap = Wrap::periodic)
        : height(random_image(size, size, {"Y"}, 21)),
          color(random_image(size, size, {"R", "G", "B"}, 22))
    {
        write_image(temp / "h.exr", height);
        write_image(temp / "c.exr", color);
        BakeOptions options;
        options.height_file = temp / "h.exr";
        options.color_file = temp / "c.exr";
        options.output = temp / "set";
        options.name = "test";
        options.height_scale = 0.5;
        options.texel_size = {{1, 1}};
        options.wrap_s = options.wrap_t = wrap;
        options.pixel_type = type;
        manifest = bake(options);
    }

    [[nodiscard]] Textures textures() const { return Textures(temp / "set", "test"); }
    [[nodiscard]] std::vector<Image> levels(const std::string& map) const
    {
        return read_levels(temp / "set" / ("test." + map + ".exr"));
    }
};

float largest(const Image& image)
{
    float result = 0;
    for (const float value : image.pixels)
        result = std::max(result, std::abs(value));
    return result;
}

constexpr auto kFloat = PixelTypeChoice::float32;

// A position is a float times the size of the level, so a texel centre is hit to size * 2^-23
// texels; the difference of neighbours is at most twice the largest value. 1e-6 for the blend.
double at_centre_tolerance(const Image& level)
{
    return static_cast<double>(largest(level)) *
           (1e-6 + 4 * static_cast<double>(level.width) * 0x1p-23);
}

TEST(TextureSystem, AtTexelCentresOfALevelWithItsDerivativesTheStoredTexelIsRead)
{
    for (const int size : {64, 99, 130})
        for (const auto mode :
             {OIIO::TextureOpt::MipModeTrilinear, OIIO::TextureOpt::MipModeAniso}) {
            const Baked baked(size, kFloat);
            Textures textures = baked.textures();
            ASSERT_EQ(baked.manifest.textures.size(), 7U);
            for (const TextureRecord& texture : baked.manifest.textures) {
                const std::string map = map_info(texture.map).name;
                const auto levels = baked.levels(map);
                ASSERT_GT(levels.size(), 5U);
                for (size_t m = 0; m < levels.size(); ++m) {
                    const Image& level = levels[m];
                    const auto channels = static_cast<int>(level.channels.size());
                    const double step = 1.0 / level.width, tolerance = at_centre_tolerance(level);
                    for (int y = 0; y < level.height; y += 1 + level.height / 9)
                        for (int x = 0; x < level.width; x += 1 + level.width / 9) {
                            const auto got =
                                textures.lookup(map, bilinear(mode), (x + 0.5) * step,
                                                (y + 0.5) * step, {step, 0}, {0, step}, channels);
                            for (int c = 0; c < channels; ++c)
                                ASSERT_NEAR(static_cast<double>(got[static_cast<size_t>(c)]),
                                            static_cast<double>(level.at(x, y, c)), tolerance)
                                    << map << " " << level.channels[static_cast<size_t>(c)]
                                    << " of " << size << ", level " << m << " texel (" << x << ", "
                                    << y << ") mode " << mode;
                        }
                }
            }
        }
}

TEST(TextureSystem, AFootprintOfTheWholeMapReadsTheTopLevel)
{
    const Baked baked(96, kFloat);
    Textures textures = baked.textures();
    for (const std::string map : {"slope", "height", "color"}) {
        const Image top = baked.levels(map).back();
        ASSERT_EQ(top.width, 1);
        for (const double width : {1.0, 3.0}) // as wide as the map, and wider
            for (const auto& [s, t] : {std::pair(0.5, 0.5), {0.0, 0.0}, {0.13, 0.77}}) {
                const auto got = textures.lookup(map, bilinear(), s, t, {width, 0}, {0, width},
                                                 static_cast<int>(top.pixels.size()));
                for (size_t c = 0; c < got.size(); ++c)
                    EXPECT_NEAR(got[c], top.pixels[c], 1e-6F * largest(top)) << map << " " << c;
            }
    }
}

// The top level of a linear channel is the mean of the map, so that is what a whole-map lookup
// must give; in double from the inputs. 1e-6: float storage and one lookup in float.
TEST(TextureSystem, AFootprintOfTheWholeMapIsTheMeanOfTheInput)
{
    const Baked baked(75, kFloat);
    Textures textures = baked.textures();
    std::array<double, 3> mean{};
    for (size_t i = 0; i < baked.color.pixels.size(); ++i)
        mean[i % 3] += static_cast<double>(baked.color.pixels[i]) / (75 * 75);
    const auto color = textures.lookup("color", bilinear(), 0.3, 0.6, {1, 0}, {0, 1}, 3);
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<double>(color[c]), mean[c], 1e-6);
    const auto height = textures.lookup("height", bilinear(), 0.3, 0.6, {1, 0}, {0, 1}, 2);
    EXPECT_NEAR(height[0], 0, 1e-6); // hn is normalised: mean 0, variance 1
    EXPECT_NEAR(height[1], 1, 1e-6);
}

TEST(TextureSystem, BetweenTwoLevelsTheirValuesAreBlendedHalfAndHalf)
{
    const Baked baked(64, kFloat);
    Textures textures = baked.textures();
    for (const std::string map : {"slope", "height", "color", "tail"}) {
        const auto levels = baked.levels(map);
        const auto channels = static_cast<int>(levels[0].channels.size());
        for (size_t m = 0; m + 1 < levels.size(); ++m) {
            const Image &fine = levels[m], &coarse = levels[m + 1];
            // halfway between one texel of the finer level and one of the coarser, at the corner
            // of four fine texels, which is the centre of the coarse one
            const double width = 1.5 / fine.width;
            for (int y = 0; y < coarse.height; y += 1 + coarse.height / 5)
                for (int x = 0; x < coarse.width; x += 1 + coarse.width / 5) {
                    const auto got = textures.lookup(map, bilinear(), (x + 0.5) / coarse.width,
                                                     (y + 0.5) / coarse.height, {width, 0},
                                                     {0, width}, channels);
                    for (int c = 0; c < channels; ++c) {
                        auto at = [&](int i, int j) {
                            return static_cast<double>(fine.at(2 * x + i, 2 * y + j, c));
                        };
                        const double mean = (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4;
                        const double want = (mean + static_cast<double>(coarse.at(x, y, c))) / 2;
                        ASSERT_NEAR(static_cast<double>(got[static_cast<size_t>(c)]), want,
                                    at_centre_tolerance(fine))
                            << map << " level " << m << " texel (" << x << ", " << y << ")";
                    }
                }
        }
    }
}

TEST(TextureSystem, TheWrapOfTheFileIsTheDefault)
{
    for (const Wrap wrap : {Wrap::periodic, Wrap::clamp, Wrap::mirror, Wrap::black}) {
        const Baked baked(64, kFloat, wrap);
        Textures textures = baked.textures();
        for (const std::string map : {"slope", "color"}) {
            const Image level = baked.levels(map)[0];
            const auto channels = static_cast<int>(level.channels.size());
            for (int y = 0; y < 64; y += 7) {
                const double t = (y + 0.5) / 64, tiny = 1.0 / 64;
                const auto edge = textures.lookup(map, bilinear(), 0, t, {tiny, 0}, {0, tiny},
                                                  channels); // halfway between two texels
                const auto beyond = textures.lookup(map, bilinear(), 2.5 / 64 - 1, t, {tiny, 0},
                                                    {0, tiny}, channels);
                for (int c = 0; c < channels; ++c) {
                    const auto first = static_cast<double>(level.at(0, y, c));
                    double across = first, far = first;
                    if (wrap == Wrap::periodic) {
                        across = static_cast<double>(level.at(63, y, c));
                        far = static_cast<double>(level.at(2, y, c));
                    } else if (wrap == Wrap::mirror) {
                        far = static_cast<double>(level.at(61, y, c)); // -62 is -1 - 61
                    } else if (wrap == Wrap::black) {
                        across = far = 0;
                    }
                    const double tolerance = at_centre_tolerance(level);
                    EXPECT_NEAR(static_cast<double>(edge[static_cast<size_t>(c)]),
                                (first + across) / 2, tolerance)
                        << wrap_name(wrap) << " " << map << " row " << y << " channel " << c;
                    EXPECT_NEAR(static_cast<double>(beyond[static_cast<size_t>(c)]), far, tolerance)
                        << wrap_name(wrap) << " " << map << " row " << y << " channel " << c;
                }
            }
        }
    }
}

TEST(TextureSystem, FirstChannelReachesEveryChannelOfTheSlope)
{
    const Baked baked(64, kFloat);
    Textures textures = baked.textures();
    const std::array<double, 2> dx = {0.11, 0.02}, dy = {-0.01, 0.07};
    const auto all = textures.lookup("slope", bilinear(), 0.4, 0.6, dx, dy, 5);
    for (int first = 0; first < 5; ++first)
        for (int count = 1; first + count <= 5; ++count) {
            OIIO::TextureOpt options = bilinear();
            options.firstchannel = first;
            const auto some = textures.lookup("slope", options, 0.4, 0.6, dx, dy, count);
            for (int c = 0; c < count; ++c)
                EXPECT_EQ(some[static_cast<size_t>(c)], all[static_cast<size_t>(first + c)])
                    << "channels from " << first;
        }
    EXPECT_GT(all[1], 0) << "ss is the second channel";
    EXPECT_GT(all[4], 0) << "tt is the last channel";
}

// A map that varies along t alone: a footprint long in s and one texel of level m in t is as sharp
// as level m, where one as wide as long would blur everything.
TEST(TextureSystem, AnisotropicLookupsAlongAGrooveStaySharp)
{
    TempFolder temp;
    Image grooves{128, 128, {"Y"}, {}};
    for (int i = 0; i < 128 * 128; ++i)
        grooves.pixels.push_back(static_cast<float>((i / 128 * 37) % 64) / 8);
    write_image(temp / "h.exr", grooves);
    BakeOptions options;
    options.height_file = temp / "h.exr";
    options.output = temp / "set";
    options.texel_size = {{1, 1}};
    options.pixel_type = kFloat;
    bake(options);
    Textures textures(temp / "set", "h");
    const auto levels = read_levels(temp / "set" / "h.slope.exr");
    for (const size_t m : {0U, 1U, 2U}) {
        const Image& level = levels[m];
        const double step = 1.0 / level.width;
        for (const double aspect : {2.0, 8.0, 16.0})
            for (int y = 0; y < level.height; y += 3)
                for (const bool swapped : {false, true}) { // x or y of the picture along s
                    const std::array<double, 2> along = {aspect * step, 0}, across = {0, step};
                    const auto got = textures.lookup(
                        "slope", bilinear(OIIO::TextureOpt::MipModeAniso), 0.37, (y + 0.5) * step,
                        swapped ? across : along, swapped ? along : across, 5);
                    for (int c = 0; c < 5; ++c)
                        ASSERT_NEAR(got[static_cast<size_t>(c)], level.at(5, y, c),
                                    at_centre_tolerance(level))
                            << "level " << m << " row " << y << " aspect " << aspect << " channel "
                            << c;
                }
    }
}

// The weights of a lookup sum to 1 and a periodic map has no border: shifted over all texels of
// its level, any footprint averages to the mean of the map. Would fail where the set clamps.
TEST(TextureSystem, LookupsOfAnyFootprintAverageToTheMeanOfAPeriodicMap)
{
    const Baked baked(64, kFloat);
    Textures textures = baked.textures();
    const Image top = baked.levels("slope").back();
    for (const auto& [dx, dy] : {std::pair(std::array{8.0 / 64, 0.0}, std::array{0.0, 1.0 / 64}),
                                 {std::array{9.0 / 64, 9.0 / 64}, std::array{-0.5 / 64, 0.5 / 64}},
                                 {std::array{0.0, 20.0 / 64}, std::array{3.0 / 64, 0.0}}}) {
        std::array<double, 5> mean{};
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const auto got = textures.lookup("slope", bilinear(OIIO::TextureOpt::MipModeAniso),
                                                 (x + 0.5) / 64, (y + 0.5) / 64, dx, dy, 5);
                for (size_t c = 0; c < 5; ++c)
                    mean[c] += static_cast<double>(got[c]) / 4096;
            }
        for (size_t c = 0; c < 5; ++c) // float sums of some 60 weighted texels a lookup
            EXPECT_NEAR(mean[c], static_cast<double>(top.pixels[c]), 2e-6) << "channel " << c;
    }
}

/// Lookups at random places, of random footprints and modes; calls check(s, ss, st, t, tt).
template <class Check>
void random_lookups(const Baked& baked, const Check& check)
{
    Textures textures = baked.textures();
    std::mt19937 random(99);
    auto uniform = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 8) * 0x1p-24;
    };
    for (int i = 0; i < 20000; ++i) {
        OIIO::TextureOpt options = bilinear(i % 2 == 0 ? OIIO::TextureOpt::MipModeAniso
                                                       : OIIO::TextureOpt::MipModeTrilinear);
        if (i % 3 == 0) // OpenImageIO's own default: B-splines where magnified
            options.interpmode = OIIO::TextureOpt::InterpSmartBicubic;
        const double size = std::exp2(uniform(-10, 1)), other = std::exp2(uniform(-10, 1));
        const double angle = uniform(0, 6.283185307);
        const auto got = textures.lookup("slope", options, uniform(-1, 2), uniform(-1, 2),
                                         {size * std::cos(angle), size * std::sin(angle)},
                                         {-other * std::sin(angle), other * std::cos(angle)}, 5);
        check(got, i);
        if (::testing::Test::HasFailure())
            return;
    }
}

// Weights are not negative and sum to 1, so the covariance is positive semi-definite, up to the
// rounding of float sums: 2e-6 of the second moments.
TEST(TextureSystem, TheCovarianceOfFilteredMomentsIsPositiveEverywhere)
{
    for (const Wrap wrap : {Wrap::periodic, Wrap::mirror}) {
        const Baked baked(100, kFloat, wrap);
        random_lookups(baked, [&](const std::vector<float>& m, int i) {
            const auto s = static_cast<double>(m[0]), t = static_cast<double>(m[3]);
            const double ss = static_cast<double>(m[1]) - s * s;
            const double st = static_cast<double>(m[2]) - s * t;
            const double tt = static_cast<double>(m[4]) - t * t;
            const double rounding = 2e-6 * static_cast<double>(m[1] + m[4]);
            EXPECT_GE(ss, -rounding) << "lookup " << i;
            EXPECT_GE(tt, -rounding) << "lookup " << i;
            EXPECT_GE(ss * tt - st * st, -rounding * (std::abs(ss) + std::abs(tt) + rounding))
                << "lookup " << i;
        });
    }
}

// The same from half files: what each was stored with is at most a rounding up of E[ss] (the baker
// rounds so that no variance is negative), and sums keep it.
TEST(TextureSystem, AlsoFromHalfFiles)
{
    const Baked baked(100, PixelTypeChoice::half);
    EXPECT_EQ(baked.manifest.textures.front().type, PixelType::half);
    random_lookups(baked, [&](const std::vector<float>& m, int i) {
        const auto s = static_cast<double>(m[0]), t = static_cast<double>(m[3]);
        const double ss = static_cast<double>(m[1]) - s * s;
        const double st = static_cast<double>(m[2]) - s * t;
        const double tt = static_cast<double>(m[4]) - t * t;
        const double rounding = 2e-6 * static_cast<double>(m[1] + m[4]);
        EXPECT_GE(ss, -rounding) << "lookup " << i;
        EXPECT_GE(tt, -rounding) << "lookup " << i;
        EXPECT_GE(ss * tt - st * st, -rounding * (std::abs(ss) + std::abs(tt) + rounding))
            << "lookup " << i;
    });
}

TEST(TextureSystem, InfoReportsAPlainTextureAndItsLevels)
{
    const Baked baked(100, PixelTypeChoice::automatic);
    Textures textures = baked.textures();
    for (const TextureRecord& texture : baked.manifest.textures) {
        const ustring file(textures.file(map_info(texture.map).name));
        auto text = [&](const char* what) {
            ustring value;
            EXPECT_TRUE(textures.system().get_texture_info(file, 0, ustring(what),
                                                           OIIO::TypeDesc::STRING, &value))
                << file << " " << what << ": " << textures.system().geterror();
            return value.string();
        };
        auto number = [&](const char* what) {
            int value = -1;
            EXPECT_TRUE(textures.system().get_texture_info(file, 0, ustring(what),
                                                           OIIO::TypeDesc::INT, &value))
                << file << " " << what << ": " << textures.system().geterror();
            return value;
        };
        EXPECT_EQ(text("textureformat"), "Plain Texture");
        EXPECT_EQ(text("texturetype"), "Plain Texture");
        EXPECT_EQ(text("wrapmodes"), "periodic,periodic");
        EXPECT_EQ(number("miplevels"), 7); // 100 50 25 12 6 3 1
        EXPECT_EQ(number("channels"), static_cast<int>(texture.channels.size()));
        EXPECT_EQ(number("subimages"), 1);
        std::array<int, 2> resolution{};
        EXPECT_TRUE(textures.system().get_texture_info(
            file, 0, ustring("resolution"), OIIO::TypeDesc(OIIO::TypeDesc::INT, 2), &resolution));
        EXPECT_EQ(resolution, (std::array{100, 100}));
    }
}

TEST(TextureSystem, TheColorTextureIsADropInForTheOriginal)
{
    const Baked baked(100, kFloat);
    const Image level = baked.levels("color")[0];
    EXPECT_EQ(level.channels, baked.color.channels);
    EXPECT_EQ(level.pixels, baked.color.pixels); // linear floats: the same bits

    // and looked up like it: every lookup of the set equals that of the original's own pyramid
    const std::string make = "maketx -d float --wrap periodic -o " +
                             (baked.temp / "set/original.color.exr").string() + " " +
                             (baked.temp / "c.exr").string() + " > /dev/null 2>&1";
    if (std::system(make.c_str()) != 0)
        GTEST_SKIP() << "no maketx on PATH";
    Textures ours = baked.textures(), theirs(baked.temp / "set", "original");
    for (int i = 0; i < 1000; ++i) {
        const double s = i * 0.618034, t = i * 0.414214, width = (0.2 + i % 9 * 0.1) / 100;
        const auto a = ours.lookup("color", bilinear(), s, t, {width, 0}, {0, width}, 3);
        const auto b = theirs.lookup("color", bilinear(), s, t, {width, 0}, {0, width}, 3);
        EXPECT_EQ(a, b) << "lookup " << i; // level 0 alone: the same numbers, the same code
    }
}

} // namespace
} // namespace scree::test
