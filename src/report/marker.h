#pragma once

#include <string>

#include "report/svg.h"

namespace scree::report {

/// How a series is told from the others: by color (Okabe and Ito 2008, without their yellow, which
/// white paper swallows) and by shape. 7 colors and 8 shapes: 56 series before two look alike.
struct Look {
    std::string color; ///< as in #0072b2
    int shape = 0;     ///< 0 to 7
    std::string dash;  ///< stroke-dasharray of its line; empty: solid
};

Look look_of(int series);

/// Half the width of a marker, its outline included, in pixels.
constexpr double kMarkerRadius = 6;

/// An SVG element.
/// is_full  else hollow: white inside
std::string marker(const Look& look, const Spot& at, bool is_full);

/// Attributes of a line.
/// is_dashed  to tell it from others without markers
std::string line_paint(const Look& look, bool is_dashed);

} // namespace scree::report
