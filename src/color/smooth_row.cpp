#include "color/smooth_row.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scree {

namespace {

constexpr double kPanelDeviations = 3;

double panel_count(double low, double high, double deviation)
{
    return std::ceil((high - low) / (kPanelDeviations * deviation));
}

} // namespace

SmoothRow::SmoothRow(const std::function<Rgb(double)>& average, double low, double high,
                     double deviation)
    : low_(low), panel_width_((high - low) / panel_count(low, high, deviation))
{
    assert(low < high && deviation > 0);
    const double quarter_turn = std::acos(0.0);
    std::array<std::array<double, kNodes>, kNodes> cosines; // of coefficient j at node i
    for (int i = 0; i < kNodes; ++i)
        for (int j = 0; j < kNodes; ++j)
            cosines[static_cast<size_t>(i)][static_cast<size_t>(j)] =
                std::cos(quarter_turn * j * (2 * i + 1) / kNodes);

    panels_.resize(static_cast<size_t>(panel_count(low, high, deviation)));
    for (size_t p = 0; p < panels_.size(); ++p) {
        panels_[p].fill({});
        for (const auto& row : cosines) {
            const double mean = low_ + panel_width_ * (static_cast<double>(p) + (1 + row[1]) / 2);
            const Rgb color = average(mean);
            for (size_t j = 0; j < kNodes; ++j)
                for (size_t c = 0; c < 3; ++c)
                    panels_[p][j][c] += color[c] * row[j] * (j == 0 ? 1.0 : 2.0) / kNodes;
        }
    }
}

Rgb SmoothRow::at(double mean) const
{
    const double place = (mean - low_) / panel_width_;
    const double panel =
        std::clamp(std::floor(place), 0.0, static_cast<double>(panels_.size() - 1));
    const double t = 2 * (place - panel) - 1; // in [-1, 1]
    const Series& series = panels_[static_cast<size_t>(panel)];
    Rgb last{}, before{}; // Clenshaw's recurrence
    for (size_t j = kNodes - 1; j > 0; --j)
        for (size_t c = 0; c < 3; ++c) {
            const double next = series[j][c] + 2 * t * last[c] - before[c];
            before[c] = last[c];
            last[c] = next;
        }
    Rgb color;
    for (size_t c = 0; c < 3; ++c)
        color[c] = series[0][c] + t * last[c] - before[c];
    return color;
}

double SmoothRow::cost(double low, double high, double deviation)
{
    return kNodes * panel_count(low, high, deviation);
}

} // namespace scree
