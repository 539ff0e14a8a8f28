#include "report/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/chart_data.h"
#include "report/font.h"
#include "report/labels.h"
#include "report/legend.h"
#include "report/marker.h"
#include "report/markup.h"
#include "report/numbers.h"
#include "report/scale.h"

namespace scree::report {

namespace {

constexpr const char* kInk = "#1c1f23";
constexpr const char* kQuietInk = "#5d666f";
constexpr const char* kGrid = "#dfe3e7";
constexpr const char* kFaintGrid = "#f0f2f4";
constexpr const char* kRule = "#8a939c";
constexpr double kMargin = 16;     // of words, from the edge of the picture
constexpr double kBelowPlot = 46;  // numbers and label of the x axis
constexpr double kLineHeight = 15; // of small words

/// Draws a chart part by part; what comes later keeps clear of what came before.
class Drawing {
public:
    explicit Drawing(const Chart& chart)
        : chart_(chart), title_(wrapped(chart.title, kTitleSize, chart.width - 2 * kMargin)),
          remarks_(remarks_on(chart)), legend_(chart, chart.width - 2 * kMargin),
          x_(shown_x(chart), chart.x.logarithmic, std::max(2, chart.width / 85)),
          y_(shown_y(chart), chart.y.logarithmic, std::max(2, chart.height / 65))
    {
        constexpr double kAxisLabel = 36, kRight = 36, kSmallest = 40;
        double widest = 0;
        for (const auto& tick : y_.ticks())
            widest = std::max(widest, text_width(tick.text, kFontSize));
        const double below =
            kBelowPlot + legend_.height() + kLineHeight * static_cast<double>(remarks_.size() + 1);
        frame_.x0 = kAxisLabel + widest;
        frame_.x1 = chart.width - kRight;
        frame_.y0 = 18 + 20 * static_cast<double>(title_.size());
        frame_.y1 = std::max(frame_.y0 + kSmallest, chart.height - below);
    }

    std::string svg()
    {
        std::string svg = head() + grid() + axes();
        svg += lines();
        svg += spreads();
        svg += points();
        svg += labels();
        svg += legend_.draw({kMargin, frame_.y1 + kBelowPlot});
        return svg + foot();
    }

private:
    [[nodiscard]] double across(double place) const
    {
        return frame_.x0 + place * (frame_.x1 - frame_.x0);
    }
    [[nodiscard]] double up(double place) const
    {
        return frame_.y1 - place * (frame_.y1 - frame_.y0);
    }
    [[nodiscard]] Spot spot(double x, double y) const
    {
        return {across(x_.place(x)), up(y_.place(y))};
    }

    [[nodiscard]] std::string head() const
    {
        return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                           "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\" "
                           "font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', "
                           "sans-serif\" font-size=\"{3}\" fill=\"{4}\">\n"
                           "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                           chart_.width, chart_.height, escaped(chart_.title), kFontSize, kInk) +
               svg_lines({kMargin, 24}, 20, title_,
                         fmt::format("font-size=\"{}\" font-weight=\"600\"", kTitleSize));
    }

    [[nodiscard]] std::string grid() const
    {
        std::string faint, full;
        for (const auto& tick : x_.ticks()) {
            const double x = across(tick.place);
            (tick.text.empty() ? faint : full) += svg_line({x, frame_.y0}, {x, frame_.y1}, "");
        }
        for (const auto& tick : y_.ticks()) {
            const double y = up(tick.place);
            (tick.text.empty() ? faint : full) += svg_line({frame_.x0, y}, {frame_.x1, y}, "");
        }
        return fmt::format("<g stroke=\"{}\">\n{}</g>\n<g stroke=\"{}\">\n{}</g>\n", kFaintGrid,
                           faint, kGrid, full);
    }

