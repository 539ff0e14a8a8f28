#pragma once

#include <string>
#include <vector>

namespace scree::report {

struct Axis {
    std::string label; ///< with the unit
    bool logarithmic = false;
};

struct ChartPoint {
    double x = 0, y = 0;
    std::string label;      ///< beside the point; empty: none
    bool is_marked = false; ///< drawn full, such as on the Pareto front; others hollow
    double spread_low = 0, spread_high = 0; ///< of x, drawn as a bar; equal: none
};

struct Series {
    std::string name; ///< in the legend
    std::vector<ChartPoint> points;
    bool is_line = false; ///< joined in their order
};

/// A chart of series of points; points that a logarithmic axis cannot show are drawn at its edge.
struct Chart {
    std::string title;
    Axis x, y;
    std::vector<Series> series;
    int width = 760, height = 480; ///< CSS pixels
};

/// One self-contained SVG element: colors told apart by the color-blind, markers by shape too,
/// readable on white and in print.
std::string to_svg(const Chart& chart);

} // namespace scree::report
