// Rows of images of many kinds: the numbers in the file, normalised, whatever its storage.

#include "texset/image_rows.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>

#include "math/error.h"
#include "support/color.h"
#include "support/files.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

/// A file with these very codes; tile 0: scan lines.
template <class T>
void write_codes(const fs::path& file, int width, int height, int channels,
                 const std::vector<T>& codes, int tile_width = 0, int tile_height = 0)
{
    const OIIO::TypeDesc type = OIIO::BaseTypeFromC<T>::value;
    OIIO::ImageSpec spec(width, height, channels, type);
    spec.tile_width = tile_width;
    spec.tile_height = tile_height;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    auto out = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(out) << OIIO::geterror();
    ASSERT_TRUE(out->open(file.string(), spec)) << out->geterror();
    ASSERT_TRUE(out->write_image(type, codes.data())) << out->geterror();
    ASSERT_TRUE(out->close()) << out->geterror();
}

std::vector<int> all_channels(const ImageInfo& info)
{
    std::vector<int> channels(info.channels.size());
    std::iota(channels.begin(), channels.end(), 0);
    return channels;
}

/// All rows, `strip` at a time.
std::vector<float> read_all(ImageRows& rows, const std::vector<int>& channels, int strip)
{
    const ImageInfo& info = rows.info();
    const size_t row = static_cast<size_t>(info.width) * channels.size();
    std::vector<float> pixels(static_cast<size_t>(info.height) * row);
    for (int y = 0; y < info.height; y += strip)
        rows.next(std::min(strip, info.height - y), channels,
                  pixels.data() + static_cast<size_t>(y) * row);
    return pixels;
}

std::vector<float> read_all(const fs::path& file)
{
    ImageRows rows(file);
    return read_all(rows, all_channels(rows.info()), rows.info().height);
}