    [[nodiscard]] std::string axes() const
    {
        std::string svg = fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\"/>\n",
            coordinate(frame_.x0), coordinate(frame_.y0), coordinate(frame_.x1 - frame_.x0),
            coordinate(frame_.y1 - frame_.y0), kRule);
        for (const auto& tick : x_.ticks())
            if (!tick.text.empty())
                svg += svg_text({across(tick.place), frame_.y1 + 16}, tick.text,
                                "text-anchor=\"middle\"");
        for (const auto& tick : y_.ticks())
            if (!tick.text.empty())
                svg +=
                    svg_text({frame_.x0 - 7, up(tick.place) + 4}, tick.text, "text-anchor=\"end\"");
        svg += svg_text({across(0.5), frame_.y1 + 36}, chart_.x.label, "text-anchor=\"middle\"");
        svg += svg_text({18, up(0.5)}, chart_.y.label,
                        fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {})\"",
                                    coordinate(up(0.5))));
        return svg;
    }

    std::string lines()
    {
        std::string svg;
        for (size_t i = 0; i < chart_.series.size(); ++i)
            if (chart_.series[i].is_line)
                svg += fmt::format("<path d=\"{}\" {}/>\n", path(chart_.series[i]),
                                   line_paint(look_of(static_cast<int>(i)),
                                              is_crowded(chart_.series[i], frame_.x1 - frame_.x0)));
        return svg;
    }

    /// A missing point leaves a gap rather than a guess.
    std::string path(const Series& series)
    {
        std::string path;
        const ChartPoint* before = nullptr;
        for (const auto& p : series.points) {
            if (!is_shown(p)) {
                before = nullptr;
                continue;
            }
            const Spot at = spot(p.x, p.y);
            path += fmt::format("{}{} {}", before == nullptr ? "M" : "L", coordinate(at.x),
                                coordinate(at.y));
            if (before != nullptr)
                strokes_.push_back({spot(before->x, before->y), at});
            before = &p;
        }
        return path;
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
                svg += svg_line(low, high, paint);
                for (const Spot& end : {low, high})
                    svg += svg_line({end.x, end.y - kCap}, {end.x, end.y + kCap}, paint);
                strokes_.push_back({low, high});
            }
        return svg;
    }

    /// Hollow points first, so that the marked ones lie on top.
    std::string points()
    {
        std::string svg;
        for (const bool full : {false, true})
            for (size_t i = 0; i < chart_.series.size(); ++i) {
                const Series& series = chart_.series[i];
                const bool crowded = is_crowded(series, frame_.x1 - frame_.x0);
                for (const auto& p : series.points)
                    if (is_shown(p) && p.is_marked == full)
                        svg += point(series, p, look_of(static_cast<int>(i)), crowded && !full);
            }
        return svg;
    }

    /// With its name and numbers, which a reader sees on hovering; those stay where the marker
    /// goes.
    std::string point(const Series& series, const ChartPoint& p, const Look& look, bool is_bare)
    {
        const Spot at = spot(p.x, p.y);
        std::string name = series.name;
        if (!p.label.empty() && p.label != name)
            name += (name.empty() ? "" : ", ") + p.label;
        const std::string numbers =
            fmt::format("{}: {}\n{}: {}", chart_.x.label, brief(p.x), chart_.y.label, brief(p.y));
        if (!is_bare)
            spots_.push_back(at);
        const std::string shape =
            is_bare ? fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"5\" fill-opacity=\"0\"/>",
                                  coordinate(at.x), coordinate(at.y))
                    : marker(look, at, p.is_marked);
        return fmt::format("<g><title>{}</title>{}</g>\n",
                           escaped(name.empty() ? numbers : name + "\n" + numbers), shape);
    }

    std::string labels()
    {
        constexpr double kDescent = 3.5, kLeading = 3;
        std::vector<LabelWish> wishes;
        std::vector<std::string> words;
        for (const auto& series : chart_.series)
            for (const auto& p : series.points)
                if (is_shown(p) && !p.label.empty()) {
                    wishes.push_back(
                        {spot(p.x, p.y), text_width(p.label, kSmallSize), kSmallSize + kLeading});
                    words.push_back(p.label);
                }
        const auto boxes = place_labels(wishes, spots_, kMarkerRadius, strokes_, frame_);
        std::string svg;
        for (size_t i = 0; i < boxes.size(); ++i)
            if (boxes[i]) {
                const auto [x, anchor] = anchored(wishes[i].point, *boxes[i]);
                svg += leader(wishes[i].point, *boxes[i]) +
                       svg_text({x, boxes[i]->y1 - kDescent}, words[i],
                                fmt::format("text-anchor=\"{}\"", anchor));
            }
        const auto unplaced = std::count(boxes.begin(), boxes.end(), std::nullopt);
        if (unplaced > 0)
            remarks_.push_back(fmt::format("No room for {}; they show over their points.",
                                           counted(static_cast<int>(unplaced), "label")));
        return fmt::format("<g font-size=\"{}\">\n{}</g>\n", kSmallSize, svg);
    }

    /// From a point to a label that stands away from it.
    static std::string leader(const Spot& point, const Box& box)
    {
        constexpr double kFar = kMarkerRadius + 8;
        const Spot end = nearest_in(box, point);
        const double distance = std::hypot(end.x - point.x, end.y - point.y);
        if (distance < kFar)
            return "";
        const double start = kMarkerRadius / distance;
        return svg_line({point.x + start * (end.x - point.x), point.y + start * (end.y - point.y)},
                        end, fmt::format("stroke=\"{}\" stroke-width=\"0.8\"", kQuietInk));
    }

    /// Words are anchored on the side of their point, so that a face wider than the estimate grows
    /// away from it.
    static std::pair<double, const char*> anchored(const Spot& point, const Box& box)
    {
        if (point.x < box.x0)
            return {box.x0, "start"};
        if (point.x > box.x1)
            return {box.x1, "end"};
        return {(box.x0 + box.x1) / 2, "middle"};
    }

    [[nodiscard]] std::string foot() const
    {
        const double first =
            chart_.height - 9 - kLineHeight * (static_cast<double>(remarks_.size()) - 1);
        return svg_lines({kMargin, first}, kLineHeight, remarks_,
                         fmt::format("font-size=\"{}\" fill=\"{}\"", kSmallSize, kQuietInk)) +
               "</svg>\n";
    }

    const Chart& chart_;
    std::vector<std::string> title_, remarks_;
    Legend legend_;
    Scale x_, y_;
    Box frame_;
    std::vector<Spot> spots_;     ///< of markers
    std::vector<Stroke> strokes_; ///< of lines and spreads
};

} // namespace

std::string to_svg(const Chart& chart) { return Drawing(chart).svg(); }

} // namespace scree::report
