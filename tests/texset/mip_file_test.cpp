// Tiled, MIP-mapped files: every bit written comes back, through two readers.

#include "texset/mip_file.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledInputFile.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "math/error.h"
#include "sample/lattice_noise.h"
#include "support/files.h"

namespace scree::test {
namespace {

constexpr Compression kCompressions[] = {Compression::none, Compression::rle, Compression::zips,
                                         Compression::zip, Compression::piz};
constexpr std::pair<int, int> kSizes[] = {{1, 1},   {1, 7},   {7, 1},   {3, 3},
                                          {63, 65}, {64, 64}, {65, 63}, {130, 70},
                                          {257, 1}, {2, 129}, {99, 99}, {128, 32}};

/// One number: of a level, a channel, a texel. Finite, and smooth enough that tiles compress.
using Bits = uint32_t;

Bits bits_of(PixelType type, int level, int channel, int x, int y, bool rough)
{
    const auto key = static_cast<uint32_t>(((level * 8 + channel) * 512 + y) * 512 + x);
    const float noise = unit_float(hash32(key));
    const float smooth = static_cast<float>(x / 4 + 2 * (y / 8)) * 0.125F;
    const float value = static_cast<float>(100 * channel - 10 * level) + (rough ? noise : smooth);
    if (type == PixelType::half)
        return half(value).bits();
    Bits bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

void write_levels(const std::filesystem::path& path, const MipLayout& layout, bool rough,
                  bool coarse_first)
{
    MipFile file(path, layout);
    std::vector<std::pair<int, int>> rows; // level, tile_y
    for (int level = 0; level < file.levels(); ++level)
        for (int tile_y = 0; tile_y * kTileSize < file.level_height(level); ++tile_y)
            rows.emplace_back(level, tile_y);
    if (coarse_first)
        std::reverse(rows.begin(), rows.end());
    const size_t size = pixel_bytes(layout.type);
    TileRow row; // the same for all: as a baker does, with whatever the last left in it
    for (const auto& [level, tile_y] : rows) {
        file.prepare(row, level, tile_y);
        const auto tiles = static_cast<int>(row.sizes.size());
        const int end = std::min((tile_y + 1) * kTileSize, file.level_height(level));
        for (int tile_x = 0; tile_x < tiles; ++tile_x) {
            for (int y = tile_y * kTileSize; y < end; ++y)
                for (int c = 0; c < static_cast<int>(layout.channels.size()); ++c) {
                    int pixels = 0;
                    uint8_t* line = file.line(row, tile_x, y, c, pixels);
                    for (int x = 0; x < pixels; ++x) {
                        const Bits bits =
                            bits_of(layout.type, level, c, tile_x * kTileSize + x, y, rough);
                        std::memcpy(line + static_cast<size_t>(x) * size, &bits, size);
                    }
                }
            file.encode(row, tile_x);
        }
        file.write(row);
    }
    file.close();
}

/// The first texel of a level that is not what was written; empty when there is none.
std::string first_difference(const std::vector<uint8_t>& pixels, const MipLayout& layout, int level,
                             int width, int height, bool rough)
{
    const size_t size = pixel_bytes(layout.type);
    const uint8_t* at = pixels.data();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < static_cast<int>(layout.channels.size()); ++c, at += size) {
                Bits bits = 0;
                std::memcpy(&bits, at, size);
                if (bits != bits_of(layout.type, level, c, x, y, rough))
                    return "level " + std::to_string(level) + " texel (" + std::to_string(x) +
                           ", " + std::to_string(y) + ") channel " +
                           layout.channels[static_cast<size_t>(c)];
            }
    return {};
}

std::string difference_to_openimageio(const std::filesystem::path& path, const MipLayout& layout,
                                      bool rough)
{
    const auto in = OIIO::ImageInput::open(path.string());
    if (!in)
        return "OpenImageIO cannot open it: " + OIIO::geterror();
    int level = 0;
    for (; in->seek_subimage(0, level); ++level) {
        const OIIO::ImageSpec spec = in->spec();
        if (spec.width != std::max(1, layout.width >> level) ||
            spec.height != std::max(1, layout.height >> level))
            return "size of level " + std::to_string(level);
        if (spec.tile_width != kTileSize || spec.tile_height != kTileSize)
            return "tile size of level " + std::to_string(level);
        if (spec.channelnames != layout.channels)
            return "channels";
        if (spec.format.size() != pixel_bytes(layout.type))
            return "pixel type";
        std::vector<uint8_t> pixels(spec.image_bytes());
        if (!in->read_image(0, level, 0, spec.nchannels, spec.format, pixels.data()))
            return in->geterror();
        auto found = first_difference(pixels, layout, level, spec.width, spec.height, rough);
        if (!found.empty())
            return found;
    }
    const bool all = std::max(1, layout.width >> (level - 1)) == 1 &&
                     std::max(1, layout.height >> (level - 1)) == 1;
    return all ? "" : "levels end at " + std::to_string(level);
}

std::string difference_to_openexr(const std::filesystem::path& path, const MipLayout& layout,
                                  bool rough)
{
    Imf::TiledInputFile in(path.c_str());
    if (!in.isComplete())
        return "OpenEXR calls it incomplete";
    if (in.levelMode() != Imf::MIPMAP_LEVELS || in.levelRoundingMode() != Imf::ROUND_DOWN)
        return "level mode";
    const auto type = layout.type == PixelType::half ? Imf::HALF : Imf::FLOAT;
    const size_t size = pixel_bytes(layout.type);
    const size_t stride = size * layout.channels.size();
    for (int level = 0; level < in.numLevels(); ++level) {
        const auto width = static_cast<size_t>(in.levelWidth(level));
        std::vector<uint8_t> pixels(width * static_cast<size_t>(in.levelHeight(level)) * stride);
        Imf::FrameBuffer frame;
        for (size_t c = 0; c < layout.channels.size(); ++c)
            frame.insert(layout.channels[c],
                         Imf::Slice(type, reinterpret_cast<char*>(pixels.data()) + c * size, stride,
                                    stride * width));
        in.setFrameBuffer(frame);
        in.readTiles(0, in.numXTiles(level) - 1, 0, in.numYTiles(level) - 1, level);
        auto found = first_difference(pixels, layout, level, in.levelWidth(level),
                                      in.levelHeight(level), rough);
        if (!found.empty())
            return found;
    }
    return {};
}

TEST(MipFile, EveryBitComesBackThroughOpenImageIOAndOpenEXR)
{
    for (const Compression compression : kCompressions)
        for (const PixelType type : {PixelType::half, PixelType::float32})
            for (const auto& [width, height] : kSizes)
                for (const bool rough : {false, true}) {
                    TempFolder temp;
                    const MipLayout layout{width, height,      {"s", "ss", "st", "t", "tt"},
                                           type,  compression, {}};
                    write_levels(temp / "a.exr", layout, rough, false);
                    const std::string what = compression_name(compression) + " " +
                                             pixel_type_name(type) + " " + std::to_string(width) +
                                             "x" + std::to_string(height) + (rough ? " rough" : "");
                    EXPECT_EQ(difference_to_openimageio(temp / "a.exr", layout, rough), "") << what;
                    EXPECT_EQ(difference_to_openexr(temp / "a.exr", layout, rough), "") << what;
                }
}

TEST(MipFile, TilesMayComeInAnyOrder)
{
    TempFolder temp;
    const MipLayout layout{200, 150, {"h", "hh"}, PixelType::float32, Compression::zip, {}};
    write_levels(temp / "a.exr", layout, false, true);
    EXPECT_EQ(difference_to_openimageio(temp / "a.exr", layout, false), "");
    EXPECT_EQ(difference_to_openexr(temp / "a.exr", layout, false), "");
}

// OpenEXR sorts channels by name whatever order they are given in: B before R.
TEST(MipFile, ChannelsKeepTheirNumbersWhenTheFileSortsTheirNames)
{
    TempFolder temp;
    const MipLayout layout{70, 5, {"R", "G", "B"}, PixelType::half, Compression::zip, {}};
    write_levels(temp / "a.exr", layout, true, false);
    EXPECT_EQ(difference_to_openexr(temp / "a.exr", layout, true), "");
    EXPECT_EQ(difference_to_openimageio(temp / "a.exr", layout, true), "");
}

TEST(MipFile, LevelsAreRoundedDownToOneByOne)
{
    TempFolder temp;
    for (const auto& [width, height] : kSizes) {
        const MipFile file(temp / "a.exr",
                           {width, height, {"h"}, PixelType::half, Compression::none, {}});
        const int last = file.levels() - 1;
        EXPECT_EQ(file.levels(), 1 + static_cast<int>(std::log2(std::max(width, height))));
        EXPECT_EQ(file.level_width(0), width);
        EXPECT_EQ(file.level_height(0), height);
        EXPECT_EQ(file.level_width(last), 1) << width << "x" << height;
        EXPECT_EQ(file.level_height(last), 1) << width << "x" << height;
        for (int level = 1; level <= last; ++level)
            EXPECT_EQ(file.level_width(level), std::max(1, file.level_width(level - 1) / 2));
    }
}

TEST(MipFile, AttributesOfEveryKindAreInTheHeader)
{
    TempFolder temp;
    const MipLayout layout{4,
                           4,
                           {"h"},
                           PixelType::half,
                           Compression::zip,
                           {{"wrapmodes", std::string("periodic,clamp")},
                            {"scree:meaning", std::string("a much longer text than fits a "
                                                          "small string, with spaces")},
                            {"scree:count", 7},
                            {"scree:single", 0.1F},
                            {"scree:h0", 0.1}}};
    write_levels(temp / "a.exr", layout, false, false);
    const auto in = OIIO::ImageInput::open((temp / "a.exr").string());
    ASSERT_TRUE(in) << OIIO::geterror();
    const OIIO::ImageSpec& spec = in->spec();
    EXPECT_EQ(spec.get_string_attribute("wrapmodes"), "periodic,clamp");
    EXPECT_EQ(spec.get_string_attribute("scree:meaning"),
              std::get<std::string>(layout.attributes[1].second));
    EXPECT_EQ(spec.get_int_attribute("scree:count"), 7);
    EXPECT_EQ(spec.get_float_attribute("scree:single"), 0.1F);
    double h0 = 0;
    EXPECT_TRUE(spec.getattribute("scree:h0", OIIO::TypeDesc::DOUBLE, &h0));
    EXPECT_EQ(h0, 0.1); // all 53 bits
}

TEST(MipFile, AFileWithoutItsLastTilesIsNoTexture)
{
    TempFolder temp;
    const MipLayout layout{128, 128, {"h"}, PixelType::float32, Compression::none, {}};
    {
        MipFile file(temp / "a.exr", layout);
        TileRow row;
        file.prepare(row, 0, 0);
        file.write(row);
    }
    bool complete = true;
    try {
        complete = Imf::TiledInputFile((temp / "a.exr").c_str()).isComplete();
    } catch (const std::exception&) {
        complete = false;
    }
    EXPECT_FALSE(complete);
}

TEST(MipFile, AFolderThatIsNotThereIsNamed)
{
    TempFolder temp;
    const auto path = temp / "missing" / "a.exr";
    try {
        MipFile file(path, {4, 4, {"h"}, PixelType::half, Compression::zip, {}});
        ADD_FAILURE() << "opened";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find(path.string()), std::string::npos) << e.what();
    }
}

} // namespace
} // namespace scree::test
