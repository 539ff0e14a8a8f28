#include "report/legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/font.h"
#include "report/marker.h"

namespace scree::report {

namespace {

constexpr double kRow = 20, kSampleWidth = 26, kWordsAt = 33, kGap = 16;

} // namespace

bool is_crowded(const Series& series, double width)
{
    constexpr double kCloseness = 3 * kMarkerRadius;
    return series.is_line && static_cast<double>(series.points.size()) * kCloseness > width;
}

Legend::Legend(const Chart& chart, double width) : chart_(chart), width_(width)
{
    for (size_t i = 0; i < chart.series.size(); ++i) {
        const std::string& name = chart.series[i].name;
        if (name.empty())
            continue;
        entries_.push_back(i);
        column_ = std::max(column_, kWordsAt + text_width(name, kFontSize) + kGap);
    }
    if (entries_.empty())
        return;
    const size_t most = std::max<size_t>(1, static_cast<size_t>(width / column_));
    // Rows of even length rather than a last row of one.
    const size_t rows = (entries_.size() + most - 1) / most;
    per_row_ = (entries_.size() + rows - 1) / rows;
}

double Legend::height() const
{
    const size_t rows = (entries_.size() + per_row_ - 1) / per_row_;
    return static_cast<double>(rows) * kRow;
}

std::string Legend::draw(const Spot& corner) const
{
    std::string svg;
    for (size_t i = 0; i < entries_.size(); ++i) {
        const size_t row = i / per_row_, column = i % per_row_;
        svg += entry(entries_[i], {corner.x + static_cast<double>(column) * column_,
                                   corner.y + (static_cast<double>(row) + 0.5) * kRow});
    }
    return svg;
}

std::string Legend::entry(size_t series, const Spot& left) const
{
    constexpr double kBelowMiddle = 4; // of the base line
    const Series& of = chart_.series[series];
    const Look look = look_of(static_cast<int>(series));
    const bool crowded = is_crowded(of, width_);
    const bool all_marked = std::all_of(of.points.begin(), of.points.end(),
                                        [](const ChartPoint& p) { return p.is_marked; });
    std::string svg;
    if (of.is_line)
        svg += svg_line(left, {left.x + kSampleWidth, left.y}, line_paint(look, crowded));
    if (!crowded)
        svg += marker(look, {left.x + kSampleWidth / 2, left.y}, all_marked) + "\n";
    return svg + svg_text({left.x + kWordsAt, left.y + kBelowMiddle}, of.name, "");
}

} // namespace scree::report
