// `--layout bumpslopes --reconstruction sobel --wrap clamp` against `maketx --bumpslopes`.
//
// On sizes that are powers of two both mean the same; elsewhere maketx drops texels, and its slopes
// from integer, [0, 1] or periodic inputs differ by its own mistakes (docs/failure-cases.md).

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "pipeline/bake.h"
#include "support/files.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

bool has_maketx() { return std::system("maketx --version > /dev/null 2>&1") == 0; }

std::vector<Image> by_maketx(const fs::path& input, const fs::path& output,
                             const std::string& options)
{
    const std::string command = "maketx --bumpslopes " + options + " -o '" + output.string() +
                                "' '" + input.string() + "' > /dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return read_levels(output);
}

BakeOptions like_maketx(const fs::path& input, const fs::path& output)
{
    BakeOptions options;
    options.height_file = input;
    options.output = output;
    options.name = "ours";
    options.layout = Layout::bumpslopes;
    options.reconstruction = Reconstruction::sobel;
    options.wrap_s = options.wrap_t = Wrap::clamp;
    options.texel_size = {{1, 1}};
    options.pixel_type = PixelTypeChoice::float32;
    return options;
}

std::vector<Image> by_scree(const BakeOptions& options)
{
    bake(options);
    return read_levels(options.output / "ours.bumpslopes.exr");
}

/// Largest number of a channel at level 0: what its rounding errors are measured against.
double scale_of(const Image& level, int channel)
{
    double largest = 0;
    for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x)
            largest = std::max(largest, std::abs(static_cast<double>(level.at(x, y, channel))));
    return largest;
}

// maketx rounds to float at every step: six additions in a slope, one product, and the four terms
// of an average, whose own error is no larger than the largest of theirs and shrinks with the mean.
// Ours rounds once, at the end, and then E[ss] may be one step up. 4 * 2^-24 of the largest number
// that goes in; a second moment has twice the relative error of its slopes.
void expect_equal_to_float_rounding(const std::vector<Image>& ours,
                                    const std::vector<Image>& theirs, double height_scale)
{
    ASSERT_FALSE(theirs.empty());
    ASSERT_EQ(ours.size(), theirs.size()) << "levels";
    for (size_t level = 0; level < ours.size(); ++level) {
        ASSERT_EQ(ours[level].channels, theirs[level].channels); // names and order
        ASSERT_EQ(ours[level].width, theirs[level].width);
        ASSERT_EQ(ours[level].height, theirs[level].height);
        for (int c = 0; c < 6; ++c) {
            const double steps = 4 * 0x1p-24;
            // errors of a slope come from heights, not from the slope, which may be small
            const double slope = std::max(scale_of(theirs[0], c < 3 ? 1 : 3), height_scale);
            const double bound = c < 3 ? steps * height_scale : 2 * steps * slope * height_scale;
            double worst = 0;
            int worst_x = 0, worst_y = 0;
            for (int y = 0; y < ours[level].height; ++y)
                for (int x = 0; x < ours[level].width; ++x) {
                    const double difference =
                        std::abs(static_cast<double>(ours[level].at(x, y, c)) -
                                 static_cast<double>(theirs[level].at(x, y, c)));
                    if (!(difference <= worst)) {
                        worst = difference;
                        worst_x = x;
                        worst_y = y;
                    }
                }
            EXPECT_LE(worst, bound)
                << ours[level].channels[static_cast<size_t>(c)] << " level " << level << " texel ("
                << worst_x << ", " << worst_y << "): " << ours[level].at(worst_x, worst_y, c)
                << ", maketx " << theirs[level].at(worst_x, worst_y, c);
        }
    }
}

TEST(MaketxParity, RandomHeightsAreEqualToFloatRoundingAtEveryLevel)
{
    if (!has_maketx())
        GTEST_SKIP() << "no maketx on PATH";
    for (const auto& [width, height] :
         {std::pair(64, 64), {128, 32}, {32, 128}, {256, 256}, {1, 1}, {64, 1}, {2, 2}})
        for (const char* type : {"float", "half"}) {
            TempFolder temp;
            const Image image = random_image(width, height, {"Y"},
                                             static_cast<unsigned>(width * 1000 + height), -2, 2);
            write_image(temp / "h.exr", image, type);
            SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + " " + type);
            expect_equal_to_float_rounding(
                by_scree(like_maketx(temp / "h.exr", temp / "set")),
                by_maketx(temp / "h.exr", temp / "maketx.exr", "-d float"), 2);
        }
}

// Slopes of a plane and a ridge have one sign over the map: no mean is 0, no error averages out.
TEST(MaketxParity, SteepHeightsAreEqualToFloatRoundingAtEveryLevel)
{
    if (!has_maketx())
        GTEST_SKIP() << "no maketx on PATH";
    TempFolder temp;
    Image image{64, 64, {"Y"}, {}};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            image.pixels.push_back(static_cast<float>(3 * x - 2 * std::abs(y - 20)) + 0.3F);
    write_image(temp / "h.exr", image);
    expect_equal_to_float_rounding(by_scree(like_maketx(temp / "h.exr", temp / "set")),
                                   by_maketx(temp / "h.exr", temp / "maketx.exr", "-d float"), 190);
}

