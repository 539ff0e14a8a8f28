// Color tables of GMT, written by hand: every number is in the text.

#include "texset/cpt_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "texset/cpt_colors.h"
#include "texset/map_files.h"

namespace scree::test {
namespace {

ColorMapFile cpt(const std::string& text) { return map_of("a.cpt", text); }
std::string cpt_error(const std::string& text) { return error_of("a.cpt", text); }

Rgb bytes(double r, double g, double b) { return {r / 255, g / 255, b / 255}; }

TEST(CptFile, PiecesAreStraightAndOfTheirOwnUnits)
{
    const ColorMapFile file = cpt("# a comment = nothing\n"
                                  "\n"
                                  "-100 0/0/0   50 100/200/50\n"
                                  "50 100/200/50 300 255/255/255\r\n");
    EXPECT_EQ(file.kind, "cpt");
    EXPECT_EQ(file.color_space, "sRGB");
    EXPECT_TRUE(file.states_range);
    EXPECT_FALSE(file.hinge);
    EXPECT_EQ(file.map.knots().size(), 3U);
    EXPECT_EQ(file.map.first(), -100);
    EXPECT_EQ(file.map.last(), 300);
    expect_color(file.map.at(-25), bytes(50, 100, 25));
    expect_color(file.map.at(50), bytes(100, 200, 50));
    expect_color(file.map.at(1000), bytes(255, 255, 255));
}

TEST(CptFile, OneColorAPieceIsSteps)
{
    const ColorMap map = cpt("0 red 10 red\n10 0/0/255 20 0/0/255 L ;deep; sea\n").map;
    expect_color(map.at(9.999), bytes(255, 0, 0));
    expect_color(map.at(10), bytes(0, 0, 255));
    EXPECT_EQ(map.knots().size(), 4U);
}

TEST(CptFile, ColorsMayBeWrittenInManyWays)
{
    const struct {
        const char* text;
        Rgb want;
    } cases[] = {
        {"10/20/30", bytes(10, 20, 30)},
        {"10.5/20/30@40", bytes(10.5, 20, 30)},
        {"77", bytes(77, 77, 77)},
        {"#fF8000", bytes(255, 128, 0)},
        {"120-1-1", bytes(0, 255, 0)},
        {"60-0.5-0.8", {0.8, 0.8, 0.4}},
        {"2e2-1e-2-1", {0.99, 0.99 + 0.01 * 2 / 3, 1}},
        {"black", {}},
        {"White", {1, 1, 1}},
        {"GRAY", bytes(190, 190, 190)},
        {"grey50", bytes(127, 127, 127)},
        {"gray100", {1, 1, 1}},
        {"gray10", bytes(26, 26, 26)},
        {"orange", bytes(255, 165, 0)},
        {"brown", bytes(165, 42, 42)},
        {"purple", bytes(160, 32, 240)},
        {"pink", bytes(255, 192, 203)},
    };
    for (const auto& [text, want] : cases) {
        SCOPED_TRACE(text);
        expect_color(cpt(std::string("5 ") + text + " 6 " + text + "\n").map.at(5.5), want);
    }
    // three numbers with blanks between
    expect_color(cpt("5 10 20 30 7 30 60 90\n").map.at(6), bytes(20, 40, 60));
}

TEST(CptFile, FromZeroToOneOrMinusOneItIsToBeStretched)
{
    EXPECT_FALSE(cpt("0 black 1 white\n").states_range);
    EXPECT_FALSE(cpt("-1 black 0 red\n0 blue 1 white\n").states_range);
    EXPECT_TRUE(cpt("0 black 2 white\n").states_range);
    EXPECT_TRUE(cpt("-1 black 0 white\n").states_range);
}

TEST(CptFile, AHardHingeIsKeptForTheStretching)
{
    const std::string halves = "-1 black 0 red\n0 blue 1 white\n";
    EXPECT_FALSE(cpt(halves).hinge);
    EXPECT_FALSE(cpt("# SOFT_HINGE\n" + halves).hinge);
    EXPECT_EQ(cpt("# HARD_HINGE\n" + halves).hinge->to, 0.0);
    EXPECT_EQ(cpt("# HINGE = 12.5\n" + halves).hinge->to, 12.5);
    EXPECT_EQ(cpt("# HINGE = 12.5\n" + halves).hinge->at, 0.0);
    EXPECT_FALSE(cpt("# HARD_HINGE\n0 black 1 white\n").hinge); // no halves
    const auto in_meters = cpt("# HARD_HINGE\n-9 black 0 red\n0 blue 5 white\n").hinge;
    EXPECT_EQ(in_meters->at, 0.0);
    EXPECT_EQ(in_meters->to, 0.0);
    EXPECT_FALSE(cpt("# HARD_HINGE\n2 black 3 red\n3 blue 5 white\n").hinge); // all above it
}

TEST(CptFile, ARangeStretchesRightAway)
{
    const ColorMapFile plain = cpt("# RANGE = -50/150\n0 black 1 white\n");
    EXPECT_TRUE(plain.states_range);
    EXPECT_EQ(plain.map.first(), -50);
    expect_color(plain.map.at(50), bytes(127.5, 127.5, 127.5));

    for (const char* hinge : {"# HARD_HINGE\n", "# SOFT_HINGE\n", "# HINGE = 0\n"}) {
        SCOPED_TRACE(hinge);
        const ColorMapFile file = cpt(std::string(hinge) + "# RANGE = -8000/2000\n"
                                                           "-1 0/0/0 0 0/0/200\n"
                                                           "0 0/100/0 1 0/200/0\n");
        EXPECT_TRUE(file.states_range);
        // Stretched again, a hard one stays where it is.
        EXPECT_EQ(file.hinge.has_value(), std::string(hinge) != "# SOFT_HINGE\n");
        if (file.hinge) {
            const ColorMap narrow = file.map.stretched(-100, 900, *file.hinge);
            expect_color(narrow.at(-50), bytes(0, 0, 100));
            expect_color(narrow.at(0), bytes(0, 100, 0));
            expect_color(narrow.at(450), bytes(0, 150, 0));
        }
        expect_color(file.map.at(-8000), {});
        expect_color(file.map.at(-4000), bytes(0, 0, 100));
        expect_color(file.map.at(0), bytes(0, 100, 0));
        expect_color(file.map.at(1000), bytes(0, 150, 0));
    }
}

TEST(CptFile, BelowAndAboveAreForMapsThatStateTheirRange)
{
    const std::string outside = "B 1/2/3\nF 255 0 255\nN -\n";
    const ColorMap map = cpt("0 black 10 white\n" + outside).map;
    expect_color(map.at(-1e-9), bytes(1, 2, 3));
    expect_color(map.at(0), {});
    expect_color(map.at(10 - 1e-12), {1, 1, 1});
    expect_color(map.at(10), {1, 1, 1}); // the end belongs to the map
    expect_color(map.at(10.1), bytes(255, 0, 255));
    const ColorMap stretched = cpt("0 black 1 white\n" + outside).map;
    expect_color(stretched.at(-1), {});
    expect_color(stretched.at(2), {1, 1, 1});
}

TEST(CptFile, CategoriesReachHalfwayToTheirNeighbours)
{
    const ColorMapFile file = cpt("1 red ;forest\n2 0/255/0 ;meadow\n4 blue ;water\n");
    EXPECT_TRUE(file.states_range);
    expect_color(file.map.at(-9), {1, 0, 0});
    expect_color(file.map.at(1.49), {1, 0, 0});
    expect_color(file.map.at(1.5), {0, 1, 0});
    expect_color(file.map.at(2.99), {0, 1, 0});
    expect_color(file.map.at(3), {0, 0, 1});
    expect_color(file.map.at(99), {0, 0, 1});
}

// Foley and van Dam's hexcone, sector by sector.
Rgb hexcone(double h, double s, double v)
{
    const int sector = static_cast<int>(std::floor(h / 60)) % 6;
    const double f = h / 60 - std::floor(h / 60);
    const double p = v * (1 - s), q = v * (1 - s * f), t = v * (1 - s * (1 - f));
    const Rgb of[6] = {{v, t, p}, {q, v, p}, {p, v, t}, {p, q, v}, {t, p, v}, {v, p, q}};
    return of[sector];
}

TEST(CptFile, HueSaturationAndValueAreTheHexcone)
{
    for (double h = 0; h < 360; h += 7)
        for (const double s : {0.0, 0.3, 1.0})
            for (const double v : {0.0, 0.4, 1.0}) {
                SCOPED_TRACE(h);
                expect_color(rgb_of_hsv({h, s, v}), hexcone(h, s, v), 1e-14);
                expect_color(rgb_of_hsv({h + 360, s, v}), hexcone(h, s, v), 1e-14);
                const Rgb back = hsv_of_rgb(hexcone(h, s, v));
                expect_color(rgb_of_hsv(back), hexcone(h, s, v), 1e-14);
                if (s > 0 && v > 0)
                    expect_color(back, {h, s, v}, 1e-12);
            }
}

TEST(CptFile, OfTheModelHsvPiecesAreStraightInIt)
{
    for (const char* model :
         {"# COLOR_MODEL = HSV\n", "#COLOR_MODEL=hsv\n", "# COLOR_MODEL = +HSV\n"})
        for (const char* piece : {"0 300-1-0.9 10 20-0.2-0.4\n", "0 300 1 0.9 10 20 0.2 0.4\n",
                                  "0 300/1/0.9 10 20/0.2/0.4\n"}) {
            const ColorMap map = cpt(std::string(model) + piece).map;
            for (double x = 0; x <= 10; x += 0.0173) {
                const double t = x / 10;
                SCOPED_TRACE(x);
                expect_color(map.at(x), hexcone(300 - 280 * t, 1 - 0.8 * t, 0.9 - 0.5 * t), 1e-5);
            }
        }
    // the same colors in a file of the model RGB: straight in RGB
    expect_color(cpt("0 300-1-0.9 10 20-0.2-0.4\n").map.at(5),
                 {(0.9 + 0.4) / 2, (0.32 + 0.4 * (1 - 0.2 * 2 / 3)) / 2 - 0.16, (0.9 + 0.32) / 2},
                 1e-12);
    // names and #rrggbb go by way of hue
    expect_color(cpt("# COLOR_MODEL = HSV\n0 red 10 #00ff00\n").map.at(5), {1, 1, 0}, 1e-5);
}

TEST(CptFile, WhatCannotBeUsedIsNamedWithItsLine)
{
    expect_parts(cpt_error("0 black 1 white\n1 white 2 blurple\n"),
                 {": line 2: ", "blurple", "name"});
    expect_parts(cpt_error("0 black 1 white\n2 red 3 blue\n"), {": line 2: ", "follow"});
    expect_parts(cpt_error("0 black 1 white\n0.5 red 3 blue\n"), {": line 2: ", "follow"});
    expect_parts(cpt_error("# x\n3 black 1 white\n"), {": line 2: ", "rise"});
    expect_parts(cpt_error("1 black 1 white\n"), {": line 1: ", "rise"});
    expect_parts(cpt_error("0 black 1 nan\n"), {": line 1: ", "nan"});
    expect_parts(cpt_error("nan black 1 white\n"), {": line 1: ", "'nan' is not a number"});
    expect_parts(cpt_error("0 black inf white\n"), {": line 1: ", "'inf' is not a number"});
    expect_parts(cpt_error("0 black 1e999 white\n"), {": line 1: ", "number"});
    expect_parts(cpt_error("0 256/0/0 1 white\n"), {": line 1: ", "256/0/0", "255"});
    expect_parts(cpt_error("0 -1/0/0 1 white\n"), {": line 1: ", "-1/0/0"});
    expect_parts(cpt_error("0 1/2 1 white\n"), {": line 1: ", "1/2"});
    expect_parts(cpt_error("0 10/20/30/40 1 white\n"), {": line 1: ", "10/20/30/40"});
    expect_parts(cpt_error("0 #12345 1 white\n"), {": line 1: ", "#12345"});
    expect_parts(cpt_error("0 #12345g 1 white\n"), {": line 1: ", "#12345g"});
    expect_parts(cpt_error("0 400-1-1 1 white\n"), {": line 1: ", "400-1-1"});
    expect_parts(cpt_error("0 - 1 white\n"), {": line 1: ", "'-' is not a color"});
    expect_parts(cpt_error("0 p200/7 1 white\n"), {": line 1: ", "p200/7"});
    expect_parts(cpt_error("0 black 1\n"), {": line 1: ", "expected z0 color z1 color"});
    expect_parts(cpt_error("# COLOR_MODEL = CMYK\n0 1/2/3/4 1 white\n"), {": line 1: ", "CMYK"});
    expect_parts(cpt_error("# CYCLIC\n0 black 1 white\n"), {": line 1: ", "cyclic"});
    expect_parts(cpt_error("# RANGE = 5\n0 black 1 white\n"), {": line 1: ", "low/high"});
    expect_parts(cpt_error("# RANGE = 5/5\n0 black 1 white\n"), {": line 1: ", "low/high"});
    expect_parts(cpt_error("B\n0 black 1 white\n"), {": line 1: ", "color"});
    expect_parts(cpt_error("1 red ;a\n1 blue ;b\n"), {": line 2: ", "rise"});
    expect_parts(cpt_error("1 red ;a\n2 blue 3 blue\n"), {": line 2: ", "one kind"});
    expect_parts(cpt_error("oak red ;a\n"), {": line 1: ", "'oak' is not a number"});
}

TEST(CptFile, WhatIsNoTableIsSaidToBeNone)
{
    expect_parts(cpt_error(""), {"empty"});
    expect_parts(cpt_error("# only comments\n\n"), {"ends without a color"});
    expect_parts(cpt_error(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
                 {": line 1: ", "not plain text"});
    expect_parts(cpt_error(std::string("0 1\0 1 2\n", 9)), {": line 1: ", "not text"});
    expect_parts(cpt_error(std::string(100000, '7')), {": line 1: "});
    EXPECT_LT(cpt_error(std::string(100000, 'x')).size(), 300U); // not the whole line
    std::string endless;
    for (int i = 0; i < 1000000; ++i)
        endless += std::to_string(i) + " 1 " + std::to_string(i + 1) + " 2\n";
    expect_parts(cpt_error(endless), {": line 65537: ", "more than 65536"});
}

} // namespace
} // namespace scree::test
