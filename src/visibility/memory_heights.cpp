#include "visibility/memory_heights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "stats/pyramid.h"

namespace scree {

namespace {

HeightGrid::Shape with_range(HeightGrid::Shape shape, const std::vector<float>& heights)
{
    float low = std::numeric_limits<float>::infinity(), high = -low;
    shape.holes = false;
    for (const float h : heights) {
        shape.holes = shape.holes || std::isnan(h);
        low = h < low ? h : low; // false for NaN
        high = h > high ? h : high;
    }
    shape.lowest = low <= high ? static_cast<double>(low) : 0;
    shape.highest = low <= high ? static_cast<double>(high) : 0;
    return shape;
}

} // namespace

void coarser_heights(const float* const* fine_rows, const double* row_shares, int rows,
                     int fine_width, float* coarse)
{
    const int width = coarser_size(fine_width);
    for (int x = 0; x < width; ++x) {
        const Share columns = share_of(x, fine_width, width);
        double sum = 0, weight = 0, highest = -std::numeric_limits<double>::infinity();
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns.count; ++i) {
                const auto h = static_cast<double>(fine_rows[j][columns.first + i]);
                const double share = std::isnan(h) ? 0 : row_shares[j] * columns.parts[i];
                sum += share > 0 ? share * h : 0;
                highest = share > 0 && h > highest ? h : highest;
                weight += share;
            }
        coarse[x] = weight > 0 ? static_cast<float>(0.5 * (sum / weight + highest))
                               : std::numeric_limits<float>::quiet_NaN();
    }
}

MemoryHeights::MemoryHeights(const Shape& shape, std::vector<float> heights)
    : HeightGrid(with_range(shape, heights))
{
    levels_.push_back(std::move(heights));
    for (int level = 1; level < levels(); ++level) {
        const int fine_width = width(level - 1), columns = width(level), rows = height(level);
        std::vector<float> coarse(static_cast<size_t>(columns) * static_cast<size_t>(rows));
        for (int y = 0; y < rows; ++y) {
            const Share share = share_of(y, height(level - 1), rows);
            const float* fine_rows[3];
            for (int j = 0; j < share.count; ++j)
                fine_rows[j] =
                    levels_.back().data() + static_cast<ptrdiff_t>(share.first + j) * fine_width;
            coarser_heights(fine_rows, share.parts, share.count, fine_width,
                            coarse.data() + static_cast<ptrdiff_t>(y) * columns);
        }
        levels_.push_back(std::move(coarse));
    }
}

void MemoryHeights::read_row(int level, int x, int y, int count, float* heights) const
{
    const auto& rows = levels_[static_cast<size_t>(level)];
    std::copy_n(rows.data() + static_cast<ptrdiff_t>(y) * width(level) + x, count, heights);
}

} // namespace scree
