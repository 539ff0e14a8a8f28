#include "chart/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "chart/footprints.h"
#include "chart/report.h"
#include "math/error.h"

namespace scree {
namespace {

ChartOptions quick()
{
    ChartOptions options;
    options.footprints = 6;
    options.grid = 48;
    options.rounds = 1;
    return options;
}

const AssetChart& small_chart()
{
    static const AssetChart chart = make_chart(sample_asset("bricks", 64), quick());
    return chart;
}

std::vector<ChartRow> rows_of(MethodFamily family)
{
    std::vector<ChartRow> rows;
    for (const ChartRow& row : small_chart().rows)
        if (row.family == family)
            rows.push_back(row);
    return rows;
}

// The error of independent samples goes as n^(-1/2), that of stratified ones falls faster: 64 times
// as many leave an eighth at most. Neither of one sample, which sees nothing in many a grazing view
// and can be no more wrong than that, nor of so many that the truth's own noise shows.
TEST(MethodChart, SupersamplingConverges)
{
    const auto rows = rows_of(MethodFamily::supersampling);
    ASSERT_EQ(rows.size(), 6U);
    for (size_t band = 0; band < small_chart().bands.size(); ++band)
        for (const ErrorKind kind : {ErrorKind::radiance, ErrorKind::color}) {
            const auto error = [&](size_t i) { return error_of(rows[i].errors[band], kind); };
            for (size_t i = 0; i + 1 < rows.size(); ++i)
                EXPECT_LT(error(i + 1), error(i)) << "band " << band << ", " << rows[i].name;
            EXPECT_LT(error(4), error(1) / 8) << band;
            const double noise = error_of(small_chart().noise[band], kind);
            EXPECT_GT(noise, 0) << band;
            EXPECT_LT(noise, error(5)) << band; // of 2304 samples, against 1024
        }
}

// What models were made for must show: with all of it a footprint is nearer to the truth than a
// plain MIP chain, and from above where nothing hides everything knows the mean color.
TEST(MethodChart, ModelsBeatThePlainChain)
{
    const auto row = [](const std::string& name) {
        const auto& rows = small_chart().rows;
        return *std::find_if(rows.begin(), rows.end(),
                             [&name](const ChartRow& r) { return r.name == name; });
    };
    const ChartRow naive = row("naive MIP"), rank = row("rank 4 + slope");
    for (size_t band = 0; band < small_chart().bands.size(); ++band) {
        EXPECT_LT(rank.errors[band].radiance, naive.errors[band].radiance) << band;
        EXPECT_LT(rank.errors[band].color, naive.errors[band].color) << band;
    }
    // What was measured, too; from above, where nothing hides, to a share of an error that is
    // small.
    for (const char* name : {"linear, corrected", "visibility 4x1", "visibility 4x3",
                             "visibility 4x5", "visibility 4 axes"})
        for (size_t band = 0; band < small_chart().bands.size(); ++band) {
            const double share = band < 2 ? 1.1 : 1;
            EXPECT_LT(row(name).errors[band].color, share * naive.errors[band].color)
                << name << ", band " << band;
        }
    EXPECT_LT(row("visibility 4x5").errors[3].color, naive.errors[3].color / 3);
    EXPECT_LT(row("visibility 4x5").errors[3].color, row("visibility 4x1").errors[3].color);
    EXPECT_LT(row("visibility 4 axes").errors[3].color, row("visibility 4x5").errors[3].color)
        << "of bricks";
    EXPECT_LT(naive.errors[0].color, 0.1);
    EXPECT_GT(naive.errors[3].color, 0.1);
}

TEST(MethodChart, ErrorsDoNotDependOnThreads)
{
    ChartOptions options = quick();
    options.footprints = 2;
    options.grid = 4;
    const Asset asset = sample_asset("fractal", 32);
    options.threads = 1;
    const AssetChart one = make_chart(asset, options);
    options.threads = 3;
    const AssetChart three = make_chart(asset, options);
    ASSERT_EQ(one.rows.size(), three.rows.size());
    EXPECT_EQ(one.rays, three.rays);
    for (size_t i = 0; i < one.rows.size(); ++i)
        for (size_t band = 0; band < one.bands.size(); ++band) {
            EXPECT_EQ(one.rows[i].errors[band].color, three.rows[i].errors[band].color);
            EXPECT_EQ(one.rows[i].errors[band].radiance, three.rows[i].errors[band].radiance);
        }
}

TEST(MethodChart, CostsAreMeasured)
{
    for (const ChartRow& row : small_chart().rows) {
        EXPECT_GT(row.cost.least_ns, 0) << row.name;
        EXPECT_LE(row.cost.least_ns, row.cost.lower_ns) << row.name;
        EXPECT_LE(row.cost.lower_ns, row.cost.median_ns) << row.name;
        EXPECT_LE(row.cost.median_ns, row.cost.upper_ns) << row.name;
        EXPECT_LE(row.cost.upper_ns, row.cost.most_ns) << row.name;
        EXPECT_EQ(std::isnan(row.bytes), row.samples > 0) << row.name;
    }
}

TEST(MethodChart, BytesAreThoseOfTheChannelsRead)
{
    std::map<MethodTexture, PixelType> types;
    for (const auto texture :
         {MethodTexture::normal, MethodTexture::slope, MethodTexture::sobel, MethodTexture::tail,
          MethodTexture::height, MethodTexture::color, MethodTexture::colorheight,
          MethodTexture::colorslope, MethodTexture::rank, MethodTexture::visible_2x1,
          MethodTexture::visible_4x1, MethodTexture::visible_4x3, MethodTexture::visible_4x5,
          MethodTexture::visible_axes})
        types[texture] = PixelType::half;
    types[MethodTexture::slope] = types[MethodTexture::visible_axes] = PixelType::float32;
    const auto bytes = [&types](const std::string& name) {
        for (const Method& method : methods())
            if (method.name == name)
                return bytes_per_texel(method, types);
        return -1;
    };
    EXPECT_EQ(bytes("naive MIP"), 3 * 2 + 3 * 2);
    EXPECT_EQ(bytes("maketx"), 3 * 2 + 5 * 2);
    EXPECT_EQ(bytes("LEADR"), 3 * 2 + 5 * 4);
    EXPECT_EQ(bytes("linear"), 3 * 2 + 5 * 4 + 2 * 2 + 3 * 2);
    EXPECT_EQ(bytes("rank 8"), 3 * 2 + 5 * 4 + 24 * 2);
    EXPECT_EQ(bytes("linear, corrected"), bytes("linear"));
    EXPECT_EQ(bytes("visibility 2x1"), 3 * 2 + 5 * 4 + 4 * 2 * 2);
    EXPECT_EQ(bytes("visibility 4x1"), 3 * 2 + 5 * 4 + 4 * 4 * 2);
    EXPECT_EQ(bytes("visibility 4x3"), 3 * 2 + 5 * 4 + 4 * 4 * 3 * 2);
    EXPECT_EQ(bytes("visibility 4x5"), 3 * 2 + 5 * 4 + 4 * 4 * 5 * 2);
    EXPECT_EQ(bytes("visibility 4 axes"), 3 * 2 + 5 * 4 + 4 * 4 * 5 * 4);
}

TEST(MethodChart, RefusesWhatMakesNoSense)
{
    ChartOptions options = quick();
    options.grid = 1;
    EXPECT_THROW(make_chart(sample_asset("plane", 8), options), Error);
    options = quick();
    options.material.base_alpha = 0;
    EXPECT_THROW(make_chart(sample_asset("plane", 8), options), Error);
    EXPECT_THROW(make_chart(sample_asset("plane", 3), quick()), Error);
}

TEST(MethodChart, StopsWhenAsked)
{
    const std::atomic<bool> stop{true};
    BakeMonitor monitor;
    monitor.cancel = &stop;
    EXPECT_THROW(make_chart(sample_asset("plane", 8), quick(), monitor), Cancelled);
}

/// Fields of a line of RFC 4180 without line breaks inside fields.
std::vector<std::string> fields_of(const std::string& line)
{
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            fields.emplace_back();
        else if (c != '\r')
            fields.back() += c;
    }
    return fields;
}

TEST(MethodChart, NumbersAreATableThatParses)
{
    const AssetChart& chart = small_chart();
    std::istringstream csv(to_csv(chart_numbers({chart}, quick())));
    std::string line;
    ASSERT_TRUE(std::getline(csv, line));
    const auto headings = fields_of(line);
    const auto column = [&headings](const std::string& name) {
        const auto found = std::find(headings.begin(), headings.end(), name);
        EXPECT_NE(found, headings.end()) << name;
        return static_cast<size_t>(found - headings.begin());
    };
    size_t lines = 0, on_front = 0;
    for (; std::getline(csv, line); ++lines) {
        const auto fields = fields_of(line);
        ASSERT_EQ(fields.size(), headings.size()) << line;
        const size_t band = lines / chart.rows.size();
        const ChartRow& row = chart.rows[lines % chart.rows.size()];
        EXPECT_EQ(fields[column("asset")], "bricks");
        EXPECT_EQ(fields[column("band_deg")], chart.bands[band].name());
        EXPECT_EQ(fields[column("method")], row.name);
        const auto number = [&](const char* name) { return std::stod(fields[column(name)]); };
        EXPECT_NEAR(number("error_color") / row.errors[band].color, 1, 1e-5);
        EXPECT_NEAR(number("error_radiance") / row.errors[band].radiance, 1, 1e-5);
        EXPECT_NEAR(number("noise_color") / chart.noise[band].color, 1, 1e-5);
        EXPECT_NEAR(number("ns_median") / row.cost.median_ns, 1, 1e-5);
        EXPECT_EQ(fields[column("bytes_per_texel")].empty(), row.samples > 0);
        on_front += fields[column("pareto_radiance_time")] == "1" ? 1 : 0;
    }
    EXPECT_EQ(lines, chart.rows.size() * chart.bands.size());
    EXPECT_GE(on_front, chart.bands.size()); // the most accurate is always on it
}

TEST(MethodChart, EveryBandHasItsCharts)
{
    const auto charts = error_charts(small_chart());
    EXPECT_EQ(charts.size(), 4 * small_chart().bands.size());
    std::set<std::string> names;
    for (const NamedChart& named : charts) {
        names.insert(named.name);
        size_t points = 0, marked = 0;
        for (const report::Series& series : named.chart.series)
            for (const report::ChartPoint& point : series.points) {
                ++points;
                marked += point.is_marked ? 1 : 0;
            }
        const bool over_time = named.name.find("time") != std::string::npos;
        EXPECT_EQ(points, methods().size() + (over_time ? 6 : 0)) << named.name;
        EXPECT_GT(marked, 0U) << named.name;
    }
    EXPECT_EQ(names.size(), charts.size());
    EXPECT_EQ(names.count("bricks-75-85-radiance-time"), 1U);
}

TEST(MethodChart, ThePageTellsEveryMethodAndHowItWasMeasured)
{
    AssetChart chart = small_chart();
    EXPECT_EQ(chart.visibility.node_angles_deg.size(), 4U);
    EXPECT_EQ(chart.visibility_axes.node_angles_deg.size(), 4U);
    EXPECT_NEAR(chart.visibility_axes.axis_deg.value(), 0, 1) << "bricks lie along the map";
    chart.visibility.node_angles_deg = {51, 62.125, 73, 84};
    chart.visibility_axes.node_angles_deg = {49, 62, 73, 85};
    chart.visibility_axes.axis_deg = -12.5;
    const std::string page = chart_page({chart}, quick()).to_html();
    EXPECT_NE(
        page.find("of bricks: at 51, 62.125, 73, 84 degrees from the normal; along axes at 49, "
                  "62, 73, 85, the first axis -12.5 degrees from +s"),
        std::string::npos);
    for (const Method& method : methods())
        EXPECT_NE(page.find(method.name + ": "), std::string::npos) << method.name;
    EXPECT_NE(page.find("48 x 48 jittered samples"), std::string::npos);
    EXPECT_NE(page.find("noise of the truth"), std::string::npos);
}

} // namespace
} // namespace scree
