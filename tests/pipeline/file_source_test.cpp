// Files to surfaces: units, encodings, weights, and what is left out.

#include "pipeline/file_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "math/error.h"
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

// IEC 61966-2-1; OpenColorIO's curve stays within 7.6e-7 of it (color_space_test.cpp).
double linear_of_srgb(double v)
{
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

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
        EXPECT_NEAR(static_cast<double>(rows.color[i]), linear_of_srgb(code / 255), 8e-7);
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
        for (int i = 0; i < 75; ++i)
            EXPECT_EQ(rows.color[static_cast<size_t>(i)], gray.at(i / 3 % 5, i / 15, 0));
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
    EXPECT_NEAR(static_cast<double>(rows.color[1]), linear_of_srgb(0.6), 8e-7);
    EXPECT_NEAR(static_cast<double>(rows.color[2]), linear_of_srgb(0.2), 8e-7);
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

TEST_F(FileSourceTest, WithoutAlphaWeightAlphaIsNotLookedAt)
{
    BakeOptions options = height(Image{2, 1, {"Y", "A"}, {1, 0, 2, 0.5F}});
    add_color(options, Image{2, 1, kRgba, {0.25F, 0.125F, 0.5F, 0.25F, 0.1F, 0, 0, 0}});
    FileSource source(options);
    const SurfaceRows rows = read_all(source);
    EXPECT_TRUE(rows.weight.empty());
    EXPECT_EQ(rows.height, (std::vector<double>{1, 2}));
    EXPECT_EQ(rows.color, (std::vector<float>{0.25F, 0.125F, 0.5F, 0.1F, 0, 0}));
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
