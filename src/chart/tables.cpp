#include <fmt/format.h>

#include <array>
#include <cmath>

#include "chart/report.h"
#include "version.h"

namespace scree {

namespace {

constexpr std::array<ErrorKind, 2> kErrors = {ErrorKind::radiance, ErrorKind::color};
constexpr std::array<CostAxis, 2> kCosts = {CostAxis::time, CostAxis::bytes};

/// Nothing where there is no number.
std::string number(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

std::vector<std::string> headings()
{
    std::vector<std::string> words = {"asset", "band_deg", "method", "samples"};
    for (const char* figure : {"error", "noise"})
        for (const ErrorKind kind : kErrors)
            words.push_back(fmt::format("{}_{}", figure, name_of(kind)));
    for (const char* word : {"ns_median", "ns_least", "ns_lower_quartile", "ns_upper_quartile",
                             "ns_most", "bytes_per_texel"})
        words.emplace_back(word);
    for (const ErrorKind kind : kErrors)
        for (const CostAxis axis : kCosts)
            words.push_back(fmt::format("pareto_{}_{}", name_of(kind), name_of(axis)));
    for (const char* word : {"options", "timing_threads", "compiler", "version", "commit"})
        words.emplace_back(word);
    return words;
}

std::string options_of(const AssetChart& chart, const ChartOptions& options)
{
    return fmt::format("size={}x{} footprints={} samples={} seed={} base-alpha={:g} f0={:g}",
                       chart.width, chart.height, chart.footprints, options.grid * options.grid,
                       options.seed, options.material.base_alpha, options.material.f0);
}

std::vector<std::string> line_of(const AssetChart& chart, size_t band, const ChartRow& row)
{
    std::vector<std::string> words = {chart.asset, chart.bands[band].name(), row.name,
                                      row.samples > 0 ? fmt::format("{}", row.samples) : ""};
    for (const RelativeErrors& figures : {row.errors[band], chart.noise[band]})
        for (const ErrorKind kind : kErrors)
            words.push_back(number(error_of(figures, kind)));
    for (const double cost : {row.cost.median_ns, row.cost.least_ns, row.cost.lower_ns,
                              row.cost.upper_ns, row.cost.most_ns, row.bytes})
        words.push_back(number(cost));
    return words;
}

void add_band(const AssetChart& chart, size_t band, const ChartOptions& options,
              report::Table& table)
{
    std::vector<std::vector<bool>> fronts;
    for (const ErrorKind kind : kErrors)
        for (const CostAxis axis : kCosts)
            fronts.push_back(front_of(chart, band, axis, kind));
    for (size_t i = 0; i < chart.rows.size(); ++i) {
        std::vector<std::string> line = line_of(chart, band, chart.rows[i]);
        for (const auto& front : fronts)
            line.emplace_back(front[i] ? "1" : "0");
        line.push_back(options_of(chart, options));
        for (const char* word : {"1", kCompiler, kVersion, kCommit})
            line.emplace_back(word);
        table.rows.push_back(std::move(line));
    }
}

} // namespace

report::Table chart_numbers(const std::vector<AssetChart>& charts, const ChartOptions& options)
{
    report::Table table;
    table.headings = headings();
    for (const AssetChart& chart : charts)
        for (size_t band = 0; band < chart.bands.size(); ++band)
            add_band(chart, band, options, table);
    return table;
}

report::Table chart_table(const AssetChart& chart)
{
    report::Table table;
    table.title = fmt::format("{}: rms errors, relative, by degrees from the normal", chart.asset);
    table.headings = {"method", "ns", "bytes"};
    for (const ErrorKind kind : kErrors)
        for (const ViewBand& band : chart.bands)
            table.headings.push_back(fmt::format("{} {}", name_of(kind), band.name()));
    const auto add = [&](std::vector<std::string> row, const std::vector<RelativeErrors>& bands) {
        for (const ErrorKind kind : kErrors)
            for (const RelativeErrors& band : bands)
                row.push_back(fmt::format("{:.4f}", error_of(band, kind)));
        table.rows.push_back(std::move(row));
    };
    for (const ChartRow& row : chart.rows)
        add({row.name, fmt::format("{:.0f}", row.cost.median_ns), number(row.bytes)}, row.errors);
    add({"noise of the truth", "", ""}, chart.noise);
    return table;
}

} // namespace scree
