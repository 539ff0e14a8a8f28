#include "color/filtered_map.h"

#include <cassert>
#include <limits>

#include "color/table_error.h"

namespace scree {

namespace {

/// 2^n + 1 becomes 2^(n + 1) + 1.
int doubled(int count) { return 2 * count - 1; }

/// What errors are a share of. A map of one color in its range but others outside, which wide
/// densities reach, is measured by those.
double span_of(const ColorMap& map, double low, double high)
{
    const double inside = color_span(map, low, high);
    return inside > 0 ? inside
                      : color_span(map, -std::numeric_limits<double>::max(),
                                   std::numeric_limits<double>::max());
}

/// Adds columns or rows, whichever are to blame; false when there can be no more of them.
bool grow(int& columns, int& rows, const TableError& error, double tolerance)
{
    const bool more_columns = columns < kMostMapColumns,
               more_rows = 1 < rows && rows < kMostMapRows;
    const bool blame_columns = error.from_columns >= error.from_rows;
    if (blame_columns ? more_columns : more_rows) {
        int& count = blame_columns ? columns : rows;
        count = doubled(count);
        return true;
    }
    // The one to blame is as large as it may be: the other still has to meet the tolerance.
    if (blame_columns && more_rows && error.from_rows > tolerance)
        rows = doubled(rows);
    else if (!blame_columns && more_columns && error.from_columns > tolerance)
        columns = doubled(columns);
    else
        return false;
    return true;
}

} // namespace

FilteredMap make_filtered_map(const ColorMap& map, MapVariable variable, double low, double high,
                              double widest, double tolerance)
{
    assert(low <= high && widest >= 0 && tolerance > 0);
    const double span = span_of(map, low, high);
    ExactTable exact(map, variable, low, high, widest);
    int columns = 2, rows = widest > 0 ? 2 : 1;
    while (true) {
        FilteredMap filtered;
        filtered.table = exact.sampled(columns, rows);
        filtered.tolerance = tolerance;
        if (span == 0) {
            filtered.reached = true;
            return filtered;
        }
        TableError error = table_error(exact, filtered.table, Thoroughness::sketchy);
        if (error.rms > tolerance * span && grow(columns, rows, error, tolerance * span))
            continue;
        error = table_error(exact, filtered.table, Thoroughness::thorough);
        filtered.rms_error = error.rms / span;
        filtered.largest_error = error.largest / span;
        filtered.reached = filtered.rms_error <= tolerance;
        if (filtered.reached || !grow(columns, rows, error, tolerance * span))
            return filtered;
    }
}

} // namespace scree
