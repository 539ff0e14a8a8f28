#include <fmt/format.h>

#include <cmath>

#include "chart/report.h"

namespace scree {

namespace {

std::string legend_of(MethodFamily family)
{
    switch (family) {
    case MethodFamily::plain:
        return "no masking of colors";
    case MethodFamily::masked:
        return "masking";
    case MethodFamily::correlated:
        return "masking, correlated color";
    case MethodFamily::measured:
        return "masking, measured color";
    case MethodFamily::supersampling:
        break;
    }
    return "supersampling";
}

report::ChartPoint point_of(const ChartRow& row, size_t band, ErrorKind kind, CostAxis axis)
{
    report::ChartPoint point;
    point.x = cost_of(row, axis);
    point.y = error_of(row.errors[band], kind);
    point.label = row.name;
    if (axis == CostAxis::time) {
        point.spread_low = row.cost.lower_ns;
        point.spread_high = row.cost.upper_ns;
    }
    return point;
}

report::Chart error_chart(const AssetChart& of, size_t band, ErrorKind kind, CostAxis axis)
{
    report::Chart chart;
    chart.title = fmt::format("{}: {}, {} degrees from the normal", of.asset,
                              kind == ErrorKind::radiance ? "radiance" : "visible color",
                              of.bands[band].name());
    chart.x = axis == CostAxis::time ? report::Axis{"nanoseconds per footprint", true}
                                     : report::Axis{"bytes per texel", false};
    chart.y = {"rms error, relative", true};
    const std::vector<bool> front = front_of(of, band, axis, kind);
    for (const MethodFamily family :
         {MethodFamily::plain, MethodFamily::masked, MethodFamily::correlated,
          MethodFamily::measured, MethodFamily::supersampling}) {
        report::Series series{legend_of(family), {}, family == MethodFamily::supersampling};
        for (size_t i = 0; i < of.rows.size(); ++i) {
            if (of.rows[i].family != family || std::isnan(cost_of(of.rows[i], axis)))
                continue;
            series.points.push_back(point_of(of.rows[i], band, kind, axis));
            series.points.back().is_marked = front[i];
        }
        if (!series.points.empty())
            chart.series.push_back(std::move(series));
    }
    return chart;
}

} // namespace

std::string name_of(ErrorKind kind) { return kind == ErrorKind::radiance ? "radiance" : "color"; }
std::string name_of(CostAxis axis) { return axis == CostAxis::time ? "time" : "bytes"; }

std::vector<NamedChart> error_charts(const AssetChart& chart)
{
    std::vector<NamedChart> all;
    for (size_t band = 0; band < chart.bands.size(); ++band)
        for (const ErrorKind kind : {ErrorKind::radiance, ErrorKind::color})
            for (const CostAxis axis : {CostAxis::time, CostAxis::bytes})
                all.push_back({fmt::format("{}-{}-{}-{}", chart.asset, chart.bands[band].name(),
                                           name_of(kind), name_of(axis)),
                               error_chart(chart, band, kind, axis)});
    return all;
}

} // namespace scree
