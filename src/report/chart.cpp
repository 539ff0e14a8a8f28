#include "report/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/font.h"
#include "report/labels.h"
#include "report/marker.h"
#include "report/markup.h"
#include "report/numbers.h"
#include "report/scale.h"

namespace scree::report {

namespace {

constexpr double kFont = 12, kTitleFont = 15, kLabelFont = 11;
constexpr const char* kInk = "#1c1f23";
constexpr const char* kGrid = "#dfe3e7";
constexpr const char* kFaintGrid = "#f0f2f4";
constexpr const char* kFrame = "#8a939c";
constexpr const char* kQuietInk = "#5d666f";

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

std::string text(double x, double y, const std::string& words, const std::string& attributes)
{
    return fmt::format("<text x=\"{}\" y=\"{}\" {}>{}</text>\n", coordinate(x), coordinate(y),
                       attributes, escaped(words));
}

std::string line(const Spot& from, const Spot& to, const std::string& attributes)
{
    return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", coordinate(from.x),
                       coordinate(from.y), coordinate(to.x), coordinate(to.y), attributes);
}

/// Words under the plot on what it does not show.
std::string note_of(const Chart& chart)
{
    int missing = 0, at_edge = 0;
    for (const auto& series : chart.series)
        for (const auto& p : series.points) {
            if (!is_shown(p))
                ++missing;
            else if ((chart.x.logarithmic && p.x <= 0) || (chart.y.logarithmic && p.y <= 0))
                ++at_edge;
        }
    std::string note;
    if (missing > 0)
        note = fmt::format("Not shown: {} point{} without a finite value.", missing,
                           missing == 1 ? "" : "s");
    if (at_edge > 0)
        note += fmt::format("{}{} point{} at the edge: 0 or less, which a logarithmic axis has no "
                            "place for.",
                            note.empty() ? "" : " ", at_edge, at_edge == 1 ? "" : "s");
    return note;
}

/// Names of series in rows of columns of one width.
class Legend {
public:
    Legend(const Chart& chart, double width)
    {
        for (size_t i = 0; i < chart.series.size(); ++i)
            if (!chart.series[i].name.empty())
                entries_.push_back(i);
        for (const size_t i : entries_)
            column_ = std::max(column_, kWordsAt + text_width(chart.series[i].name, kFont) + 14);
        per_row_ = std::max<size_t>(1, static_cast<size_t>(width / std::max(column_, 1.0)));
        // Rows of even length rather than a last row of one.
        const size_t rows = (entries_.size() + per_row_ - 1) / per_row_;
        if (rows > 0)
            per_row_ = (entries_.size() + rows - 1) / rows;
    }

    [[nodiscard]] double height() const
    {
        return static_cast<double>((entries_.size() + per_row_ - 1) / per_row_) * kRow;
    }

    [[nodiscard]] std::string draw(const Chart& chart, double x, double y) const
    {
        std::string svg;
        for (size_t i = 0; i < entries_.size(); ++i) {
            const Series& series = chart.series[entries_[i]];
            const Look look = look_of(static_cast<int>(entries_[i]));
            const double left = x + static_cast<double>(i % per_row_) * column_;
            const double middle = y + (static_cast<double>(i / per_row_) + 0.5) * kRow;
            if (series.is_line)
                svg += line({left, middle}, {left + 24, middle},
                            fmt::format("stroke=\"{}\" stroke-width=\"1.6\"", look.color));
            svg += marker(look, left + 12, middle, false) + "\n";
            svg += text(left + kWordsAt, middle + 4, series.name, "");
        }
        return svg;
    }

private:
    static constexpr double kRow = 20, kWordsAt = 30;
    std::vector<size_t> entries_;
    double column_ = 0;
    size_t per_row_ = 1;
};

/// Draws within a frame that it first makes room for.
class Drawing {
public:
    explicit Drawing(const Chart& chart)
        : chart_(chart), x_(shown_x(chart), chart.x.logarithmic),
          y_(shown_y(chart), chart.y.logarithmic), note_(note_of(chart)),
          legend_(chart, chart.width - 32.0)
    {
        double widest = 0;
        for (const auto& tick : y_.ticks())
            widest = std::max(widest, text_width(tick.text, kFont));
        frame_.x0 = 36 + widest;
        frame_.x1 = chart.width - 20;
        frame_.y0 = chart.title.empty() ? 14 : 38;
        frame_.y1 = std::max(frame_.y0 + 40,
                             chart.height - 46 - legend_.height() - (note_.empty() ? 6 : 22));
    }

