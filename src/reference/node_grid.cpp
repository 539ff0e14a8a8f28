#include "reference/node_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::reference {
namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

bool has_data(const Relief& relief, size_t texel)
{
    if (!std::isfinite(relief.heights[texel]))
        return false;
    if (!relief.weights.empty() && !(relief.weights[texel] > 0))
        return false; // a NaN is not > 0
    return relief.colors.empty() ||
           std::all_of(relief.colors[texel].begin(), relief.colors[texel].end(),
                       [](double channel) { return std::isfinite(channel); });
}

/// Sets the first and the last of n + 2 numbers, `stride` apart, from the n between them.
void continue_line(double* line, size_t stride, size_t n, Beyond beyond)
{
    double& before = line[0];
    double& after = line[(n + 1) * stride];
    const double first = line[stride];
    const double last = line[n * stride];
    switch (beyond) {
    case Beyond::repeats:
        before = last;
        after = first;
        break;
    case Beyond::mirrors:
        before = first;
        after = last;
        break;
    case Beyond::extends:
        before = n > 1 ? 2 * first - line[2 * stride] : first;
        after = n > 1 ? 2 * last - line[(n - 1) * stride] : last;
        break;
    case Beyond::ends:
        before = after = 0;
        break;
    }
}

} // namespace

NodeGrid::NodeGrid(const Relief& relief)
    : columns_(relief.width + 2), rows_(relief.height + 2),
      heights_(static_cast<size_t>(columns_) * static_cast<size_t>(rows_), kNoData)
{
    const auto width = static_cast<size_t>(relief.width);
    const auto height = static_cast<size_t>(relief.height);
    const auto columns = static_cast<size_t>(columns_);
    for (size_t y = 0; y < height; ++y) {
        double* row = heights_.data() + (y + 1) * columns;
        for (size_t x = 0; x < width; ++x)
            if (has_data(relief, y * width + x))
                row[x + 1] = relief.heights[y * width + x];
        continue_line(row, 1, width, relief.beyond_s);
    }
    for (size_t x = 0; x < columns; ++x)
        continue_line(heights_.data() + x, columns, height, relief.beyond_t);

    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double h : heights_) {
        low = h < low ? h : low; // false for NaN
        high = h > high ? h : high;
    }
    if (!(low <= high))
        return;
    base_ = low;
    range_ = high - low;
    tolerance_ = range_ * std::max(columns_, rows_) * 0x1p-50;
    for (double& h : heights_)
        h -= low;
}

} // namespace scree::reference
