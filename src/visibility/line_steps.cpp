#include "visibility/line_steps.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// The height at the fraction f from one to another.
inline float between(float a, float b, float f) { return a + f * (b - a); }

/// From one node to the next of one line; what it sees.
inline float rise(float height, float drop, float& maximum)
{
    const float before = maximum - drop;
    maximum = height > before ? height : before;
    return maximum - before;
}

// Inlined, so that they are vectorized as the functions that call them are. Restrict: so many
// arrays that compilers do not check whether they overlap, and give up.

template <int kNodes>
[[gnu::always_inline]] inline void pass(const LineNodes& nodes, float scale, int count,
                                        float* __restrict maxima)
{
    const float* heights[kNodes];
    float drops[kNodes];
    std::copy_n(nodes.heights, kNodes, heights);
    std::copy_n(nodes.drops, kNodes, drops);
    for (int j = 0; j < count; ++j)
        for (int n = 0; n < kNodes; ++n)
            rise(heights[n][j] * scale, drops[n], maxima[j]);
}

template <int kNodes>
[[gnu::always_inline]] inline void see(const LineNodes& nodes, float scale, int count,
                                       float* __restrict maxima, float* __restrict visible)
{
    const float* heights[kNodes];
    float drops[kNodes];
    std::copy_n(nodes.heights, kNodes, heights);
    std::copy_n(nodes.drops, kNodes, drops);
    for (int j = 0; j < count; ++j) {
        float maximum = maxima[j], seen = visible[j];
        for (int n = 0; n < kNodes; ++n)
            seen += rise(heights[n][j] * scale, drops[n], maximum);
        maxima[j] = maximum;
        visible[j] = seen;
    }
}

template <int kNodes>
[[gnu::always_inline]] inline void see_with_ends(const float* texels, const LineNodes& hiding,
                                                 const float* before, const LineNodes& shown,
                                                 float scale, int count, float* __restrict maxima,
                                                 float* __restrict visible)
{
    const float *heights[kNodes], *shown_heights[kNodes];
    float drops[kNodes];
    std::copy_n(hiding.heights, kNodes, heights);
    std::copy_n(shown.heights, kNodes, shown_heights);
    std::copy_n(hiding.drops, kNodes, drops);
    for (int j = 0; j < count; ++j) {
        const float near = before[j] * scale;
        float hidden = maxima[j], maximum = near > hidden ? near : hidden, seen = 0;
        for (int n = 0; n < kNodes; ++n) {
            seen += rise(shown_heights[n][j] * scale, drops[n], maximum);
            rise(heights[n][j] * scale, drops[n], hidden);
        }
        maxima[j] = hidden;
        visible[j] += texels[j] == texels[j] ? seen : 0.0F; // false for NaN
    }
}

} // namespace

[[gnu::target_clones("avx2", "default")]] void in_row(const float* row, float f, int count,
                                                      float* heights)
{
    for (int j = 0; j < count; ++j)
        heights[j] = between(row[j], row[j + 1], f);
}

[[gnu::target_clones("avx2", "default")]] void
between_rows(const float* row, const float* next, float f, float g, int count, float* heights)
{
    for (int j = 0; j < count; ++j)
        heights[j] = between(between(row[j], row[j + 1], f), between(next[j], next[j + 1], f), g);
}

[[gnu::target_clones("avx2", "default")]] void in_columns(const float* row, const float* next,
                                                          float g, int count, float* heights)
{
    for (int j = 0; j < count; ++j)
        heights[j] = between(row[j], next[j], g);
}

[[gnu::target_clones("avx2", "default")]] void leave_out_torn(const float* before,
                                                              const float* after, ptrdiff_t other,
                                                              int count, float* __restrict heights)
{
    for (int j = 0; j < count; ++j) {
        const float a = before[j] + before[j + other], b = after[j] + after[j + other];
        heights[j] = a == a || b == b ? heights[j] : kNone; // false for NaN
    }
}

[[gnu::target_clones("avx2", "default")]] void pass_nodes(const LineNodes& nodes, float scale,
                                                          int count, float* maxima)
{
    switch (nodes.count) {
    case 1:
        return pass<1>(nodes, scale, count, maxima);
    case 2:
        return pass<2>(nodes, scale, count, maxima);
    case 3:
        return pass<3>(nodes, scale, count, maxima);
    case 4:
        return pass<4>(nodes, scale, count, maxima);
    default:
        return pass<5>(nodes, scale, count, maxima);
    }
}

[[gnu::target_clones("avx2", "default")]] void see_nodes(const LineNodes& nodes, float scale,
                                                         int count, float* maxima, float* visible)
{
    switch (nodes.count) {
    case 1:
        return see<1>(nodes, scale, count, maxima, visible);
    case 2:
        return see<2>(nodes, scale, count, maxima, visible);
    default:
        return see<3>(nodes, scale, count, maxima, visible);
    }
}

[[gnu::target_clones("avx2", "default")]] void
see_nodes_with_ends(const float* texels, const LineNodes& hiding, const float* before,
                    const LineNodes& shown, float scale, int count, float* maxima, float* visible)
{
    switch (hiding.count) {
    case 1:
        return see_with_ends<1>(texels, hiding, before, shown, scale, count, maxima, visible);
    case 2:
        return see_with_ends<2>(texels, hiding, before, shown, scale, count, maxima, visible);
    default:
        return see_with_ends<3>(texels, hiding, before, shown, scale, count, maxima, visible);
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
