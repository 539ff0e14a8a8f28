// A chart read back from its SVG: what stands where.

#include "report/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "report/marker.h"
#include "support/markup.h"

namespace scree::report {
namespace {

using test::Element;
using test::elements_named;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double number(const Element& element, const std::string& key)
{
    return std::stod(element.attributes.at(key));
}

/// Place of the text elements that say `words`.
double place_of(const std::vector<Element>& svg, const std::string& words, const std::string& key)
{
    for (const auto& element : elements_named(svg, "text"))
        if (element.text == words)
            return number(element, key);
    ADD_FAILURE() << "no text " << words;
    return 0;
}

bool says(const std::vector<Element>& svg, const std::string& part)
{
    for (const auto& element : elements_named(svg, "text"))
        if (element.text.find(part) != std::string::npos)
            return true;
    return false;
}

/// One series of circles (the first look) without a name, so without a legend.
Chart circles(const std::vector<ChartPoint>& points, bool logarithmic)
{
    Chart chart;
    chart.x = {"time, ns", logarithmic};
    chart.y = {"error", logarithmic};
    chart.series = {{"", points, false}};
    return chart;
}

TEST(Chart, PointsStandAtTheirNumbersOnTheAxes)
{
    for (const bool logarithmic : {false, true}) {
        const auto svg = test::parse_markup(to_svg(circles(
            {{1, 100, "", false, 0, 0}, {10, 10, "", false, 0, 0}, {100, 1, "", true, 0, 0}},
            logarithmic)));
        const auto dots = elements_named(svg, "circle");
        ASSERT_EQ(dots.size(), 3U);
        // Marked points are drawn last. Half a hundredth of a pixel from rounding, twice.
        const std::string high = "100";
        EXPECT_NEAR(number(dots[2], "cx"), place_of(svg, high, "x"), 0.01);
        double top = 0; // the number 100 stands on both axes: x last on the right, y at the top
        for (const auto& element : elements_named(svg, "text"))
            if (element.text == high && element.attributes.at("text-anchor") == "end")
                top = number(element, "y");
        EXPECT_NEAR(number(dots[0], "cy"), top - 4, 0.01);
        if (logarithmic) {
            EXPECT_NEAR(number(dots[1], "cx") * 2, number(dots[0], "cx") + number(dots[2], "cx"),
                        0.03);
        }
        EXPECT_LT(number(dots[0], "cx"), number(dots[1], "cx"));
        EXPECT_LT(number(dots[0], "cy"), number(dots[1], "cy"));
    }
}

TEST(Chart, MarkedPointsAreFullAndOthersHollow)
{
    const auto svg = test::parse_markup(
        to_svg(circles({{1, 1, "", true, 0, 0}, {2, 2, "", false, 0, 0}}, false)));
    const auto dots = elements_named(svg, "circle");
    EXPECT_EQ(dots.at(0).attributes.at("fill"), "#ffffff");
    EXPECT_EQ(dots.at(1).attributes.at("fill"), dots.at(1).attributes.at("stroke"));
}

TEST(Chart, EveryPointTellsItsNameAndNumbers)
{
    Chart chart = circles({{12.5, 0.25, "K = 2", false, 0, 0}}, true);
    chart.series[0].name = "rank & <tables>";
    const auto titles = elements_named(test::parse_markup(to_svg(chart)), "title");
    EXPECT_EQ(titles.at(0).text, "rank & <tables>, K = 2\ntime, ns: 12.5\nerror: 0.25");
}

TEST(Chart, PointsThatAreNoNumbersAreLeftOutAndCounted)
{
    const auto svg = test::parse_markup(to_svg(circles({{1, 1, "", false, 0, 0},
                                                        {kNan, 1, "lost", false, 0, 0},
                                                        {2, kInfinity, "", false, 0, 0},
                                                        {3, 3, "", false, kNan, 4}},
                                                       false)));
    EXPECT_EQ(elements_named(svg, "circle").size(), 2U);
    EXPECT_TRUE(says(svg, "2 points without a finite value"));
    EXPECT_FALSE(says(svg, "lost"));
}

TEST(Chart, ZeroOnALogarithmicAxisStandsAtTheEdgeAndIsCounted)
{
    const auto svg = test::parse_markup(
        to_svg(circles({{1, 1, "", false, 0, 0}, {10, 0, "", false, 0, 0}}, true)));
    const auto dots = elements_named(svg, "circle");
    const auto frame = elements_named(svg, "rect").at(1);
    EXPECT_NEAR(number(dots.at(1), "cy"), number(frame, "y") + number(frame, "height"), 0.01);
    EXPECT_TRUE(says(svg, "1 point of 0 or less"));
}

TEST(Chart, LinesAreJoinedInTheirOrderAndBrokenWhereAPointIsMissing)
{
    Chart chart = circles({}, false);
    chart.series = {{"line",
                     {{1, 1, "", false, 0, 0},
                      {3, 1, "", false, 0, 0},
                      {2, 2, "", false, 0, 0},
                      {kNan, 1, "", false, 0, 0},
                      {0, 4, "", false, 0, 0},
                      {4, 4, "", false, 0, 0}},
                     true}};
    const std::string path =
        elements_named(test::parse_markup(to_svg(chart)), "path").at(0).attributes.at("d");
    std::string moves;
    for (const char c : path)
        if (c == 'M' || c == 'L')
            moves += c;
    EXPECT_EQ(moves, "MLLML");
}

TEST(Chart, ASpreadReachesFromItsLowToItsHigh)
{
    const auto svg = test::parse_markup(to_svg(circles(
        {{10, 1, "", false, 1, 100}, {1, 2, "", false, 0, 0}, {100, 3, "", false, 0, 0}}, true)));
    const auto dots = elements_named(svg, "circle");
    bool found = false;
    for (const auto& bar : elements_named(svg, "line"))
        found = found || (std::abs(number(bar, "x1") - number(dots.at(1), "cx")) < 0.011 &&
                          std::abs(number(bar, "x2") - number(dots.at(2), "cx")) < 0.011 &&
                          std::abs(number(bar, "y1") - number(dots.at(0), "cy")) < 0.011);
    EXPECT_TRUE(found);
}

TEST(Chart, SeriesHaveNamesAndLooksOfTheirOwn)
{
    std::set<std::string> looks;
    for (int i = 0; i < 56; ++i) {
        const Look look = look_of(i);
        looks.insert(look.color + std::to_string(look.shape));
    }
    EXPECT_EQ(looks.size(), 56U);

    Chart chart = circles({}, false);
    chart.series.clear();
    for (int i = 0; i < 20; ++i)
        chart.series.push_back(
            {"method " + std::to_string(i), {{double(i), double(i), "", false, 0, 0}}, i % 3 == 0});
    const auto svg = test::parse_markup(to_svg(chart));
    for (int i = 0; i < 20; ++i)
        EXPECT_TRUE(says(svg, "method " + std::to_string(i)));
}

// What a reader's program would stumble over: numbers that are none, places outside the picture.
TEST(Chart, AnyNumbersAndWordsGiveASoundPicture)
{
    const std::vector<std::vector<ChartPoint>> cases = {
        {},
        {{0, 0, "", false, 0, 0}},
        {{1e308, -1e308, "a", false, -1e308, 1e308}, {-1e308, 1e308, "b", true, 0, 0}},
        {{5e-324, 1e-310, "<&>\"'\x01", false, 0, 0}},
        {{kNan, kNan, "", false, 0, 0}, {-kInfinity, 1, "", false, kInfinity, 0}},
        {{-1, -1, "both below", false, -2, 0}},
    };
    for (const auto& points : cases)
        for (const bool logarithmic : {false, true}) {
            Chart chart = circles(points, logarithmic);
            chart.title = "Title with <tags> & \"quotes\" that is " + std::string(300, 'x') +
                          " far too long for one line of a small picture";
            chart.series[0].name = "<name>";
            chart.series[0].is_line = true;
            const std::string text = to_svg(chart);
            const auto svg = test::parse_markup(text);
            EXPECT_EQ(svg.at(0).attributes.at("viewBox"), "0 0 760 480");
            for (const auto& element : svg)
                for (const char* key : {"x", "y", "x1", "x2", "y1", "y2", "cx", "cy"})
                    if (element.attributes.count(key) != 0) {
                        EXPECT_GE(number(element, key), 0) << key << " in " << text;
                        EXPECT_LE(number(element, key), 760) << key << " in " << text;
                    }
            EXPECT_EQ(text.find("script"), std::string::npos);
        }
}

TEST(Chart, ACrowdedLineHasNoMarkersButTellsItsNumbers)
{
    Chart chart = circles({}, false);
    Series& series = chart.series[0];
    series.is_line = true;
    for (int i = 0; i < 200; ++i)
        series.points.push_back({double(i), double(i % 7), "", i == 100, 0, 0});
    const auto svg = test::parse_markup(to_svg(chart));
    EXPECT_EQ(elements_named(svg, "title").size(), 200U);
    int drawn = 0;
    for (const auto& dot : elements_named(svg, "circle"))
        drawn += dot.attributes.count("stroke") != 0 ? 1 : 0;
    EXPECT_EQ(drawn, 1);
}

} // namespace
} // namespace scree::report
