// Files to surfaces: units, encodings, weights, and what is left out.

#include "pipeline/file_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "math/error.h"
#include "support/color.h"
#include "support/files.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// The whole surface, `strip` rows at a time.
SurfaceRows read_all(FileSource& source, int strip = 64)
{
    SurfaceRows all, rows;
    auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    source.rewind(false);
    for (int y = 0; y < source.height(); y += strip) {
        source.read(std::min(strip, source.height() - y), rows);
        append(all.height, rows.height);
        append(all.slope_s, rows.slope_s);
        append(all.slope_t, rows.slope_t);
        append(all.color, rows.color);
        append(all.weight, rows.weight);
    }
    return all;
}

std::string error_of(const BakeOptions& options)
{
    try {
        FileSource source(options);
        read_all(source);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

class FileSourceTest : public ::testing::Test {
protected:
    FileSourceTest() { unsetenv("OCIO"); }

    BakeOptions height(const Image& image, const std::string& type = "float",
                       const std::string& name = "h.exr")
    {
        write_image(temp_ / name, image, type);
        BakeOptions options;
        options.height_file = temp_ / name;
        return options;
    }

    BakeOptions normals(const Image& image, const std::string& type = "float",
                        const std::string& name = "n.exr")
    {
        BakeOptions options = height(image, type, name);
        options.normal_input = true;
        return options;
    }

    void add_color(BakeOptions& options, const Image& image, const std::string& type = "float",
                   const std::string& name = "c.exr")
    {
        write_image(temp_ / name, image, type);
        options.color_file = temp_ / name;
    }

    TempFolder temp_;
};

const std::vector<std::string> kRgb = {"R", "G", "B"}, kRgba = {"R", "G", "B", "A"};

// --- heights -------------------------------------------------------------------------------------

TEST_F(FileSourceTest, HeightsAreOffsetPlusScaleTimesTheFileValue)
{
    const Image image = random_image(17, 70, {"Y"}, 1, -5, 5);
    BakeOptions options = height(image);
    options.height_scale = -2.5;
    options.height_offset = 100;
    FileSource source(options);
    EXPECT_TRUE(source.has_heights());
    EXPECT_FALSE(source.has_color());
    const SurfaceRows rows = read_all(source);
    ASSERT_EQ(rows.height.size(), image.pixels.size());
    for (size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(rows.height[i], 100 - 2.5 * static_cast<double>(image.pixels[i]));
    EXPECT_TRUE(rows.weight.empty());
    EXPECT_EQ(source.quantum(), 0);
    EXPECT_EQ(read_all(source, 7).height, rows.height) << "after rewind, in other strips";
}

TEST_F(FileSourceTest, TheQuantumIsOneStepOfAnIntegerFileInWorldUnits)
{
    const Image image{3, 1, {"Y"}, {0, 0.5F, 1}};
    const std::tuple<const char*, const char*, double> cases[] = {
        {"uint8", "h.png", 255}, {"uint16", "i.png", 65535}, {"int16", "j.tif", 32767}};
    for (const auto& [type, name, steps] : cases) {
        BakeOptions options = height(image, type, name);
        options.height_scale = -3;
        FileSource source(options);
        EXPECT_DOUBLE_EQ(source.quantum(), 3 / steps) << type;
        const SurfaceRows rows = read_all(source);
        EXPECT_DOUBLE_EQ(rows.height[2], -3) << type;
        // half a step of the file, and the float it is normalised to
        EXPECT_NEAR(rows.height[1], -1.5, 1.5 / steps + 3 * 0x1p-24) << type;
    }
}

TEST_F(FileSourceTest, OneOfSeveralChannelsMustBeNamed)
{
    const Image image = random_image(4, 4, kRgb, 2);
    BakeOptions options = height(image);
    EXPECT_TRUE(contains(error_of(options), "--height-channel R")) << error_of(options);
    EXPECT_TRUE(contains(error_of(options), "h.exr")) << error_of(options);
    for (const char* name : {"G", "1"}) {
        options.height_channel = name;
        FileSource source(options);
        EXPECT_EQ(read_all(source).height[5], static_cast<double>(image.at(1, 1, 1)));
        EXPECT_EQ(source.records()[0].channels, "G");
    }
    options.height_channel = "Z";
    EXPECT_TRUE(contains(error_of(options), "'Z'")) << error_of(options);
}

TEST_F(FileSourceTest, NaNAndInfinityAreNoDataAndCountedWithTheFirst)
{
    Image image = random_image(10, 100, {"Y"}, 3);
    image.pixels[7 * 10 + 4] = kNaN;
    image.pixels[80 * 10 + 9] = kInf;
    image.pixels[99 * 10 + 0] = -kInf;
    FileSource source(height(image));
    const SurfaceRows rows = read_all(source);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_EQ(std::isnan(rows.height[i]), !std::isfinite(image.pixels[i])) << i;
    EXPECT_EQ(source.rejects().not_finite.texels, 3);
    EXPECT_TRUE(contains(source.rejects().not_finite.first, "h.exr"));
    EXPECT_TRUE(contains(source.rejects().not_finite.first, "channel Y"));
    EXPECT_TRUE(contains(source.rejects().not_finite.first, "texel (4, 7)"));
    read_all(source);
    EXPECT_EQ(source.rejects().not_finite.texels, 3) << "counted anew after rewind";
}

TEST_F(FileSourceTest, TheNoDataValueMarksTexelsByTheFilesValue)
{
    BakeOptions options = height(Image{4, 1, {"Y"}, {-9999, 1, 2, -9999}});
    options.height_scale = 2;
    options.no_data_height = -9999;
    FileSource source(options);
    const SurfaceRows rows = read_all(source);
    EXPECT_TRUE(std::isnan(rows.height[0]));
    EXPECT_TRUE(std::isnan(rows.height[3]));
    EXPECT_EQ(rows.height[1], 2);
    EXPECT_EQ(source.rejects().marked.texels, 2);
    EXPECT_TRUE(contains(source.rejects().marked.first, "texel (0, 0)"));
    EXPECT_EQ(source.rejects().not_finite.texels, 0);
}

// Files hold floats and users type decimals: 0.1, or GDAL's usual -3.4028235e38, are no floats.
TEST_F(FileSourceTest, TheNoDataValueMayBeTypedInDecimal)
{
    for (const double typed : {0.1, -3.4028235e38, 32767.0 / 65535}) {
        BakeOptions options = height(Image{3, 1, {"Y"}, {static_cast<float>(typed), 1, 2}});
        options.no_data_height = typed;
        FileSource source(options);
        EXPECT_TRUE(std::isnan(read_all(source).height[0])) << typed;
        EXPECT_EQ(source.rejects().marked.texels, 1) << typed;
    }
}

// --- normals -------------------------------------------------------------------------------------

/// Normals of slopes (x / 4, y / 8 - 0.5), of any length, in [-1, 1].
Image normal_image(int width, int height, double length)
{
    Image image{width, height, kRgb, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const double n : {-x / 4.0, -(y / 8.0 - 0.5), 1.0})
                image.pixels.push_back(
                    static_cast<float>(length * n / std::hypot(x / 4.0, y / 8.0 - 0.5, 1.0)));
    return image;
}

Image to_unsigned(Image image)
{
    for (float& value : image.pixels)
        value = (value + 1) / 2;
    return image;
}

TEST_F(FileSourceTest, SignedAndUnsignedNormalsGiveTheSlopesTheyWereMadeOf)
{
    const Image in_signed = normal_image(6, 9, 1);
    const std::pair<Image, NormalRange> files[] = {
        {in_signed, NormalRange::automatic},
        {in_signed, NormalRange::signed_unit},
        {normal_image(6, 9, 0.5), NormalRange::automatic}, // length does not matter
        {to_unsigned(in_signed), NormalRange::automatic},
        {to_unsigned(in_signed), NormalRange::unsigned_unit}};
    for (const auto& [image, range] : files) {
        BakeOptions options = normals(image);
        options.normal_range = range;
        FileSource source(options);
        EXPECT_FALSE(source.has_heights());
        const SurfaceRows rows = read_all(source, 4);
        EXPECT_TRUE(rows.height.empty());
        for (size_t i = 0; i < 54; ++i) {
            // (v + 1) / 2 in float costs 2^-24 of a component, over nz >= 0.6
            EXPECT_NEAR(rows.slope_s[i], static_cast<double>(i % 6) / 4, 1e-6);
            EXPECT_NEAR(rows.slope_t[i], static_cast<double>(i / 6) / 8 - 0.5, 1e-6);
        }
    }
}

TEST_F(FileSourceTest, IntegerNormalsAreUnsignedAndRightToTheirSteps)
{
    const Image image = to_unsigned(normal_image(6, 9, 1));
    for (const auto& [type, step] : {std::pair("uint8", 2 / 255.0), {"uint16", 2 / 65535.0}}) {
        FileSource source(normals(image, type, std::string(type) + ".png"));
        const SurfaceRows rows = read_all(source);
        for (size_t i = 0; i < 54; ++i) {
            // half a step in nx and in nz, the latter times the slope (up to 1.25), over nz >= 0.6
            EXPECT_NEAR(rows.slope_s[i], static_cast<double>(i % 6) / 4, 2 * step) << type;
            EXPECT_NEAR(rows.slope_t[i], static_cast<double>(i / 6) / 8 - 0.5, 2 * step) << type;
        }
    }
}

TEST_F(FileSourceTest, InvertingAnAxisNegatesItsSlopeAlone)
{
    BakeOptions options = normals(normal_image(6, 9, 1));
    FileSource plain(options);
    const SurfaceRows rows = read_all(plain);
    for (const bool x : {false, true})
        for (const bool y : {false, true}) {
            options.invert_x = x;
            options.invert_y = y;
            FileSource source(options);
            const SurfaceRows inverted = read_all(source);
            for (size_t i = 0; i < 54; ++i) {
                EXPECT_EQ(inverted.slope_s[i], (x ? -1 : 1) * rows.slope_s[i]);
                EXPECT_EQ(inverted.slope_t[i], (y ? -1 : 1) * rows.slope_t[i]);
            }
        }
}

TEST_F(FileSourceTest, NormalsThatDoNotFaceOutwardAreLeftOutAndCounted)
{
    const Image image{
        5, 1, kRgb, {0.1F, 0.2F, 1, 0.1F, 0.2F, 0, 0, 0, -0.5F, kNaN, 0, 0.5F, -1, 0, 1e-3F}};
    FileSource source(normals(image));
    const SurfaceRows rows = read_all(source);
    for (const size_t i : {1U, 2U, 3U}) {
        EXPECT_TRUE(std::isnan(rows.slope_s[i])) << i;
        EXPECT_TRUE(std::isnan(rows.slope_t[i])) << i;
    }
    EXPECT_NEAR(rows.slope_s[0], -0.1, 1e-7);
    EXPECT_NEAR(rows.slope_s[4], 1000, 1e-4); // steep is no error; 1e-3 is rounded to float
    EXPECT_EQ(source.rejects().turned_away.texels, 2);
    EXPECT_TRUE(contains(source.rejects().turned_away.first, "texel (1, 0)"));
    EXPECT_TRUE(contains(source.rejects().turned_away.first, "channel B"));
    EXPECT_EQ(source.rejects().not_finite.texels, 1);
}

TEST_F(FileSourceTest, ANormalMapNeedsThreeChannels)
{
    const std::string message = error_of(normals(random_image(4, 4, {"Y"}, 1)));
    EXPECT_TRUE(contains(message, "n.exr")) << message;
    EXPECT_TRUE(contains(message, "expected the 3 of a normal map")) << message;
}

// --- color ---------------------------------------------------------------------------------------

constexpr double kSrgb = 8e-7; // OpenColorIO's curve is that close to the standard's, absolutely

TEST_F(FileSourceTest, LinearColorPassesUntouchedAndEncodedColorIsUndone)
{
    const Image color = random_image(9, 70, kRgb, 5);
    BakeOptions options = height(random_image(9, 70, {"Y"}, 6));
    add_color(options, color);
    {
        FileSource source(options);
        EXPECT_TRUE(source.has_color());
        EXPECT_EQ(source.working_space(), "lin_rec709");
        EXPECT_EQ(read_all(source, 9).color, color.pixels);
    }
    add_color(options, color, "uint8", "c.png");
    FileSource source(options);
    const SurfaceRows rows = read_all(source, 9);
    ASSERT_EQ(rows.color.size(), color.pixels.size());
    for (size_t i = 0; i < rows.color.size(); ++i) {
        const double code = std::round(static_cast<double>(color.pixels[i]) * 255);
        EXPECT_NEAR(static_cast<double>(rows.color[i]), linear_of_srgb(code / 255), kSrgb);
    }
    EXPECT_EQ(source.records()[1].color_space, "srgb_tx");
    EXPECT_EQ(source.records()[1].role, "color");
}

TEST_F(FileSourceTest, OneGrayChannelStandsForAllThree)
{
    BakeOptions options = height(random_image(5, 5, {"Y"}, 7));
    for (const auto& channels : {std::vector<std::string>{"Y"}, {"Y", "A"}}) {
        const Image gray = random_image(5, 5, channels, 8);
        add_color(options, gray);
        FileSource source(options);
        const SurfaceRows rows = read_all(source);
        for (int i = 0; i < 75; ++i) {
            const int x = i / 3 % 5, y = i / 15;
            const float alpha = channels.size() == 2 ? gray.at(x, y, 1) : 1; // multiplied in
            EXPECT_EQ(rows.color[static_cast<size_t>(i)], gray.at(x, y, 0) / alpha);
        }
    }
    add_color(options, random_image(5, 5, {"u", "v"}, 9));
    EXPECT_TRUE(contains(error_of(options), "2 channels")) << error_of(options);
}

TEST_F(FileSourceTest, RedGreenAndBlueAreFoundByName)
{
    BakeOptions options = height(random_image(3, 3, {"Y"}, 7));
    const Image color = random_image(3, 3, {"R", "G", "B", "depth", "id"}, 8);
    add_color(options, color);
    FileSource source(options);
    EXPECT_EQ(source.records()[1].channels, "R,G,B");
    EXPECT_EQ(read_all(source).color[4], color.at(1, 0, 1));
}

TEST_F(FileSourceTest, ColorThatIsNotFiniteMakesTheTexelNoData)
{
    const Image heights = random_image(8, 90, {"Y"}, 9);
    Image color = random_image(8, 90, kRgb, 10);
    color.pixels[3 * (70 * 8 + 5) + 1] = kNaN;
    color.pixels[3 * (71 * 8 + 2) + 2] = -kInf;
    BakeOptions options = height(heights);
    add_color(options, color);
    FileSource source(options);
    const SurfaceRows rows = read_all(source);
    for (size_t i = 0; i < heights.pixels.size(); ++i)
        EXPECT_EQ(std::isnan(rows.height[i]), i == 70 * 8 + 5 || i == 71 * 8 + 2) << i;
    EXPECT_EQ(source.rejects().not_finite.texels, 2);
    EXPECT_TRUE(contains(source.rejects().not_finite.first, "c.exr"));
    EXPECT_TRUE(contains(source.rejects().not_finite.first, "texel (5, 70)"));
}

TEST_F(FileSourceTest, DifferentSizesAreAnErrorThatNamesBothUnlessResampled)
{
    BakeOptions options = height(random_image(20, 10, {"Y"}, 1));
    Image color = random_image(7, 33, kRgb, 2);
    std::fill(color.pixels.begin(), color.pixels.end(), 0.25F);
    add_color(options, color);
    for (const char* part : {"h.exr is 20x10", "c.exr is 7x33", "--resample"})
        EXPECT_TRUE(contains(error_of(options), part)) << error_of(options);
    options.resample = true;
    FileSource source(options);
    const SurfaceRows rows = read_all(source, 3);
    ASSERT_EQ(rows.color.size(), 600U);
    for (const float c : rows.color)
        EXPECT_NEAR(c, 0.25F, 2e-7F); // float weights sum to 1 that closely
}

// --- color spaces, against the standards' own formulas ------------------------------------------

TEST_F(FileSourceTest, ATaggedAndAnUntaggedPngAreSrgb)
{
    const Image picture{2, 1, kRgb, {0.2F, 0.02F, 1, 0.51F, 0.71F, 0}};
    BakeOptions options = height(Image{2, 1, {"Y"}, {1, 2}});
    options.color_file = temp_ / "c.png";
    for (const std::string profile : {"", "chunk", "sRGB IEC61966-2.1"}) {
        write_image_with(options.color_file, picture, "uint16", [&](OIIO::ImageSpec& spec) {
            if (profile == "chunk")
                spec.attribute("oiio:ColorSpace", "sRGB");
            else if (!profile.empty())
                set_icc_profile(spec, profile);
        });
        FileSource source(options);
        const SurfaceRows rows = read_all(source);
        for (size_t i = 0; i < 6; ++i) {
            const double code = std::round(static_cast<double>(picture.pixels[i]) * 65535) / 65535;
            EXPECT_NEAR(static_cast<double>(rows.color[i]), linear_of_srgb(code), kSrgb) << profile;
        }
        EXPECT_TRUE(source.notes().empty()) << profile;
    }
}

TEST_F(FileSourceTest, AnotherProfileIsReadAsTheFormatsHabitAndNoted)
{
    const Image picture{1, 1, kRgb, {0.2F, 0.6F, 1}};
    BakeOptions options = height(Image{1, 1, {"Y"}, {1}});
    options.color_file = temp_ / "c.png";
    write_image_with(options.color_file, picture, "uint8",
                     [](OIIO::ImageSpec& spec) { set_icc_profile(spec, "Display P3"); });
    FileSource source(options);
    EXPECT_NEAR(static_cast<double>(read_all(source).color[1]), linear_of_srgb(0.6), kSrgb);
    ASSERT_EQ(source.notes().size(), 1U);
    for (const char* part : {"c.png", "'Display P3'", "'srgb_tx'", "--color-space"})
        EXPECT_TRUE(contains(source.notes()[0], part)) << source.notes()[0];
    options.color_space = "srgb_tx";
    EXPECT_TRUE(FileSource(options).notes().empty());
}

TEST_F(FileSourceTest, ARawExrKeepsItsNumbers)
{
    const Image data{2, 1, kRgb, {-0.5F, 1e-30F, 70000, 0.25F, 3, -7}};
    BakeOptions options = height(Image{2, 1, {"Y"}, {1, 2}});
    add_color(options, data);
    for (const char* space : {"", "raw", "Raw", "data"}) {
        options.color_space = space;
        FileSource source(options);
        EXPECT_EQ(read_all(source).color, data.pixels) << space;
    }
    options.color_space = "raw";
    options.working_space = "ACEScg";
    FileSource source(options);
    EXPECT_EQ(read_all(source).color, data.pixels) << "data are of no space";
    EXPECT_EQ(source.working_space(), "acescg");
    EXPECT_EQ(source.records()[1].color_space, "raw");
}

TEST_F(FileSourceTest, ChromaticitiesOfAnExrNameItsPrimaries)
{
    const Image picture{2, 1, kRgb, {0.5F, 0.25F, 0.125F, 0.0625F, 4, 0.75F}};
    BakeOptions options = height(Image{2, 1, {"Y"}, {1, 2}});
    options.color_file = temp_ / "c.exr";
    const std::tuple<const char*, Primaries> inputs[] = {
        {"lin_rec709", kRec709}, {"aces_ap0", kAp0}, {"acescg", kAp1}};
    const std::tuple<const char*, Primaries> outputs[] = {{"", kRec709}, {"ACEScg", kAp1}};
    for (const auto& [name, from] : inputs)
        for (const auto& [working, to] : outputs) {
            const Primaries& xy = from; // structured bindings cannot be captured
            write_image_with(options.color_file, picture, "float",
                             [&xy](OIIO::ImageSpec& spec) { set_chromaticities(spec, xy); });
            options.working_space = working;
            FileSource source(options);
            const SurfaceRows rows = read_all(source);
            const Matrix m = rgb_to_rgb(from, to);
            for (size_t i = 0; i < 6; i += 3) {
                const Rgb want = times(m, {static_cast<double>(picture.pixels[i]),
                                           static_cast<double>(picture.pixels[i + 1]),
                                           static_cast<double>(picture.pixels[i + 2])});
                for (size_t c = 0; c < 3; ++c) // sums of terms of up to 8 in float
                    EXPECT_NEAR(static_cast<double>(rows.color[i + c]), want[c], 4e-6)
                        << name << " to " << working;
            }
            EXPECT_EQ(source.records()[1].color_space, name);
            EXPECT_TRUE(source.notes().empty());
        }
}

TEST_F(FileSourceTest, UnknownPrimariesAreNoted)
{
    BakeOptions options = height(Image{1, 1, {"Y"}, {1}});
    options.color_file = temp_ / "c.exr";
    Primaries odd = kRec709;
    odd[0] = 0.7;
    write_image_with(options.color_file, Image{1, 1, kRgb, {0.5F, 0.25F, 0.125F}}, "float",
                     [&](OIIO::ImageSpec& spec) { set_chromaticities(spec, odd); });
    FileSource source(options);
    EXPECT_EQ(read_all(source).color, (std::vector<float>{0.5F, 0.25F, 0.125F}));
    ASSERT_EQ(source.notes().size(), 1U);
    for (const char* part : {"c.exr", "primaries (0.7, 0.33)", "'lin_rec709'", "--color-space"})
        EXPECT_TRUE(contains(source.notes()[0], part)) << source.notes()[0];
}

// A texture of the ACES studio's: linear AP1, which nothing in its header says.
TEST_F(FileSourceTest, ARealAcescgTextureGoesToTheWorkingSpace)
{
    const auto folder = data_folder() / "heights/structured/bricks_02_256";
    BakeOptions options;
    options.height_file = folder / "bricks_02_height_2k_raw.exr";
    options.height_channel = "0";
    options.color_file = folder / "bricks_02_basecolor_2k_acescg.exr";
    if (data_folder().empty() || !std::filesystem::exists(options.color_file))
        GTEST_SKIP() << "no " << options.color_file;
    options.color_space = "acescg";
    const Image file = read_levels(options.color_file)[0];
    {
        FileSource source(options);
        const SurfaceRows rows = read_all(source);
        ASSERT_EQ(rows.color.size(), file.pixels.size());
        const Matrix m = rgb_to_rgb(kAp1, kRec709);
        for (size_t i = 0; i < file.pixels.size(); i += 3) {
            const Rgb want = times(m, {static_cast<double>(file.pixels[i]),
                                       static_cast<double>(file.pixels[i + 1]),
                                       static_cast<double>(file.pixels[i + 2])});
            for (size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(static_cast<double>(rows.color[i + c]), want[c], 1e-6) << i / 3;
        }
    }
    options.working_space = "acescg";
    FileSource source(options);
    EXPECT_EQ(read_all(source).color, file.pixels);
}

// --- alpha ---------------------------------------------------------------------------------------

TEST_F(FileSourceTest, AlphaOfAPngWeightsTexelsAndLeavesTheirColor)
{
    BakeOptions options = height(Image{3, 1, {"Y"}, {1, 2, 3}});
    add_color(options, Image{3, 1, kRgba, {1, 0.6F, 0.2F, 0.2F, 1, 1, 1, 0, 0.4F, 0.4F, 0.4F, 1}},
              "uint8", "c.png");
    options.alpha_weight = true;
    FileSource source(options);
    const SurfaceRows rows = read_all(source);
    ASSERT_EQ(rows.weight.size(), 3U);
    EXPECT_NEAR(rows.weight[0], 51 / 255.0F, 1e-7F);
    EXPECT_EQ(rows.weight[2], 1);
    EXPECT_EQ(rows.height[0], 1);
    EXPECT_TRUE(std::isnan(rows.height[1])) << "alpha 0 is no data";
    EXPECT_NEAR(static_cast<double>(rows.color[1]), linear_of_srgb(0.6), kSrgb);
    EXPECT_NEAR(static_cast<double>(rows.color[2]), linear_of_srgb(0.2), kSrgb);
}

TEST_F(FileSourceTest, AlphaMultipliedIntoAnExrIsDividedOut)
{
    BakeOptions options = height(Image{3, 1, {"Y"}, {1, 2, 3}});
    add_color(options,
              Image{3, 1, kRgba, {0.25F, 0.125F, 0.5F, 0.25F, 0, 0, 0, 0, 0.5F, 0.5F, 0.5F, 1}});
    options.alpha_weight = true;
    FileSource source(options);
    const SurfaceRows rows = read_all(source);
    EXPECT_EQ(rows.weight, (std::vector<float>{0.25F, 0, 1}));
    EXPECT_TRUE(std::isnan(rows.height[1]));
    EXPECT_EQ(rows.color[0], 1.0F);
    EXPECT_EQ(rows.color[1], 0.5F);
    EXPECT_EQ(rows.color[2], 2.0F);
    EXPECT_EQ(rows.color[6], 0.5F);
}

TEST_F(FileSourceTest, WithoutAlphaWeightAlphaIsNotAWeight)
{
    BakeOptions options = height(Image{2, 1, {"Y", "A"}, {1, 0, 2, 0.5F}});
    add_color(options, Image{2, 1, kRgba, {0.25F, 0.125F, 0.5F, 0.25F, 0.1F, 0, 0, 0}});
    FileSource source(options);
    const SurfaceRows rows = read_all(source);
    EXPECT_TRUE(rows.weight.empty());
    EXPECT_EQ(rows.height, (std::vector<double>{1, 2}));
    // divided by 0.25; alpha 0 leaves the color as it is
    EXPECT_EQ(rows.color, (std::vector<float>{1, 0.5F, 2, 0.1F, 0, 0}));
}

/// One picture as files of four kinds: sRGB-encoded integers and linear floats, color multiplied
/// by alpha and not.
std::vector<std::filesystem::path> write_four_kinds(const TempFolder& temp, const Image& linear)
{
    Image srgb = linear, srgb_multiplied = linear, multiplied = linear;
    for (size_t i = 0; i < linear.pixels.size(); ++i) {
        const float alpha = linear.pixels[i / 4 * 4 + 3];
        if (i % 4 == 3)
            continue;
        srgb.pixels[i] = static_cast<float>(srgb_of_linear(static_cast<double>(linear.pixels[i])));
        srgb_multiplied.pixels[i] = srgb.pixels[i] * alpha;
        multiplied.pixels[i] = linear.pixels[i] * alpha;
    }
    const auto straight = [](OIIO::ImageSpec& s) { s.attribute("oiio:UnassociatedAlpha", 1); };
    const auto associated = [](OIIO::ImageSpec&) {};
    write_image_with(temp / "straight.png", srgb, "uint16", straight);
    write_image_with(temp / "straight.tif", srgb, "uint16", straight);
    write_image_with(temp / "multiplied.tif", srgb_multiplied, "uint16", associated);
    write_image_with(temp / "multiplied.exr", multiplied, "float", associated);
    return {temp / "straight.png", temp / "straight.tif", temp / "multiplied.tif",
            temp / "multiplied.exr"};
}

TEST_F(FileSourceTest, OnePictureGivesItsColorsHoweverItsAlphaIsStored)
{
    Image linear = random_image(6, 5, kRgba, 21, 0.05F, 1);
    for (size_t i = 3; i < linear.pixels.size(); i += 4)
        linear.pixels[i] = 0.25F + 0.75F * linear.pixels[i];
    BakeOptions options = height(random_image(6, 5, {"Y"}, 22));
    for (const auto& file : write_four_kinds(temp_, linear))
        for (const bool weight : {false, true}) {
            options.color_file = file;
            options.alpha_weight = weight;
            FileSource source(options);
            const SurfaceRows rows = read_all(source, 2);
            EXPECT_EQ(rows.weight.size(), weight ? 30U : 0U);
            for (size_t i = 0; i < 30; ++i)
                for (size_t c = 0; c < 3; ++c) {
                    // Half a step of 16 bits in color and in alpha, each over alpha >= 0.25, times
                    // the curve's steepest slope, 2.28.
                    const double step = 2.28 * 2 * 0.5 / 65535 / 0.25;
                    EXPECT_NEAR(static_cast<double>(rows.color[3 * i + c]),
                                static_cast<double>(linear.pixels[4 * i + c]), step)
                        << file << ", texel " << i << ", weight " << weight;
                }
        }
}

TEST_F(FileSourceTest, ResamplingDoesNotTellMultipliedFromStraightFiles)
{
    Image linear = random_image(9, 7, kRgba, 23, 0.05F, 1);
    for (size_t i = 3; i < linear.pixels.size(); i += 4)
        linear.pixels[i] = i % 5 == 0 ? 0.0F : 0.25F + 0.75F * linear.pixels[i];
    for (size_t i = 0; i < linear.pixels.size(); ++i)
        if (linear.pixels[i / 4 * 4 + 3] == 0)
            linear.pixels[i] = 0; // a multiplied file has nothing else to hold there
    BakeOptions options = height(random_image(4, 11, {"Y"}, 24));
    options.resample = true;
    const auto files = write_four_kinds(temp_, linear);
    for (const bool weight : {false, true}) {
        options.alpha_weight = weight;
        options.color_file = files.back();
        FileSource exact(options);
        const SurfaceRows want = read_all(exact);
        for (const auto& file : files) {
            options.color_file = file;
            FileSource source(options);
            const SurfaceRows rows = read_all(source, 3);
            ASSERT_EQ(rows.color.size(), 132U);
            for (size_t i = 0; i < 132; ++i) {
                if (weight && !(want.weight[i / 3] > 0))
                    continue;
                // an average of texels that are each as close as in the test above
                EXPECT_NEAR(rows.color[i], want.color[i], 2.28F * 2 * 0.5F / 65535 / 0.25F)
                    << file << " " << i << ", weight " << weight;
            }
        }
    }
}

TEST_F(FileSourceTest, WithoutAlphaWeightResampledColorIsThePlainAverage)
{
    // Two texels to one, of colors 1 and 0.5 and alphas 0.25 and 1: (1 + 0.5) / 2, not 0.6.
    BakeOptions options = height(Image{1, 1, {"Y"}, {1}});
    add_color(options, Image{2, 1, kRgba, {0.25F, 0.25F, 0.25F, 0.25F, 0.5F, 0.5F, 0.5F, 1}});
    options.resample = true;
    options.wrap_s = options.wrap_t = Wrap::clamp;
    for (const bool weight : {false, true}) {
        options.alpha_weight = weight;
        FileSource source(options);
        for (const float c : read_all(source).color)
            EXPECT_NEAR(c, weight ? 0.6F : 0.75F, 1e-6F);
    }
}

TEST_F(FileSourceTest, AlphaOfTheHeightMapServesWhereTheColorHasNone)
{
    BakeOptions options = height(Image{2, 1, {"Y", "A"}, {1, 0.5F, 2, 0.75F}});
    options.alpha_weight = true;
    {
        FileSource source(options);
        EXPECT_EQ(read_all(source).weight, (std::vector<float>{0.5F, 0.75F}));
    }
    add_color(options, Image{2, 1, kRgb, {0, 0, 0, 0, 0, 0}});
    {
        FileSource source(options);
        EXPECT_EQ(read_all(source).weight, (std::vector<float>{0.5F, 0.75F}));
    }
    add_color(options, Image{2, 1, kRgba, {0, 0, 0, 0.125F, 0, 0, 0, 1}}, "float", "ca.exr");
    FileSource source(options);
    EXPECT_EQ(read_all(source).weight, (std::vector<float>{0.125F, 1})) << "color goes first";
}

TEST_F(FileSourceTest, AlphaWeightWithoutAlphaIsAnError)
{
    BakeOptions options = height(random_image(2, 2, {"Y"}, 1));
    add_color(options, random_image(2, 2, kRgb, 1));
    options.alpha_weight = true;
    for (const char* part : {"--alpha-weight", "h.exr", "c.exr"})
        EXPECT_TRUE(contains(error_of(options), part)) << error_of(options);
}

// A transparent texel has no color of its own: what it holds must not bleed into its neighbours.
TEST_F(FileSourceTest, ResampledColorIsWeightedWithItsAlpha)
{
    Image color{8, 8, kRgba, {}};
    for (int i = 0; i < 64; ++i) {
        const bool opaque = i % 8 < 4;
        for (int c = 0; c < 3; ++c)
            color.pixels.push_back(opaque ? 0.5F : 0.0F);
        color.pixels.push_back(opaque ? 1.0F : 0.0F);
    }
    BakeOptions options = height(random_image(16, 16, {"Y"}, 1));
    add_color(options, color);
    options.alpha_weight = options.resample = true;
    FileSource source(options);
    const SurfaceRows rows = read_all(source);
    int weighted = 0;
    for (size_t i = 0; i < rows.weight.size(); ++i) {
        if (!(rows.weight[i] > 0))
            continue;
        ++weighted;
        for (size_t c = 0; c < 3; ++c) // the quotient of two sums of up to 4 in float
            ASSERT_NEAR(rows.color[3 * i + c], 0.5F, 1e-6F) << "texel " << i;
    }
    EXPECT_GT(weighted, 128); // the opaque half, and the edges its filter reaches
}

} // namespace
} // namespace scree::test
