#include "texset/mip_reader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "math/error.h"
#include "pipeline/bake.h"
#include "sample/field.h"
#include "support/files.h"
#include "support/random_image.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

/// Bakes a fractal whose levels have more than one tile and odd sizes; returns the slope's file.
std::filesystem::path baked_slopes(const TempFolder& temp, PixelTypeChoice type)
{
    const auto field = make_sample("fractal", 131, 97);
    MemorySource source = sample_source(*field, 131, 97);
    BakeOptions options;
    options.output = temp / "set";
    options.texel_size = {1, 1};
    options.maps = {Map::slope};
    options.pixel_type = type;
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
    return temp / "set" / "test.slope.exr";
}

std::string error_of(const std::filesystem::path& file)
{
    try {
        MipReader reader(file);
        static_cast<void>(reader.rows(0, 0, reader.height(0)));
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(MipReader, GivesTheRowsOfEveryLevelAsTheFileHoldsThem)
{
    for (const auto type : {PixelTypeChoice::half, PixelTypeChoice::float32}) {
        const TempFolder temp;
        const auto file = baked_slopes(temp, type);
        const auto levels = read_levels(file);
        MipReader reader(file);
        ASSERT_EQ(reader.levels(), 8);
        EXPECT_EQ(reader.channels(), map_info(Map::slope).channels);
        for (int level = 0; level < reader.levels(); ++level) {
            const Image& whole = levels[static_cast<size_t>(level)];
            ASSERT_EQ(reader.width(level), whole.width);
            ASSERT_EQ(reader.height(level), whole.height);
            for (const int count : {1, 7, 64, 70})
                for (int first = 0; first + count <= whole.height; first += 29) {
                    const auto rows = reader.rows(level, first, count);
                    const auto stride = static_cast<size_t>(whole.width) * 5;
                    ASSERT_EQ(rows.size(), stride * static_cast<size_t>(count));
                    EXPECT_TRUE(std::equal(rows.begin(), rows.end(),
                                           whole.pixels.begin() +
                                               static_cast<std::ptrdiff_t>(stride) * first))
                        << "level " << level << ", rows " << first << " + " << count;
                }
        }
    }
}

TEST(MipReader, ReadsAPlainImageAsOneLevel)
{
    const TempFolder temp;
    const Image image = random_image(9, 6, {"R", "G", "B"}, 1);
    write_image(temp / "table.exr", image);
    MipReader reader(temp / "table.exr");
    EXPECT_EQ(reader.levels(), 1);
    EXPECT_EQ(reader.rows(0, 0, 6), image.pixels);
    EXPECT_EQ(reader.rows(0, 4, 1),
              std::vector<float>(image.pixels.begin() + 4 * 27, image.pixels.begin() + 5 * 27));
}

TEST(MipReader, NamesTheFileThatIsMissingNoImageOrCut)
{
    const TempFolder temp;
    EXPECT_NE(error_of(temp / "no.exr").find("no.exr"), std::string::npos);
    std::ofstream(temp / "words.exr") << "no image";
    EXPECT_NE(error_of(temp / "words.exr").find("words.exr"), std::string::npos);
    const auto file = baked_slopes(temp, PixelTypeChoice::float32);
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    EXPECT_NE(error_of(file).find("test.slope.exr"), std::string::npos);
}

} // namespace
} // namespace scree::test
