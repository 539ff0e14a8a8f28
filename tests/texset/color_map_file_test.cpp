// Color maps from images, and which reader a file gets.

#include "texset/color_map_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "texset/image_rows.h"
#include "texset/map_files.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

TEST(StripFile, TheFirstRowIsTheMap)
{
    const TempFolder folder;
    const Image image{
        3, 2, {"R", "G", "B"}, {0, 0, 0.5, 1, 2, -1, 0.25, 1, 3, 9, 9, 9, 9, 9, 9, 9, 9, 9}};
    write_image(folder / "a.exr", image);
    const ColorMapFile file = read_color_map(folder / "a.exr");
    EXPECT_EQ(file.kind, "image");
    EXPECT_FALSE(file.states_range);
    EXPECT_FALSE(file.hinge);
    ASSERT_EQ(file.map.knots().size(), 3U);
    EXPECT_EQ(file.map.at(-1), (Rgb{0, 0, 0.5}));
    EXPECT_EQ(file.map.at(0), (Rgb{0, 0, 0.5}));
    EXPECT_EQ(file.map.at(0.25), (Rgb{0.5, 1, -0.25}));
    EXPECT_EQ(file.map.at(0.5), (Rgb{1, 2, -1}));
    EXPECT_EQ(file.map.at(1), (Rgb{0.25, 1, 3}));
}

TEST(StripFile, GrayIsGrayAndAlphaDoesNotCount)
{
    const TempFolder folder;
    write_image(folder / "gray.exr", {2, 1, {"Y"}, {0.25, 0.75}});
    EXPECT_EQ(read_color_map(folder / "gray.exr").map.at(0.5), (Rgb{0.5, 0.5, 0.5}));
    write_image(folder / "a.png", {2, 1, {"R", "G", "B", "A"}, {1, 0, 0, 0.2F, 0, 1, 0, 1}},
                "uint8");
    expect_color(read_color_map(folder / "a.png").map.at(0), {1, 0, 0}, 1e-6);
}

// OpenEXR multiplies colors by alpha.
TEST(StripFile, MultipliedColorIsDividedAgain)
{
    const TempFolder folder;
    OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeDesc::FLOAT);
    const float pixels[] = {0.25F, 0.5F, 0, 0.5F, 1, 1, 1, 1};
    const auto out = OIIO::ImageOutput::create((folder / "a.exr").string());
    ASSERT_TRUE(out && out->open((folder / "a.exr").string(), spec));
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, pixels) && out->close());
    expect_color(read_color_map(folder / "a.exr").map.at(0), {0.5, 1, 0}, 1e-6);
}

TEST(StripFile, OneTexelIsOneColor)
{
    const TempFolder folder;
    write_image(folder / "a.exr", {1, 1, {"R", "G", "B"}, {1, 2, 3}});
    const ColorMapFile file = read_color_map(folder / "a.exr");
    EXPECT_EQ(file.map.knots().size(), 1U);
    EXPECT_EQ(file.map.at(0.7), (Rgb{1, 2, 3}));
}

TEST(StripFile, TheHeadersColorSpaceIsPassedOn)
{
    const TempFolder folder;
    write_image(folder / "a.png", {2, 1, {"R", "G", "B"}, {0, 0, 0, 1, 1, 1}}, "uint8");
    EXPECT_EQ(read_color_map(folder / "a.png").color_space,
              ImageRows(folder / "a.png").info().color_space);
    EXPECT_EQ(read_color_map(folder / "a.png").color_fallback,
              ImageRows(folder / "a.png").info().color_fallback);
}

TEST(StripFile, ATexelWithoutColorIsAnError)
{
    const TempFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    write_image(folder / "a.exr", {3, 1, {"R", "G", "B"}, {0, 0, 0, 1, nan, 1, 1, 1, 1}});
    expect_parts(error_of(folder / "a.exr"), {"texel 1 ", "color"});
    write_image(folder / "b.exr", {2, 1, {"Y"}, {0, std::numeric_limits<float>::infinity()}});
    expect_parts(error_of(folder / "b.exr"), {"texel 1 "});
}

