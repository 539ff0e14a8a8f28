#include "visibility/height_grid.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "stats/pyramid.h"

namespace scree {

namespace {

constexpr float kNoHeight = std::numeric_limits<float>::quiet_NaN();

int size_at(int size, int level)
{
    for (int l = 0; l < level; ++l)
        size = coarser_size(size);
    return size;
}

/// Where texel i of a line that goes on for ever lies in the map, and whether it runs backwards.
struct Folded {
    int texel;
    bool mirrored;
};

Folded folded(int i, int size, Edge edge)
{
    const int image = i >= 0 ? i / size : -((size - 1 - i) / size);
    const int inside = i - image * size;
    const bool mirrored = edge == Edge::repeat && image % 2 != 0;
    return {mirrored ? size - 1 - inside : inside, mirrored};
}

/// The height one texel beyond the end of a line.
float beyond(Edge edge, float last, float before_last, float ground)
{
    return edge == Edge::zero ? ground : 2 * last - before_last;
}

} // namespace

bool goes_on(Edge edge) { return edge == Edge::periodic || edge == Edge::repeat; }

int HeightGrid::width(int level) const { return size_at(shape_.width, level); }
int HeightGrid::height(int level) const { return size_at(shape_.height, level); }
int HeightGrid::levels() const { return level_count(shape_.width, shape_.height); }

void HeightGrid::read_line(int level, int x0, int y, int columns, float* heights) const
{
    const int size = width(level);
    if (goes_on(shape_.edge_s)) {
        for (int done = 0; done < columns;) {
            const Folded from = folded(x0 + done, size, shape_.edge_s);
            const int run =
                std::min(columns - done, from.mirrored ? from.texel + 1 : size - from.texel);
            read_row(level, from.mirrored ? from.texel - run + 1 : from.texel, y, run,
                     heights + done);
            if (from.mirrored)
                std::reverse(heights + done, heights + done + run);
            done += run;
        }
        return;
    }
    const int first = std::clamp(0, x0, x0 + columns), last = std::clamp(size, x0, x0 + columns);
    std::fill_n(heights, columns, kNoHeight);
    if (last > first)
        read_row(level, first, y, last - first, heights + (first - x0));
    if (level > 0)
        return;
    float ends[2];
    const int second = std::min(1, size - 1), before_last = std::max(size - 2, 0);
    if (x0 <= -1 && x0 + columns > -1) {
        read_row(level, 0, y, 1, &ends[0]);
        read_row(level, second, y, 1, &ends[1]);
        heights[-1 - x0] = beyond(shape_.edge_s, ends[0], ends[1], shape_.ground);
    }
    if (x0 <= size && x0 + columns > size) {
        read_row(level, size - 1, y, 1, &ends[0]);
        read_row(level, before_last, y, 1, &ends[1]);
        heights[size - x0] = beyond(shape_.edge_s, ends[0], ends[1], shape_.ground);
    }
}

void HeightGrid::read(int level, int x0, int y0, int columns, int rows, float* heights) const
{
    const int size = height(level);
    std::vector<float> line(static_cast<size_t>(columns));
    for (int row = 0; row < rows; ++row) {
        float* out = heights + static_cast<ptrdiff_t>(row) * columns;
        const int y = y0 + row;
        if (goes_on(shape_.edge_t)) {
            read_line(level, x0, folded(y, size, shape_.edge_t).texel, columns, out);
        } else if (y >= 0 && y < size) {
            read_line(level, x0, y, columns, out);
        } else if (level == 0 && (y == -1 || y == size)) {
            const int last = y < 0 ? 0 : size - 1;
            const int before_last = std::clamp(y < 0 ? 1 : size - 2, 0, size - 1);
            read_line(level, x0, last, columns, out);
            read_line(level, x0, before_last, columns, line.data());
            const bool ends = !goes_on(shape_.edge_s);
            for (int x = 0; x < columns; ++x)
                if (!ends || (x0 + x >= -1 && x0 + x <= shape_.width))
                    out[x] =
                        beyond(shape_.edge_t, out[x], line[static_cast<size_t>(x)], shape_.ground);
        } else {
            std::fill_n(out, columns, kNoHeight);
        }
    }
}

} // namespace scree
