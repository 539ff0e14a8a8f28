#include "visibility/line_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "visibility/line_steps.h"

namespace scree {

namespace {

/// What the texels around one without data, and those behind them, continue to; NaN where there
/// are none around.
///
/// h  height of the texel, inside a grid two texels larger on all sides
float continued(const float* h, ptrdiff_t stride)
{
    float sum = 0, near_sum = 0;
    int count = 0, near_count = 0;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
            const ptrdiff_t step = i * stride + j;
            const float near = h[step], behind = h[2 * step];
            if (std::isnan(near)) // the texel itself too
                continue;
            near_sum += near;
            ++near_count;
            if (std::isnan(behind))
                continue;
            sum += 2 * near - behind;
            ++count;
        }
    if (count > 0)
        return sum / static_cast<float>(count);
    return near_count > 0 ? near_sum / static_cast<float>(near_count)
                          : std::numeric_limits<float>::quiet_NaN();
}

} // namespace

void LineWindow::read(int place, int places, int position, int positions)
{
    place_ = place;
    position_ = position;
    rows_ = places;
    columns_ = positions;
    heights_.resize(static_cast<size_t>(places) * static_cast<size_t>(positions));
    if (along_s_) {
        other_.resize(heights_.size());
        grid_.read(level_, place, position, places, positions, other_.data());
        turn(other_.data(), positions, places, heights_.data(), positions);
    } else {
        grid_.read(level_, position, place, positions, places, heights_.data());
    }
}

void LineWindow::at(const LineNode& node, int position, int count, float* out) const
{
    const float* here = heights(node.row, position + node.column);
    if (node.along == 0)
        in_row(here, node.across, count, out);
    else if (node.across == 0)
        in_columns(here, here + columns_, node.along, count, out);
    else
        between_rows(here, here + columns_, node.across, node.along, count, out);
}

void LineWindow::whole_cells_at(const LineNode& node, int position, int count, float* out) const
{
    at(node, position, count, out);
    const float* here = heights(node.row, position + node.column);
    if (node.along == 0)
        leave_out_torn(here - columns_, here + columns_, 1, count, out);
    else if (node.across == 0)
        leave_out_torn(here - 1, here + 1, columns_, count, out);
}

void LineWindow::make_whole()
{
    if (!grid_.shape().holes)
        return;
    other_ = heights_;
    for (int row = kMargin; row < rows_ - kMargin; ++row)
        for (int column = kMargin; column < columns_ - kMargin; ++column) {
            const ptrdiff_t i = static_cast<ptrdiff_t>(row) * columns_ + column;
            if (float& height = heights_[static_cast<size_t>(i)]; std::isnan(height))
                height = continued(other_.data() + i, columns_);
        }
}

} // namespace scree