std::string error_of(const fs::path& file)
{
    try {
        read_all(file);
    } catch (const Error& e) {
        return e.what();
    }
    return {};
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

// OpenImageIO multiplies by the reciprocal: two roundings, and one in the reciprocal.
constexpr double kNormalised = 0x1p-23;

TEST(ImageRows, UnsignedIntegersAreNormalisedToOne)
{
    TempFolder temp;
    std::vector<uint8_t> bytes(256);
    std::iota(bytes.begin(), bytes.end(), uint8_t{0});
    for (const char* name : {"a.png", "a.tif"}) {
        write_codes(temp / name, 16, 16, 1, bytes);
        const auto pixels = read_all(temp / name);
        for (size_t i = 0; i < 256; ++i)
            EXPECT_NEAR(static_cast<double>(pixels[i]), static_cast<double>(i) / 255, kNormalised)
                << name;
        EXPECT_EQ(pixels[255], 1.0F);
        EXPECT_EQ(ImageRows(temp / name).info().integer_bits, 8);
        EXPECT_EQ(ImageRows(temp / name).info().type, "uint8");
    }

    std::vector<uint16_t> words(65536);
    std::iota(words.begin(), words.end(), uint16_t{0});
    for (const char* name : {"b.png", "b.tif"}) {
        write_codes(temp / name, 256, 256, 1, words);
        const auto pixels = read_all(temp / name);
        for (size_t i = 0; i < words.size(); ++i)
            ASSERT_NEAR(static_cast<double>(pixels[i]), static_cast<double>(i) / 65535, kNormalised)
                << name;
        EXPECT_EQ(pixels[65535], 1.0F);
        EXPECT_EQ(ImageRows(temp / name).info().integer_bits, 16);
        EXPECT_EQ(ImageRows(temp / name).info().type, "uint16");
    }
}

TEST(ImageRows, SignedIntegersAreNormalisedToPlusMinusOne)
{
    TempFolder temp;
    const std::vector<int16_t> codes = {0, 1, -1, 100, -100, 16384, 32767, -32767};
    write_codes(temp / "a.tif", 4, 2, 1, codes);
    const auto pixels = read_all(temp / "a.tif");
    for (size_t i = 0; i < codes.size(); ++i)
        EXPECT_NEAR(static_cast<double>(pixels[i]), codes[i] / 32767.0, kNormalised) << codes[i];
    EXPECT_EQ(pixels[6], 1.0F);
    const ImageInfo info = ImageRows(temp / "a.tif").info();
    EXPECT_EQ(info.integer_bits, 16);
    EXPECT_EQ(info.type, "int16");
}

TEST(ImageRows, FloatingPointNumbersComeBackToTheBit)
{
    TempFolder temp;
    const std::vector<float> values = {0.0F, -0.0F, 1e-30F, -3e38F, 65504.0F, 1.0F / 3, -7, 1e9F};
    for (const char* name : {"a.exr", "a.tif"}) {
        write_codes(temp / name, 4, 2, 1, values);
        const auto pixels = read_all(temp / name);
        EXPECT_EQ(std::memcmp(pixels.data(), values.data(), sizeof(float) * 8), 0) << name;
        EXPECT_EQ(ImageRows(temp / name).info().integer_bits, 0);
        EXPECT_EQ(ImageRows(temp / name).info().type, "float");
    }
    const Image halves{4, 2, {"Y"}, {0.5F, -0.25F, 65504, 6.103515625e-05F, 0x1p-24F, 1, 3, -1000}};
    write_image(temp / "h.exr", halves, "half");
    EXPECT_EQ(read_all(temp / "h.exr"), halves.pixels);
    EXPECT_EQ(ImageRows(temp / "h.exr").info().type, "half");
}

TEST(ImageRows, NaNAndInfinityPassThrough)
{
    TempFolder temp;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    for (const char* name : {"a.exr", "a.tif", "h.exr"}) {
        const Image image{3, 1, {"Y"}, {nan, inf, -inf}};
        write_image(temp / name, image, name[0] == 'h' ? "half" : "float");
        const auto pixels = read_all(temp / name);
        EXPECT_TRUE(std::isnan(pixels[0])) << name;
        EXPECT_EQ(pixels[1], inf) << name;
        EXPECT_EQ(pixels[2], -inf) << name;
    }
}

TEST(ImageRows, TilesAndScanLinesAndStripsOfAnyHeightGiveTheSameRows)
{
    TempFolder temp;
    const std::pair<int, int> sizes[] = {{1, 1},   {1, 200}, {200, 1},  {3, 3},
                                         {64, 64}, {65, 63}, {97, 150}, {130, 129}};
    for (const auto& [width, height] : sizes) {
        const Image image = random_image(width, height, {"R", "G", "B"}, 3);
        for (const char* name : {"a.exr", "a.tif"})
            for (const auto& [tile_w, tile_h] : {std::pair(0, 0), {16, 16}, {64, 64}, {32, 80}}) {
                write_codes(temp / name, width, height, 3, image.pixels, tile_w, tile_h);
                for (const int strip : {1, 7, 64, 65, 1000}) {
                    ImageRows rows(temp / name);
                    EXPECT_EQ(read_all(rows, {0, 1, 2}, strip), image.pixels)
                        << name << " " << width << "x" << height << " tiles " << tile_w << "x"
                        << tile_h << " strips of " << strip;
                }
            }
    }
}

TEST(ImageRows, ChannelsArePickedInTheOrderAskedFor)
{
    TempFolder temp;
    const Image image = random_image(70, 90, {"0", "1", "2", "3", "4", "5"}, 4);
    write_codes(temp / "a.tif", 70, 90, 6, image.pixels);
    const std::vector<int> choices[] = {{0},       {3},    {5},       {2, 1, 0},   {0, 1, 2},
                                        {0, 2, 5}, {5, 0}, {4, 4, 4}, {1, 3, 1, 0}};
    for (const auto& channels : choices) {
        ImageRows rows(temp / "a.tif");
        ASSERT_EQ(rows.info().channels.size(), 6U);
        const auto pixels = read_all(rows, channels, 50);
        size_t i = 0;
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 70; ++x)
                for (const int channel : channels)
                    ASSERT_EQ(pixels[i++], image.at(x, y, channel))
                        << "channel " << channel << " of " << channels.size() << " at " << x << ", "
                        << y;
    }
}

