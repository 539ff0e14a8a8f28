#pragma once

#include <cstddef>

namespace scree {

// Loops over lines side by side; each line by itself, so that the numbers do not depend on which
// lines go with it. No fused multiply-add: the same on every machine.

/// Heights of lines, at the fraction f between two texels of a row.
///
/// row  count + 1 heights
void in_row(const float* row, float f, int count, float* heights);

/// The same halfway between two rows.
void between_rows(const float* row, const float* next, float f, int count, float* heights);

/// A step, to a texel's centre and on to its edge: what it makes of the maxima of the height above
/// the line of sight, which itself drops by 1 a step.
///
/// centre, edge  heights; where they are NaN a maximum just falls
/// scale         to turn them into drops
/// maxima        before and after, in drops above the line of sight where it is
void pass_step(const float* centre, const float* edge, float scale, int count, float* maxima);

/// The same; what the maxima rise by is added to `visible`.
void see_step(const float* centre, const float* edge, float scale, int count, float* maxima,
              float* visible);

/// The same where there may be no data.
///
/// texels  heights of the texels that the lines are in; what lines see where they are NaN is not
///         added, nor is what has no bound
void see_step_where(const float* texels, const float* centre, const float* edge, float scale,
                    int count, float* maxima, float* visible);

/// Turns a grid: row r of `from`, `columns` long, becomes column r of `to`.
///
/// to_stride  from row to row of `to`
void turn(const float* from, int rows, int columns, float* to, std::ptrdiff_t to_stride);

} // namespace scree
