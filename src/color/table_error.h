#pragma once

#include "color/exact_table.h"
#include "color/map_table.h"

namespace scree {

/// How far lookups in a table are from what they stand for, in units of the colors.
///
/// RMS figures are over the means, evenly spread from the first column to the last, of the worst
/// channel, at the worst deviation. They are integrals, not samples: three nodes of Gauss and
/// Legendre between neighbouring columns, knots, and places near jumps.
struct TableError {
    double rms = 0;          ///< of any deviation
    double from_columns = 0; ///< RMS at the deviations of rows: interpolation between columns
    double from_rows = 0;    ///< RMS of interpolation between exact rows
    /// Of any mean and any deviation of at least a column's width (or, where that is wider than the
    /// widest, of the widest): below, the table cannot follow a jump. Of eight places a column.
    /// Only a thorough look finds it.
    double largest = 0;
};

/// Which deviations are looked at: a few, for a decision, or every row and three places between.
enum class Thoroughness { sketchy, thorough };

/// table  sampled from `exact`
TableError table_error(ExactTable& exact, const MapTable& table, Thoroughness thoroughness);

} // namespace scree
