#pragma once

#include "color/exact_table.h"
#include "color/map_table.h"

namespace scree {

/// The table of a color map, as coarse as a tolerance allows, and how good it is.
///
/// Errors are shares of the map's color span: the largest difference between two colors of the map
/// in one channel, over [low, high].
struct FilteredMap {
    MapTable table;
    double tolerance = 0;
    double rms_error = 0;     ///< over the means, at the worst deviation (TableError::rms)
    double largest_error = 0; ///< TableError::largest
    bool reached = false;     ///< whether rms_error is within the tolerance; if not, the table has
                              ///< all the columns or rows there may be
};

/// Largest table there may be.
constexpr int kMostMapColumns = 4097, kMostMapRows = 257;

/// Averages a map over normal densities of all means and deviations a texture set will ask for.
///
/// low, high  range of the means, low <= high: those of the heights, say
/// widest     largest deviation, at least 0; 0 gives one row, the map itself
/// tolerance  for rms_error. A jump of the whole span needs 1 / (3 tolerance^2) columns where it
///            falls on one, a quarter where it falls between two.
FilteredMap make_filtered_map(const ColorMap& map, MapVariable variable, double low, double high,
                              double widest, double tolerance);

} // namespace scree
