// 1-D LUTs through OpenColorIO.

#include "texset/lut_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "texset/map_files.h"

namespace scree::test {
namespace {

// OpenColorIO reckons in float.
constexpr double kFloat = 1e-6;

TEST(LutFile, KnotsAreTheEntriesOverTheFilesOwnDomain)
{
    const ColorMapFile file =
        map_of("a.spi1d", "Version 1\nFrom -100 300\nLength 5\nComponents 3\n"
                          "{\n0 0 0\n0.5 0.1 2\n0.25 1 -1\n1 1 1\n0 0 9\n}\n");
    EXPECT_EQ(file.kind, "lut");
    EXPECT_EQ(file.color_space, "scene_linear");
    EXPECT_TRUE(file.states_range);
    ASSERT_EQ(file.map.knots().size(), 5U);
    const double xs[] = {-100, 0, 100, 200, 300};
    const Rgb colors[] = {{0, 0, 0}, {0.5, 0.1, 2}, {0.25, 1, -1}, {1, 1, 1}, {0, 0, 9}};
    for (size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(file.map.knots()[i].x, xs[i], 1e-4); // of 400, in float
        expect_color(file.map.knots()[i].color, colors[i], 9 * kFloat);
    }
    EXPECT_EQ(file.map.at(-1e9), file.map.knots().front().color);
}

TEST(LutFile, OverTheUnitRangeItIsToBeStretched)
{
    const ColorMapFile file =
        map_of("a.spi1d", "Version 1\nFrom 0 1\nLength 3\nComponents 1\n{\n0.25\n1\n0.5\n}\n");
    EXPECT_FALSE(file.states_range);
    EXPECT_EQ(file.map.first(), 0);
    EXPECT_EQ(file.map.last(), 1);
    expect_color(file.map.at(0), {0.25, 0.25, 0.25}, kFloat);
    expect_color(file.map.at(0.5), {1, 1, 1}, kFloat);
    expect_color(file.map.at(0.75), {0.75, 0.75, 0.75}, kFloat);
}

TEST(LutFile, CubesOfOneDimensionAreRead)
{
    const ColorMapFile file = map_of("a.cube", "LUT_1D_SIZE 3\nDOMAIN_MIN 0 0 0\n"
                                               "DOMAIN_MAX 50 50 50\n0 0 1\n.2 .4 .6\n1 0 1\n");
    EXPECT_TRUE(file.states_range);
    EXPECT_NEAR(file.map.last(), 50, 1e-5);
    expect_color(file.map.at(12.5), {.1, .2, .8}, kFloat);
}

// The domains of red, green and blue are -2..2, 1..2 and 0..1: each has its own entries.
TEST(LutFile, ChannelsMayHaveDomainsOfTheirOwn)
{
    const ColorMapFile file =
        map_of("a.cube", "LUT_1D_SIZE 3\nDOMAIN_MIN -2 1 0\nDOMAIN_MAX 2 2 1\n"
                         "0 0 0\n1 5 -1\n0 0 0\n");
    EXPECT_NEAR(file.map.first(), -2, 1e-6);
    EXPECT_NEAR(file.map.last(), 2, 1e-6);
    expect_color(file.map.at(0), {1, 0, 0}, 5 * kFloat);
    expect_color(file.map.at(0.5), {0.75, 0, -1}, 5 * kFloat);
    expect_color(file.map.at(1.5), {0.25, 5, 0}, 5 * kFloat);
}

// csp puts a LUT of 65536 entries before its own.
TEST(LutFile, SeveralLutsInARowAreSampled)
{
    std::string text = "CSPLUTV100\n1D\n\n";
    for (int c = 0; c < 3; ++c)
        text += "3\n0 40 100\n0 0.5 1\n"; // the middle entry is at 40
    const ColorMapFile file = map_of("a.csp", text + "\n3\n0 0 0\n1 0.5 0\n0 0 0\n");
    EXPECT_TRUE(file.states_range);
    EXPECT_NEAR(file.map.last(), 100, 1e-4);
    // the prelut's own steps: cubic between its three points, 65536 of them
    expect_color(file.map.at(0), {}, 1e-4);
    expect_color(file.map.at(40), {1, 0.5, 0}, 1e-3);
    expect_color(file.map.at(100), {}, 1e-4);
}

TEST(LutFile, ACurveBehindTheLutIsSampled)
{
    const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                             "<ProcessList id=\"a\" compCLFversion=\"3.0\" "
                             "xmlns=\"http://www.smpte-ra.org/ns/2136-1/2024\">\n";
    const ColorMapFile file =
        map_of("a.clf", head + "<LUT1D inBitDepth=\"32f\" outBitDepth=\"32f\">"
                               "<Array dim=\"2 1\">0 1</Array></LUT1D>"
                               "<Exponent inBitDepth=\"32f\" outBitDepth=\"32f\" "
                               "style=\"basicFwd\"><ExponentParams exponent=\"2\"/></Exponent>"
                               "</ProcessList>\n");
    for (const double x : {0.1, 0.5, 0.9})
        expect_color(file.map.at(x), {x * x, x * x, x * x}, kFloat);
}

TEST(LutFile, KnotsThatALineReplacesAreLeftOut)
{
    std::string text = "Version 1\nFrom 0 1\nLength 1001\nComponents 1\n{\n";
    for (int i = 0; i <= 1000; ++i)
        text += std::to_string(i <= 400 ? i / 1000.0 : 0.4) + "\n";
    EXPECT_EQ(map_of("a.spi1d", text + "}\n").map.knots().size(), 3U);
}

TEST(LutFile, AChangedFileIsReadAgain)
{
    const TempFolder folder;
    const std::string head = "Version 1\nFrom 0 1\nLength 2\nComponents 1\n{\n";
    expect_color(read_color_map(written(folder, "a.spi1d", head + "0\n1\n}\n")).map.at(1),
                 {1, 1, 1}, kFloat);
    expect_color(read_color_map(written(folder, "a.spi1d", head + "0\n5\n}\n")).map.at(1),
                 {5, 5, 5}, 5 * kFloat);
}

TEST(LutFile, ThreeDimensionsAreNotOne)
{
    const std::string message = error_of(
        "a.cube", "LUT_3D_SIZE 2\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 0\n");
    expect_parts(message, {"3-D LUT", "expected a 1-D LUT"});
}

TEST(LutFile, WhatOpenColorIoCannotReadIsNamed)
{
    expect_parts(error_of("a.spi1d", "nothing\n"), {"cannot read it as a LUT", "give a 1-D LUT"});
    expect_parts(error_of("a.spi1d", "Version 1\nFrom 0 1\nLength 3\nComponents 1\n{\n0\n"),
                 {"cannot read it as a LUT"});
    expect_parts(error_of("a.cube", std::string(5000, '\0')), {"cannot read it as a LUT"});
    expect_parts(error_of("a.spi1d", "Version 1\nFrom 0 1\nLength 2\nComponents 1\n{\nnan\n1\n}\n"),
                 {"entry 0 ", "not a finite number"});
    expect_parts(error_of("a.spi1d", "Version 1\nFrom 0 1\nLength 2\nComponents 1\n{\n0\ninf\n}\n"),
                 {"entry 1 ", "not a finite number"});
    expect_parts(error_of("a.spi1d", "Version 1\nFrom 1 1\nLength 2\nComponents 1\n{\n0\n1\n}\n"),
                 {"domain"});
    expect_parts(error_of("a.spimtx", "1 0 0 0\n0 1 0 0\n0 0 1 0\n"), {"holds no LUT"});
}

// OpenColorIO refuses more than a million entries before it makes room for them.
TEST(LutFile, AClaimOfBillionsIsRefused)
{
    for (const char* count : {"2000000000", "200000000", "99999999999999999999"}) {
        const std::string n = count;
        (void)error_of("a.spi1d",
                       "Version 1\nFrom 0 1\nLength " + n + "\nComponents 3\n{\n0 0 0\n}\n");
        (void)error_of("a.cube", "LUT_1D_SIZE " + n + "\n0 0 0\n1 1 1\n");
        (void)error_of("a.lut", "LUT: 1 " + n + "\n0\n1\n");
    }
}

TEST(LutFile, EveryRealLutIsReadOrRefused)
{
    const auto folder = data_folder() / "colormaps/lut";
    if (data_folder().empty())
        GTEST_SKIP() << "no folder of real data";
    // spi1d of one component, written out: entry i of n is at low + i / (n - 1) (high - low)
    const ColorMapFile srgb = read_color_map(folder / "sRGB_to_linear.spi1d");
    EXPECT_TRUE(srgb.states_range);
    EXPECT_NEAR(srgb.map.first(), -0.125, 1e-6);
    EXPECT_NEAR(srgb.map.last(), 1.125, 1e-6);
    for (const double v : {0.05, 0.1, 0.5, 0.9, 1.0}) {
        const double want = std::pow((v + 0.055) / 1.055, 2.4);
        expect_color(srgb.map.at(v), {want, want, want}, 1e-5);
    }
    const ColorMapFile curve = read_color_map(folder / "lut1d_32f_example.clf");
    for (const double v : {0.0, 0.25, 0.5, 1.0}) { // its header gives the formula
        const double want = 1.25 - 1.5 * std::pow(v, 2.2);
        expect_color(curve.map.at(v), {want, want, want}, 1e-5);
    }
    EXPECT_NEAR(read_color_map(folder / "lut1d_4.spi1d").map.at(-1)[0], -6, 1e-5);
    EXPECT_FALSE(read_color_map(folder / "houdini.lut").states_range);
    for (const char* name : {"iridas_3d.cube", "resolve_1d3d.cube", "lut3d_arbitrary.csp",
                             "lut3d_as_matrix.clf", "lut3d_red-only.csp"})
        expect_parts(error_of(folder / name), {"expected a 1-D LUT"});
}

TEST(LutFile, EveryBrokenLutIsRefused)
{
    const auto folder = data_folder() / "badinput/lut";
    if (data_folder().empty())
        GTEST_SKIP() << "no folder of real data";
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) {
            EXPECT_FALSE(error_of(entry.path()).empty());
            ++count;
        }
    EXPECT_GE(count, 20);
}

} // namespace
} // namespace scree::test
