#include "reference/base_texels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scree::reference {

namespace {

/// Own weight of a texel, 0 for no data.
double own_weight(const StatisticsInput& in, size_t i)
{
    const Relief& relief = in.relief;
    auto bad = [](double x) { return !std::isfinite(x); };
    if (!relief.heights.empty() && bad(relief.heights[i]))
        return 0;
    if (!relief.colors.empty() &&
        std::any_of(relief.colors[i].begin(), relief.colors[i].end(), bad))
        return 0;
    if (!in.slopes.empty() && std::any_of(in.slopes[i].begin(), in.slopes[i].end(), bad))
        return 0;
    if (relief.weights.empty())
        return 1;
    const auto weight = static_cast<double>(relief.weights[i]);
    return weight > 0 ? weight : 0; // a NaN is not > 0
}

/// Mean over the points, taken about the first: equal slopes have exactly that mean.
double mean_of(const std::array<std::array<double, 3>, 4>& points, int cells)
{
    const double first = points[0][0];
    double sum = 0;
    for (size_t q = 0; q < static_cast<size_t>(cells); ++q) {
        const auto& p = points[q];
        sum += (5 * (p[0] - first) + 8 * (p[1] - first) + 5 * (p[2] - first)) / 18;
    }
    return first + sum / cells;
}

} // namespace

BaseTexels::BaseTexels(const StatisticsInput& input)
    : width(input.relief.width), height(input.relief.height)
{
    check(input);
    const size_t n = static_cast<size_t>(width) * static_cast<size_t>(height);
    weights.resize(n);
    for (size_t i = 0; i < n; ++i) {
        weights[i] = own_weight(input, i);
        valid += weights[i] > 0 ? 1 : 0;
    }
    colors.resize(n);
    if (!input.relief.colors.empty())
        for (size_t i = 0; i < n; ++i)
            if (weights[i] > 0)
                colors[i] = input.relief.colors[i];
    hn.resize(n);
    if (!input.relief.heights.empty())
        normalise_heights(input.relief.heights, input.h0_h1);
    if (input.slopes.empty())
        heights_.emplace(input.relief, weights, input.reconstruction);
    mean_slopes.resize(n);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const size_t i = index(x, y);
            if (!(weights[i] > 0))
                continue;
            if (heights_) {
                const SlopePoints points = heights_->slopes(x, y);
                mean_slopes[i] = {mean_of(points.s, points.cells), mean_of(points.t, points.cells)};
            } else {
                mean_slopes[i] = input.slopes[i];
            }
        }
}

SlopePoints BaseTexels::slopes(int x, int y) const
{
    if (heights_)
        return heights_->slopes(x, y);
    const auto [s, t] = mean_slopes[index(x, y)];
    return constant_slope(s, t);
}

void BaseTexels::check(const StatisticsInput& input) const
{
    const Relief& relief = input.relief;
    if (width <= 0 || height <= 0)
        throw std::invalid_argument("statistics: width and height must be positive");
    if (!(relief.texel_width > 0 && relief.texel_height > 0))
        throw std::invalid_argument("statistics: the texel size must be positive");
    const size_t n = static_cast<size_t>(width) * static_cast<size_t>(height);
    auto wrong = [n](size_t size, bool optional) { return size != n && !(optional && size == 0); };
    if (wrong(relief.heights.size(), !input.slopes.empty()) || wrong(relief.colors.size(), true) ||
        wrong(relief.weights.size(), true) || wrong(input.slopes.size(), true))
        throw std::invalid_argument("statistics: a grid is not height x width");
    for (const float weight : relief.weights)
        if (std::isinf(weight) && weight > 0)
            throw std::invalid_argument("statistics: a weight is infinite");
}

void BaseTexels::normalise_heights(const std::vector<double>& heights,
                                   const std::optional<std::array<double, 2>>& given)
{
    /// Weighted mean of value(h) over the texels with data, summed row by row about the first.
    auto mean_of_heights = [&](auto value) {
        const auto begin =
            std::find_if(weights.begin(), weights.end(), [](double w) { return w > 0; });
        if (begin == weights.end())
            return 0.0;
        const double first = value(heights[static_cast<size_t>(begin - weights.begin())]);
        double weight = 0, sum = 0;
        for (int y = 0; y < height; ++y) {
            double row_weight = 0, row_sum = 0;
            for (int x = 0; x < width; ++x) {
                const size_t i = index(x, y);
                if (weights[i] > 0) {
                    row_weight += weights[i];
                    row_sum += weights[i] * (value(heights[i]) - first);
                }
            }
            weight += row_weight;
            sum += row_sum;
        }
        return first + sum / weight;
    };
    h0 = mean_of_heights([](double h) { return h; });
    const double deviation =
        std::sqrt(mean_of_heights([this](double h) { return (h - h0) * (h - h0); }));
    h1 = deviation > 0 ? deviation : 1;
    if (given) {
        h0 = (*given)[0];
        h1 = (*given)[1];
    }
    for (size_t i = 0; i < hn.size(); ++i)
        if (weights[i] > 0)
            hn[i] = (heights[i] - h0) / h1;
}

} // namespace scree::reference
