#pragma once

#include <cstddef>

namespace scree {

// Loops over lines side by side; each line by itself, so that the numbers do not depend on which
// lines go with it. No fused multiply-add: the same on every machine.

/// Heights of lines, at the fraction f between two texels of a row.
///
/// row  count + 1 heights
void in_row(const float* row, float f, int count, float* heights);

/// The same between two rows, at the fraction g from the first to the next.
void between_rows(const float* row, const float* next, float f, float g, int count, float* heights);

/// The same on the columns themselves.
///
/// row  count heights
void in_columns(const float* row, const float* next, float g, int count, float* heights);

/// Heights between two texels become NaN where the cells on both sides lack one of their texels.
///
/// before, after  texels on both sides: of a line the one at its number and another
/// other          how far that is
void leave_out_torn(const float* before, const float* after, std::ptrdiff_t other, int count,
                    float* heights);

/// Nodes of lines on a piece of their way, straight in between.
struct LineNodes {
    static constexpr int kMost = 5;
    int count;                   ///< 1 to kMost
    const float* heights[kMost]; ///< at a node: those of lines, world units; NaN: no surface
    float drops[kMost];          ///< of the line of sight from the node before, in those of a step
};

/// What nodes make of the maxima of the height above the line of sight. Where heights are NaN a
/// maximum just falls.
///
/// scale   to turn heights into drops of the line of sight a step
/// maxima  before and after, in drops above the line of sight where it is
void pass_nodes(const LineNodes& nodes, float scale, int count, float* maxima);

/// The same, of up to 3 nodes; what the maxima rise by is added to `visible`.
void see_nodes(const LineNodes& nodes, float scale, int count, float* maxima, float* visible);

/// The same where the surface has ends: what is seen need not be what hides.
///
/// texels  heights of the texels that the lines are in; what is seen where they are NaN is left out
/// hiding  what makes the maxima
/// before  what is seen where the piece begins: a number wherever the texel has one
/// shown   the same at the nodes
void see_nodes_with_ends(const float* texels, const LineNodes& hiding, const float* before,
                         const LineNodes& shown, float scale, int count, float* maxima,
                         float* visible);

/// Turns a grid: row r of `from`, `columns` long, becomes column r of `to`.
///
/// to_stride  from row to row of `to`
void turn(const float* from, int rows, int columns, float* to, std::ptrdiff_t to_stride);

} // namespace scree
