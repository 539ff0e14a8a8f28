#include "visibility/line_steps.h"

#include <algorithm>

namespace scree {

namespace {

/// Of two heights halfway between two texels of a row.
inline float between(float a, float b, float f) { return a + f * (b - a); }

/// A step of one line; what it sees.
inline float step(float centre, float edge, float& maximum)
{
    const float before = maximum - 0.5F;
    const float at_centre = centre > before ? centre : before;
    const float middle = at_centre - 0.5F;
    maximum = edge > middle ? edge : middle;
    return (at_centre - before) + (maximum - middle);
}

} // namespace

[[gnu::target_clones("avx2", "default")]] void in_row(const float* row, float f, int count,
                                                      float* heights)
{
    for (int j = 0; j < count; ++j)
        heights[j] = between(row[j], row[j + 1], f);
}

[[gnu::target_clones("avx2", "default")]] void between_rows(const float* row, const float* next,
                                                            float f, int count, float* heights)
{
    for (int j = 0; j < count; ++j)
        heights[j] = 0.5F * (between(row[j], row[j + 1], f) + between(next[j], next[j + 1], f));
}

[[gnu::target_clones("avx2", "default")]] void pass_step(const StepHeights& heights, float scale,
                                                         int count, float* maxima)
{
    const float *centre = heights.centre, *edge = heights.edge;
    for (int j = 0; j < count; ++j)
        step(centre[j] * scale, edge[j] * scale, maxima[j]);
}

[[gnu::target_clones("avx2", "default")]] void see_step(const StepHeights& heights, float scale,
                                                        int count, float* maxima, float* visible)
{
    const float *centre = heights.centre, *edge = heights.edge;
    for (int j = 0; j < count; ++j)
        visible[j] += step(centre[j] * scale, edge[j] * scale, maxima[j]);
}

[[gnu::target_clones("avx2", "default")]] void
see_step_with_ends(const float* texels, const StepHeights& hiding, const StepHeights& shown,
                   float scale, int count, float* __restrict maxima, float* __restrict visible)
{ // restrict: so many arrays that compilers do not check whether they overlap, and give up
    const float *hiding_centre = hiding.centre, *hiding_edge = hiding.edge;
    const float *near = shown.near, *centre = shown.centre, *edge = shown.edge;
    for (int j = 0; j < count; ++j) {
        const float before = near[j] * scale;
        float maximum = before > maxima[j] ? before : maxima[j];
        const float seen = step(centre[j] * scale, edge[j] * scale, maximum);
        step(hiding_centre[j] * scale, hiding_edge[j] * scale, maxima[j]);
        visible[j] += texels[j] == texels[j] ? seen : 0.0F; // false for NaN
    }
}

void turn(const float* from, int rows, int columns, float* to, ptrdiff_t to_stride)
{
    constexpr int kTile = 8; // rows may be a power of 2 apart, and a cache set has few lines
    for (int tile = 0; tile < columns; tile += kTile)
        for (int r = 0; r < rows; ++r)
            for (int c = tile; c < std::min(tile + kTile, columns); ++c)
                to[c * to_stride + r] = from[static_cast<ptrdiff_t>(r) * columns + c];
}

} // namespace scree