TEST(MaketxParity, TheNoiseOfOpenImageIOsOwnTestIsEqualToFloatRounding)
{
    const fs::path bump = data_folder() / "reference/openimageio_maketx/bump.exr";
    if (data_folder().empty() || !fs::exists(bump))
        GTEST_SKIP() << "no " << bump;
    if (!has_maketx())
        GTEST_SKIP() << "no maketx on PATH";
    TempFolder temp;
    const double largest = scale_of(read_levels(bump)[0], 0);
    expect_equal_to_float_rounding(by_scree(like_maketx(bump, temp / "set")),
                                   by_maketx(bump, temp / "maketx.exr", "-d float"), largest);
}

// The attributes a renderer looks at.
TEST(MaketxParity, FilesAreTiledAndTaggedAlike)
{
    if (!has_maketx())
        GTEST_SKIP() << "no maketx on PATH";
    TempFolder temp;
    write_image(temp / "h.exr", random_image(64, 64, {"Y"}, 1));
    by_scree(like_maketx(temp / "h.exr", temp / "set"));
    by_maketx(temp / "h.exr", temp / "maketx.exr", "-d float --wrap clamp");
    const auto ours = OIIO::ImageInput::open((temp / "set" / "ours.bumpslopes.exr").string());
    const auto theirs = OIIO::ImageInput::open((temp / "maketx.exr").string());
    ASSERT_TRUE(ours && theirs);
    EXPECT_EQ(ours->spec().channelnames, theirs->spec().channelnames);
    EXPECT_EQ(ours->spec().format, theirs->spec().format);
    EXPECT_EQ(ours->spec().tile_width, theirs->spec().tile_width);
    EXPECT_EQ(ours->spec().tile_height, theirs->spec().tile_height);
    for (const char* name : {"textureformat", "wrapmodes"})
        EXPECT_EQ(ours->spec().get_string_attribute(name),
                  theirs->spec().get_string_attribute(name));
}

// Normals in [0, 1], which maketx reads as such from version 2.5 on. Means: the two programs may
// round to neighbouring halves, 2^-10 relative (2^-24 among subnormal numbers). Second moments:
// theirs are rounded to the nearest (2^-11); ours so that no variance is negative: at least the
// square of the rounded mean (2^-10), and up to the next half (2^-10).
TEST(MaketxParity, ANormalMapEqualsOpenImageIOsReferenceToHalfRounding)
{
    const fs::path folder = data_folder() / "reference/openimageio_maketx";
    if (data_folder().empty() || !fs::exists(folder / "normal.exr"))
        GTEST_SKIP() << "no " << folder;
    TempFolder temp;
    BakeOptions options = like_maketx(folder / "normal.exr", temp / "set");
    options.normal_input = true;
    options.pixel_type = PixelTypeChoice::half;
    const auto ours = by_scree(options);
    const auto theirs = read_levels(folder / "bumpslope-normal.exr");
    ASSERT_EQ(ours.size(), 8U);
    ASSERT_EQ(ours.size(), theirs.size());
    for (size_t level = 0; level < ours.size(); ++level) {
        ASSERT_EQ(ours[level].channels, theirs[level].channels);
        ASSERT_EQ(ours[level].width, theirs[level].width);
        for (int c = 0; c < 6; ++c)
            for (int y = 0; y < ours[level].height; ++y)
                for (int x = 0; x < ours[level].width; ++x) {
                    const auto a = static_cast<double>(ours[level].at(x, y, c));
                    const auto b = static_cast<double>(theirs[level].at(x, y, c));
                    const auto second = static_cast<double>(theirs[level].at(x, y, 3)) +
                                        static_cast<double>(theirs[level].at(x, y, 4));
                    const double bound =
                        c < 3 ? 0x1p-10 * std::abs(b) + 0x1p-24 : 2.5 * 0x1p-10 * second + 0x1p-23;
                    ASSERT_NEAR(a, b, bound)
                        << ours[level].channels[static_cast<size_t>(c)] << " level " << level
                        << " texel (" << x << ", " << y << ")";
                }
    }
}

// And the program on this machine, from the same normals.
TEST(MaketxParity, ANormalMapEqualsMaketxToFloatRounding)
{
    if (!has_maketx())
        GTEST_SKIP() << "no maketx on PATH";
    TempFolder temp;
    Image normals = random_image(64, 64, {"R", "G", "B"}, 5, -1, 1);
    for (size_t i = 2; i < normals.pixels.size(); i += 3)
        normals.pixels[i] = 0.75F + normals.pixels[i] / 4; // faces outward
    write_image(temp / "n.exr", normals);
    BakeOptions options = like_maketx(temp / "n.exr", temp / "set");
    options.normal_input = true;
    const auto ours = by_scree(options);
    const auto theirs =
        by_maketx(temp / "n.exr", temp / "maketx.exr", "-d float --bumpformat normal");
    expect_equal_to_float_rounding(ours, theirs, 2); // slopes up to 2
    for (const float height : {ours[0].at(3, 5, 0), ours.back().at(0, 0, 0)})
        EXPECT_EQ(height, -1) << "maketx marks a missing height with -1";
}

} // namespace
} // namespace scree::test
