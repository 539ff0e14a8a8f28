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

/// Heights of lines in a step: where a texel begins, at its centre, where it ends. World units, NaN
/// where there is no surface.
struct StepHeights {
    const float *near, *centre, *edge;
};

/// A step through a texel: what it makes of the maxima of the height above the line of sight, which
/// itself drops by 1 a step.
///
/// heights  near is not asked for, the step before has been there; where others are NaN a maximum
///          just falls
/// scale    to turn them into drops
/// maxima   before and after, in drops above the line of sight where it is
void pass_step(const StepHeights& heights, float scale, int count, float* maxima);

/// The same; what the maxima rise by is added to `visible`.
void see_step(const StepHeights& heights, float scale, int count, float* maxima, float* visible);

/// The same where the surface has ends: what is seen need not be what hides.
///
/// texels  heights of the texels that the lines are in; what is seen where they are NaN is left out
/// hiding  what makes the maxima
/// shown   what is seen: a number wherever the texel has one
void see_step_with_ends(const float* texels, const StepHeights& hiding, const StepHeights& shown,
                        float scale, int count, float* maxima, float* visible);

/// Turns a grid: row r of `from`, `columns` long, becomes column r of `to`.
///
/// to_stride  from row to row of `to`
void turn(const float* from, int rows, int columns, float* to, std::ptrdiff_t to_stride);

} // namespace scree
