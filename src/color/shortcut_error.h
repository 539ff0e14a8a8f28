#pragma once

#include "color/color_map.h"

namespace scree {

/// What a table of (mean, deviation) loses against the exact visible color, as shares of the map's
/// color span over [low, high].
struct ShortcutError {
    double rms = 0;                               ///< over the grid, of the worst channel
    double largest = 0;                           ///< of any channel
    double mean = 0, deviation = 0, exponent = 0; ///< where the largest is
};

/// Measures T(mean + deviation mu(L), deviation sqrt(nu(L))) against visible_color: visible heights
/// are not normal, and the table takes them as if they were. No table is involved, nor its errors.
///
/// The grid: 33 means evenly from low to high, the deviations widest (k / 8)^2 for k = 1..8, and
/// the exponents 0, 0.1, 0.3, 1, 3, ... 1e6.
/// low, high, widest  as in make_filtered_map
ShortcutError shortcut_error(const ColorMap& map, double low, double high, double widest);

} // namespace scree
