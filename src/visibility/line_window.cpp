#include "visibility/line_window.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

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
    const int margin = completes() ? 2 : 0;
    place_ = place - margin;
    position_ = position - margin;
    rows_ = places + 2 * margin;
    columns_ = positions + 2 * margin;
    whole_.resize(static_cast<size_t>(rows_) * static_cast<size_t>(columns_));
    if (along_s_) {
        unturned_.resize(whole_.size());
        grid_.read(level_, place_, position_, rows_, columns_, unturned_.data());
        turn(unturned_.data(), columns_, rows_, whole_.data(), columns_);
    } else {
        grid_.read(level_, position_, place_, columns_, rows_, whole_.data());
    }
    if (completes())
        complete();
}

/// Makes up heights, up to one texel beyond a map that ends.
void LineWindow::complete()
{
    given_ = whole_;
    const HeightGrid::Shape& shape = grid_.shape();
    const auto inside = [](int first, int count, int size, Edge edge) {
        const bool ends = !goes_on(edge);
        return std::pair(ends ? std::max(2, -1 - first) : 2,
                         ends ? std::min(count - 2, size + 1 - first) : count - 2);
    };
    const auto [first_s, end_s] = inside(along_s_ ? place_ : position_, along_s_ ? rows_ : columns_,
                                         shape.width, shape.edge_s);
    const auto [first_t, end_t] = inside(along_s_ ? position_ : place_, along_s_ ? columns_ : rows_,
                                         shape.height, shape.edge_t);
    for (int row = along_s_ ? first_s : first_t; row < (along_s_ ? end_s : end_t); ++row)
        for (int c = along_s_ ? first_t : first_s; c < (along_s_ ? end_t : end_s); ++c) {
            const ptrdiff_t i = static_cast<ptrdiff_t>(row) * columns_ + c;
            if (std::isnan(given_[static_cast<size_t>(i)]))
                whole_[static_cast<size_t>(i)] = continued(given_.data() + i, columns_);
        }
}

} // namespace scree
