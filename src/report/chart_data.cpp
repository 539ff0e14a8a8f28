#include "report/chart_data.h"

#include <fmt/format.h>

#include <cmath>

namespace scree::report {

bool is_shown(const ChartPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool has_spread(const ChartPoint& p)
{
    return std::isfinite(p.spread_low) && std::isfinite(p.spread_high) &&
           p.spread_low < p.spread_high;
}

std::vector<double> shown_x(const Chart& chart)
{
    std::vector<double> values;
    for (const auto& series : chart.series)
        for (const auto& p : series.points) {
            if (!is_shown(p))
                continue;
            values.push_back(p.x);
            if (has_spread(p))
                values.insert(values.end(), {p.spread_low, p.spread_high});
        }
    return values;
}

std::vector<double> shown_y(const Chart& chart)
{
    std::vector<double> values;
    for (const auto& series : chart.series)
        for (const auto& p : series.points)
            if (is_shown(p))
                values.push_back(p.y);
    return values;
}

/// On what a chart cannot show, or shows in a place that is not its own.
std::vector<std::string> remarks_on(const Chart& chart)
{
    int missing = 0, at_edge = 0;
    for (const auto& series : chart.series)
        for (const auto& p : series.points) {
            if (!is_shown(p))
                ++missing;
            else if ((chart.x.logarithmic && p.x <= 0) || (chart.y.logarithmic && p.y <= 0))
                ++at_edge;
        }
    std::vector<std::string> remarks;
    if (missing > 0)
        remarks.push_back(
            fmt::format("Left out: {} without a finite value.", counted(missing, "point")));
    if (at_edge > 0)
        remarks.push_back(fmt::format("At the edge: {} of 0 or less, which a logarithmic axis has "
                                      "no place for.",
                                      counted(at_edge, "point")));
    return remarks;
}

std::string counted(int count, const char* noun)
{
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

} // namespace scree::report