TEST(ImageRows, AChannelIsFoundByNameOrNumber)
{
    ImageInfo info;
    info.path = "a.exr";
    info.channels = {"R", "G", "height", "1"};
    EXPECT_EQ(channel_index(info, "height", "--height-channel"), 2);
    EXPECT_EQ(channel_index(info, "0", "--height-channel"), 0);
    EXPECT_EQ(channel_index(info, "2", "--height-channel"), 2);
    EXPECT_EQ(channel_index(info, "1", "--height-channel"), 3); // a name goes before a number
    for (const char* none : {"4", "B", "", "-1", "1.0", "99999999999999999999", " 2"})
        try {
            channel_index(info, none, "--height-channel");
            ADD_FAILURE() << "found '" << none << "'";
        } catch (const Error& e) {
            for (const char* part : {"a.exr", "R,G,height,1", "--height-channel"})
                EXPECT_TRUE(contains(e.what(), part)) << e.what();
        }
}

TEST(ImageRows, AlphaIsLeftAsTheFileStoresIt)
{
    TempFolder temp;
    const std::vector<uint8_t> bytes = {200, 100, 50, 64, 255, 255, 255, 0};
    write_codes(temp / "a.png", 2, 1, 4, bytes);
    const auto pixels = read_all(temp / "a.png");
    for (size_t i = 0; i < bytes.size(); ++i)
        EXPECT_NEAR(static_cast<double>(pixels[i]), bytes[i] / 255.0, kNormalised) << i;
    EXPECT_EQ(ImageRows(temp / "a.png").info().alpha_channel, 3);
    EXPECT_FALSE(ImageRows(temp / "a.png").info().premultiplied);

    const Image exr{1, 1, {"R", "G", "B", "A"}, {0.1F, 0.2F, 0.3F, 0.5F}};
    write_image(temp / "a.exr", exr);
    EXPECT_EQ(read_all(temp / "a.exr"), exr.pixels);
    EXPECT_TRUE(ImageRows(temp / "a.exr").info().premultiplied);
    EXPECT_EQ(ImageRows(temp / "a.exr").info().alpha_channel, 3);

    write_image(temp / "rgb.exr", random_image(2, 2, {"R", "G", "B"}, 1));
    EXPECT_EQ(ImageRows(temp / "rgb.exr").info().alpha_channel, -1);
    EXPECT_FALSE(ImageRows(temp / "rgb.exr").info().premultiplied);
}

TEST(ImageRows, WhetherColorIsMultipliedByAlphaIsToldForEveryFormat)
{
    TempFolder temp;
    Image image{32, 32, {"R", "G", "B", "A"}, {}};
    for (int i = 0; i < 32 * 32; ++i)
        image.pixels.insert(image.pixels.end(), {0.25F, 0.5F, 0.125F, 0.5F});
    const std::tuple<const char*, const char*, bool, bool> kinds[] = {
        // what the writer is told, what the reader must know
        {"a.exr", "float", false, true},  {"a.tif", "uint16", false, true},
        {"b.tif", "uint16", true, false}, {"a.png", "uint8", true, false},
        {"a.tga", "uint8", true, false},  {"a.bmp", "uint8", true, false},
        {"a.jp2", "uint8", true, false}};
    for (const auto& [name, type, straight, premultiplied] : kinds) {
        const bool told = straight; // structured bindings cannot be captured
        write_image_with(temp / name, image, type, [told](OIIO::ImageSpec& spec) {
            spec.attribute("oiio:UnassociatedAlpha", told ? 1 : 0);
        });
        ImageRows rows(temp / name);
        EXPECT_EQ(rows.info().premultiplied, premultiplied) << name;
        EXPECT_EQ(rows.info().alpha_channel, 3) << name;
        const auto pixels = read_all(rows, {0, 1, 2, 3}, 1);
        for (size_t c = 0; c < 4; ++c) // a step of 8 bits
            EXPECT_NEAR(pixels[c], image.pixels[c], 1 / 255.0F) << name;
    }
}