    std::string svg()
    {
        return head() + grid() + axes() + lines() + spreads() + points() + labels() +
               legend_.draw(chart_, 16, frame_.y1 + 46) + foot();
    }

private:
    [[nodiscard]] Spot spot(double x, double y) const
    {
        return {frame_.x0 + x_.place(x) * (frame_.x1 - frame_.x0),
                frame_.y1 - y_.place(y) * (frame_.y1 - frame_.y0)};
    }

    [[nodiscard]] std::string head() const
    {
        std::string svg = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
            "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\" font-family=\"Helvetica, "
            "Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\" font-size=\"{3}\" "
            "fill=\"{4}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
            chart_.width, chart_.height, escaped(chart_.title), kFont, kInk);
        if (!chart_.title.empty())
            svg += text(16, 24, chart_.title,
                        fmt::format("font-size=\"{}\" font-weight=\"600\"", kTitleFont));
        return svg;
    }

    [[nodiscard]] std::string grid() const
    {
        std::string faint, full;
        for (const auto& tick : x_.ticks()) {
            const double x = frame_.x0 + tick.place * (frame_.x1 - frame_.x0);
            (tick.text.empty() ? faint : full) += line({x, frame_.y0}, {x, frame_.y1}, "");
        }
        for (const auto& tick : y_.ticks()) {
            const double y = frame_.y1 - tick.place * (frame_.y1 - frame_.y0);
            (tick.text.empty() ? faint : full) += line({frame_.x0, y}, {frame_.x1, y}, "");
        }
        return fmt::format("<g stroke=\"{}\">\n{}</g>\n<g stroke=\"{}\">\n{}</g>\n", kFaintGrid,
                           faint, kGrid, full);
    }

