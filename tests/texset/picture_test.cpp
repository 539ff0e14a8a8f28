// Pictures hold the light they were given.

#include "texset/picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "math/error.h"
#include "support/color.h"
#include "support/files.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// 256 pixels, all reds by linear light, and blues of the curve's straight part.
Picture ramp()
{
    Picture picture{16, 16, {}};
    for (int i = 0; i < 256; ++i)
        picture.rgb.insert(picture.rgb.end(),
                           {static_cast<float>(i) / 255.0F, static_cast<float>(i % 16) / 15.0F,
                            static_cast<float>(i) * 2e-5F});
    return picture;
}

std::vector<uint8_t> pixels_of_png(const std::vector<uint8_t>& png)
{
    OIIO::Filesystem::IOMemReader memory(png.data(), png.size());
    auto in = OIIO::ImageInput::open("memory.png", nullptr, &memory);
    if (!in) {
        ADD_FAILURE() << OIIO::geterror();
        return {};
    }
    EXPECT_EQ(in->spec().nchannels, 3);
    std::vector<uint8_t> pixels(static_cast<size_t>(in->spec().image_pixels()) * 3);
    EXPECT_TRUE(in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data()));
    return pixels;
}

/// The entries of a folder but for one.
int others_in(const fs::path& folder, const std::string& name)
{
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
        count += entry.path().filename() != name ? 1 : 0;
    return count;
}

TEST(Picture, PngIsSrgbOfTheLight)
{
    const Picture picture = ramp();
    const auto pixels = pixels_of_png(png_bytes(picture));
    ASSERT_EQ(pixels.size(), picture.rgb.size());
    for (size_t i = 0; i < pixels.size(); ++i) {
        const double exact = 255 * srgb_of_linear(static_cast<double>(picture.rgb[i]));
        EXPECT_NEAR(pixels[i], exact, 0.501) << "number " << i; // rounding to bytes, and of floats
    }
}

TEST(Picture, LightBeyondTheRangeIsClampedAndNanIsMagenta)
{
    const Picture picture{4, 1, {-1, 2, kInfinity, kNan, 0, 0, 0, 0, kNan, -kInfinity, 1, 0}};
    EXPECT_EQ(pixels_of_png(png_bytes(picture)),
              (std::vector<uint8_t>{0, 255, 255, 255, 0, 255, 255, 0, 255, 0, 255, 0}));
}

TEST(Picture, EqualPicturesAreEqualBytes) { EXPECT_EQ(png_bytes(ramp()), png_bytes(ramp())); }

TEST(Picture, FilesHoldLightOrSrgbByTheirEnding)
{
    const TempFolder folder;
    const Picture picture = ramp();
    write_picture(picture, folder / "light.exr");
    const auto light = read_levels(folder / "light.exr");
    ASSERT_EQ(light.size(), 1U);
    EXPECT_EQ(light[0].pixels, picture.rgb);

    for (const char* name : {"shown.png", "shown.JPG", "shown.tif"}) {
        write_picture(picture, folder / name);
        const auto shown = read_levels(folder / name);
        ASSERT_EQ(shown.size(), 1U) << name;
        const double lost =
            std::string(name) == "shown.JPG" ? 0.06 : 0.501 / 255; // JPEG's own loss
        for (size_t i = 0; i < picture.rgb.size(); i += 3)
            EXPECT_NEAR(shown[0].pixels[i], srgb_of_linear(static_cast<double>(picture.rgb[i])),
                        lost)
                << name << " number " << i;
    }
    EXPECT_EQ(read_bytes(folder / "shown.png"),
              std::string(reinterpret_cast<const char*>(png_bytes(picture).data()),
                          png_bytes(picture).size()));
}

TEST(Picture, ReplacesAFileAndLeavesNothingElse)
{
    const TempFolder folder;
    std::ofstream(folder / "a.png") << "old";
    write_picture(ramp(), folder / "a.png");
    EXPECT_EQ(read_levels(folder / "a.png").size(), 1U);
    EXPECT_EQ(others_in(folder.path(), "a.png"), 0);
}

TEST(Picture, ARefusalNamesTheFileAndLeavesWhatWasThere)
{
    const TempFolder folder;
    fs::create_directory(folder / "a.png"); // a folder in the way: the last step fails
    for (const std::string name : {"missing/a.png", "a.unknown", "noending", "a.png"}) {
        try {
            write_picture(ramp(), folder / name);
            ADD_FAILURE() << name << " was written";
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find((folder / name).string()), std::string::npos)
                << e.what();
            EXPECT_NE(std::string(e.what()).find(": cannot be written: "), std::string::npos);
            EXPECT_EQ(std::string(e.what()).find(".scree-"), std::string::npos) << e.what();
        }
    }
    EXPECT_EQ(others_in(folder.path(), "a.png"), 0);
}

} // namespace
} // namespace scree::test