TEST(ImageRows, ADataWindowIsTheMapWhereverItLies)
{
    TempFolder temp;
    const Image image = random_image(40, 70, {"Y"}, 6);
    for (const int tile : {0, 16}) {
        OIIO::ImageSpec spec(40, 70, 1, OIIO::TypeDesc::FLOAT);
        spec.x = -5;
        spec.y = 13;
        spec.full_width = 100;
        spec.full_height = 90;
        spec.tile_width = spec.tile_height = tile;
        auto out = OIIO::ImageOutput::create("exr");
        ASSERT_TRUE(out->open((temp / "a.exr").string(), spec));
        ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data()));
        ASSERT_TRUE(out->close());
        EXPECT_EQ(read_all(temp / "a.exr"), image.pixels) << "tile " << tile;
        const auto notes = ImageRows(temp / "a.exr").info().notes;
        ASSERT_EQ(notes.size(), 1U);
        EXPECT_TRUE(contains(notes[0], "data window")) << notes[0];
        EXPECT_TRUE(contains(notes[0], (temp / "a.exr").string())) << notes[0];
    }
}

TEST(ImageRows, AFileCutShortThrowsAndIsNamed)
{
    TempFolder temp;
    const Image image = random_image(120, 100, {"R", "G", "B"}, 5);
    const std::tuple<const char*, const char*, int> kinds[] = {
        {"a.exr", "float", 0},  {"t.exr", "half", 32}, {"a.tif", "uint16", 0},
        {"t.tif", "float", 32}, {"a.png", "uint8", 0}, {"b.png", "uint16", 0},
        {"a.hdr", "float", 0},  {"a.tga", "uint8", 0}, {"a.bmp", "uint8", 0}};
    for (const auto& [name, type, tile] : kinds) {
        if (tile == 0)
            write_image(temp / name, image, type);
        else
            write_codes(temp / name, 120, 100, 3, image.pixels, tile, tile);
        ASSERT_EQ(error_of(temp / name), "") << "the whole file";
        const std::string bytes = read_bytes(temp / name);
        for (const double share : {0.0, 0.0005, 0.01, 0.3, 0.5, 0.9}) {
            const auto size = static_cast<size_t>(share * static_cast<double>(bytes.size()));
            const fs::path cut = temp / ("cut-" + std::string(name));
            std::ofstream(cut, std::ios::binary) << bytes.substr(0, size);
            EXPECT_TRUE(contains(error_of(cut), cut.string()))
                << name << " cut to " << size << " of " << bytes.size() << " bytes: '"
                << error_of(cut) << "'";
        }
    }
}

TEST(ImageRows, WhatIsNoImageThrowsAndIsNamed)
{
    TempFolder temp;
    std::ofstream(temp / "text.exr") << "this is text";
    std::ofstream(temp / "noise.png") << "\x89PNG\r\n but no more";
    std::ofstream(temp / "empty.exr").flush();
    std::ofstream(temp / "file.xyz") << "unknown";
    fs::create_directory(temp / "folder.exr");
    for (const char* name :
         {"text.exr", "noise.png", "empty.exr", "file.xyz", "folder.exr", "missing.exr"})
        EXPECT_TRUE(contains(error_of(temp / name), (temp / name).string()))
            << name << ": " << error_of(temp / name);
    EXPECT_TRUE(contains(error_of(temp / "missing.exr"), "no such file"));
    EXPECT_TRUE(contains(error_of(temp / "empty.exr"), "empty"));
    EXPECT_TRUE(contains(error_of(temp / "folder.exr"), "folder"));
}

TEST(ImageRows, TheFinestLevelOfATextureIsRead)
{
    TempFolder temp;
    const Image image = random_image(100, 60, {"R", "G", "B"}, 8);
    write_image(temp / "flat.exr", image);
    const std::string make = "maketx -d float -o " + (temp / "tx.exr").string() + " " +
                             (temp / "flat.exr").string() + " > /dev/null 2>&1";
    if (std::system(make.c_str()) != 0)
        GTEST_SKIP() << "no maketx on PATH";
    EXPECT_EQ(read_all(temp / "tx.exr"), image.pixels);
}

TEST(ImageRows, DescribeTellsSizeAndChannels)
{
    ImageInfo info;
    info.width = 1024;
    info.height = 512;
    info.channels = {"R", "G", "B"};
    EXPECT_EQ(describe(info), "1024x512, channels R,G,B");
}

} // namespace
} // namespace scree::test