    [[nodiscard]] std::string axes() const
    {
        std::string svg = fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
            "stroke=\"{}\"/>\n",
            coordinate(frame_.x0), coordinate(frame_.y0), coordinate(frame_.x1 - frame_.x0),
            coordinate(frame_.y1 - frame_.y0), kFrame);
        for (const auto& tick : x_.ticks())
            if (!tick.text.empty())
                svg += text(frame_.x0 + tick.place * (frame_.x1 - frame_.x0), frame_.y1 + 16,
                            tick.text, "text-anchor=\"middle\"");
        for (const auto& tick : y_.ticks())
            if (!tick.text.empty())
                svg += text(frame_.x0 - 7, frame_.y1 - tick.place * (frame_.y1 - frame_.y0) + 4,
                            tick.text, "text-anchor=\"end\"");
        svg += text((frame_.x0 + frame_.x1) / 2, frame_.y1 + 36, chart_.x.label,
                    "text-anchor=\"middle\"");
        const double middle = (frame_.y0 + frame_.y1) / 2;
        svg += text(18, middle, chart_.y.label,
                    fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {})\"",
                                coordinate(middle)));
        return svg;
    }

    std::string lines()
    {
        std::string svg;
        for (size_t i = 0; i < chart_.series.size(); ++i) {
            if (!chart_.series[i].is_line)
                continue;
            std::string path;
            const Spot* before = nullptr;
            Spot last;
            for (const auto& p : chart_.series[i].points) {
                if (!is_shown(p)) {
                    before = nullptr; // a gap, not a guess
                    continue;
                }
                const Spot at = spot(p.x, p.y);
                path += fmt::format("{}{} {}", before == nullptr ? "M" : "L", coordinate(at.x),
                                    coordinate(at.y));
                if (before != nullptr)
                    strokes_.push_back({last, at});
                last = at;
                before = &last;
            }
            svg +=
                fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
                            path, look_of(static_cast<int>(i)).color);
        }
        return svg;
    }

    std::string spreads()
    {
        constexpr double kCap = 3;
        std::string svg;
        for (size_t i = 0; i < chart_.series.size(); ++i)
            for (const auto& p : chart_.series[i].points) {
                if (!is_shown(p) || !has_spread(p))
                    continue;
                const Spot low = spot(p.spread_low, p.y), high = spot(p.spread_high, p.y);
                const std::string paint =
                    fmt::format("stroke=\"{}\"", look_of(static_cast<int>(i)).color);
                svg += line(low, high, paint);
                for (const Spot& end : {low, high})
                    svg += line({end.x, end.y - kCap}, {end.x, end.y + kCap}, paint);
                strokes_.push_back({low, high});
            }
        return svg;
    }

    /// Hollow points first, so that the marked ones lie on top.
    std::string points()
    {
        std::string svg;
        for (const bool full : {false, true})
            for (size_t i = 0; i < chart_.series.size(); ++i)
                for (const auto& p : chart_.series[i].points)
                    if (is_shown(p) && p.is_marked == full)
                        svg += point(chart_.series[i], p, look_of(static_cast<int>(i)));
        return svg;
    }

    std::string point(const Series& series, const ChartPoint& p, const Look& look)
    {
        const Spot at = spot(p.x, p.y);
        spots_.push_back(at);
        std::string name = series.name;
        if (!p.label.empty() && p.label != name)
            name += (name.empty() ? "" : ", ") + p.label;
        return fmt::format("<g><title>{}\n{}: {}\n{}: {}</title>{}</g>\n", escaped(name),
                           escaped(chart_.x.label), brief(p.x), escaped(chart_.y.label), brief(p.y),
                           marker(look, at.x, at.y, p.is_marked));
    }

    std::string labels()
    {
        std::vector<LabelWish> wishes;
        std::vector<const ChartPoint*> owners;
        for (const auto& series : chart_.series)
            for (const auto& p : series.points)
                if (is_shown(p) && !p.label.empty()) {
                    wishes.push_back(
                        {spot(p.x, p.y), text_width(p.label, kLabelFont), kLabelFont + 3});
                    owners.push_back(&p);
                }
        const auto boxes = place_labels(wishes, spots_, kMarkerRadius, strokes_, frame_);
        std::string svg;
        for (size_t i = 0; i < boxes.size(); ++i) {
            if (!boxes[i]) {
                ++unplaced_;
                continue;
            }
            svg += leader(wishes[i].point, *boxes[i]);
            svg += text(words_x(wishes[i].point, *boxes[i]), boxes[i]->y1 - 3.5, owners[i]->label,
                        words_anchor(wishes[i].point, *boxes[i]));
        }
        return fmt::format("<g font-size=\"{}\" stroke-linejoin=\"round\">\n{}</g>\n", kLabelFont,
                           svg);
    }

    static std::string leader(const Spot& point, const Box& box)
    {
        constexpr double kFar = kMarkerRadius + 8;
        const Spot end = {std::clamp(point.x, box.x0, box.x1), std::clamp(point.y, box.y0, box.y1)};
        const double distance = std::hypot(end.x - point.x, end.y - point.y);
        if (distance < kFar)
            return "";
        const double start = kMarkerRadius / distance;
        return line({point.x + start * (end.x - point.x), point.y + start * (end.y - point.y)}, end,
                    fmt::format("stroke=\"{}\" stroke-width=\"0.8\"", kFrame));
    }

    /// Words are anchored on the side of their point, so that a face of another width than the
    /// estimate moves them away from it, not onto it.
    static double words_x(const Spot& point, const Box& box)
    {
        return point.x < box.x0 ? box.x0 : point.x > box.x1 ? box.x1 : (box.x0 + box.x1) / 2;
    }

    static std::string words_anchor(const Spot& point, const Box& box)
    {
        const char* anchor = point.x < box.x0 ? "start" : point.x > box.x1 ? "end" : "middle";
        return fmt::format("text-anchor=\"{}\"", anchor);
    }

    [[nodiscard]] std::string foot() const
    {
        std::string note = note_;
        if (unplaced_ > 0)
            note += fmt::format("{}{} label{} without room: hover over the point.",
                                note.empty() ? "" : " ", unplaced_, unplaced_ == 1 ? "" : "s");
        const std::string words =
            note.empty() ? ""
                         : text(16, chart_.height - 8.0, note,
                                fmt::format("font-size=\"{}\" fill=\"{}\"", kLabelFont, kQuietInk));
        return words + "</svg>\n";
    }

    const Chart& chart_;
    Scale x_, y_;
    std::string note_;
    Legend legend_;
    Box frame_;
    std::vector<Spot> spots_;
    std::vector<Stroke> strokes_;
    int unplaced_ = 0;
};

} // namespace

std::string to_svg(const Chart& chart) { return Drawing(chart).svg(); }

} // namespace scree::report
