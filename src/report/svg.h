#pragma once

#include <string>
#include <vector>

namespace scree::report {

/// A place on paper: CSS pixels from the upper left corner, y down.
struct Spot {
    double x = 0, y = 0;
};

/// A rectangle on paper.
struct Box {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// A text element; words are escaped.
std::string svg_text(const Spot& at, const std::string& words, const std::string& attributes);

/// Lines of text downwards from the first.
std::string svg_lines(Spot at, double line_height, const std::vector<std::string>& lines,
                      const std::string& attributes);

/// A line element.
std::string svg_line(const Spot& from, const Spot& to, const std::string& attributes);

} // namespace scree::report