TEST(StripFile, RealStripsAreTheirTexels)
{
    if (data_folder().empty())
        GTEST_SKIP() << "no folder of real data";
    const fs::path folder = data_folder() / "colormaps/image";
    for (const char* name :
         {"cmap-turbo.tif", "cmap-viridis.tif", "cmap_divergent.png", "cmap_hot.png"}) {
        const ColorMap map = read_color_map(folder / name).map;
        const Image image = read_levels(folder / name).at(0);
        ASSERT_GT(image.width, 10) << name;
        for (int i = 0; i < image.width; ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(
                    map.at(static_cast<double>(i) / (image.width - 1))[static_cast<size_t>(c)],
                    static_cast<double>(image.at(i, 0, c)), 1e-6)
                    << name << " texel " << i;
    }
}

TEST(ColorMapFile, TheEndingDecidesWhateverItsCase)
{
    EXPECT_EQ(map_of("a.CPT", "0 black 1 white\n").kind, "cpt");
    EXPECT_EQ(map_of("a.Spi1D", "Version 1\nFrom 0 1\nLength 2\nComponents 1\n{\n0\n1\n}\n").kind,
              "lut");
}

TEST(ColorMapFile, MissingFilesAndFoldersAreNamed)
{
    const TempFolder folder;
    for (const char* name : {"no.cpt", "no.spi1d", "no.png", "no"})
        expect_parts(error_of(folder / name), {"no such file"});
    for (const char* name : {"d.cpt", "d.spi1d", "d.png"}) {
        fs::create_directory(folder / name);
        expect_parts(error_of(folder / name), {"is a folder", "color map"});
    }
    for (const char* name : {"e.cpt", "e.spi1d", "e.png"})
        expect_parts(error_of(name, ""), {"empty"});
    expect_parts(error_of("a.png", "this is no picture"), {"image"});
    expect_parts(error_of("a.txt", "0 black 1 white\n"), {"image"});
}

// Colors of the files, read off them.
TEST(ColorMapFile, RealTablesAreWhatTheirFilesSay)
{
    if (data_folder().empty())
        GTEST_SKIP() << "no folder of real data";
    const fs::path folder = data_folder() / "colormaps/cpt";
    const auto bytes = [](double r, double g, double b) { return Rgb{r / 255, g / 255, b / 255}; };

    const ColorMapFile geo = read_color_map(folder / "geo.cpt");
    EXPECT_TRUE(geo.states_range);
    EXPECT_EQ(geo.map.first(), -8000);
    EXPECT_EQ(geo.map.last(), 8000);
    expect_color(geo.map.at(-500), bytes((141 + 245) / 2.0, (210 + 255) / 2.0, (239 + 255) / 2.0));
    expect_color(geo.map.at(0), bytes(0, 97, 71));
    expect_color(geo.map.at(9000), {1, 1, 1}); // F white

    const ColorMapFile etopo1 = read_color_map(folder / "etopo1.cpt");
    EXPECT_EQ(etopo1.map.first(), -11000);
    EXPECT_EQ(etopo1.map.last(), 8500);
    expect_color(etopo1.map.at(-11000 * 0.545909049628), bytes(12, 68, 231), 1e-9);
    expect_color(etopo1.map.at(8500 * 0.823352961958), bytes(194, 176, 176), 1e-9);

    const ColorMapFile gray = read_color_map(folder / "gray.cpt");
    EXPECT_FALSE(gray.states_range);
    EXPECT_EQ(gray.map.knots().size(), 2U);
    expect_color(gray.map.at(0.25), {0.25, 0.25, 0.25});

    for (const char* name : {"oleron.cpt", "cmocean/topo.cpt"}) {
        const ColorMapFile hinged = read_color_map(folder / name);
        EXPECT_FALSE(hinged.states_range) << name;
        EXPECT_EQ(hinged.hinge->to, 0.0) << name;
        EXPECT_EQ(hinged.map.first(), -1) << name;
    }
    expect_color(read_color_map(folder / "cmocean/topo.cpt").map.at(0), bytes(13, 37, 20));
    expect_color(read_color_map(folder / "cmocean/topo.cpt").map.at(-1e-9), bytes(251, 253, 203));

    const ColorMapFile batlow = read_color_map(folder / "batlow.cpt");
    EXPECT_FALSE(batlow.states_range);
    EXPECT_FALSE(batlow.hinge);
    expect_color(batlow.map.at(0), bytes(1, 25, 89));
    expect_color(batlow.map.at(1), bytes(250, 204, 250));

    // Hue from 255 to 75 over the sea, at saturation 0.6 and value 1; 165 is blue-green.
    const ColorMapFile sealand = read_color_map(folder / "sealand.cpt");
    EXPECT_EQ(sealand.map.first(), -6000);
    EXPECT_EQ(sealand.map.last(), 3000);
    expect_color(sealand.map.at(-3000), {0.4, 1, 0.4 + 0.6 * 0.75}, 1e-5);
    expect_color(sealand.map.at(500), {1, 0.65 + 0.35 * 40 / 60, 0.65}, 1e-5);
}

} // namespace
} // namespace scree::test
