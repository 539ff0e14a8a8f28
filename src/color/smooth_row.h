#pragma once

#include <functional>
#include <vector>

#include "color/color_map.h"

namespace scree {

/// A color averaged over a normal density of one deviation, as a function of the mean: polynomials
/// between Chebyshev's nodes, panel by panel, so that thousands of means cost what a few do.
///
/// Panels are at most three deviations wide and have 16 nodes. The n-th derivative of what a normal
/// density has averaged is at most span sqrt(n!) / 2 / deviation^n, which bounds the error by
/// 1.5^16 / (2^16 sqrt(16!)) = 2e-9 of the color span. [test: SmoothRow.FollowsTheAverage]
class SmoothRow {
public:
    /// average    the exact color of a mean
    /// low, high  range of the means, low < high
    /// deviation  above 0; the nodes grow as (high - low) / deviation
    SmoothRow(const std::function<Rgb(double)>& average, double low, double high, double deviation);

    /// mean  in [low, high]
    [[nodiscard]] Rgb at(double mean) const;

    /// Nodes a row of that deviation has: what building it costs.
    static double cost(double low, double high, double deviation);

private:
    static constexpr int kNodes = 16;
    using Series = std::array<Rgb, kNodes>; ///< Chebyshev coefficients

    double low_, panel_width_;
    std::vector<Series> panels_;
};

} // namespace scree
