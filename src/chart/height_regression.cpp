#include "chart/height_regression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "color/filtered_map.h"

namespace scree {

namespace {

constexpr size_t kBins = 256;
constexpr double kTolerance = 0.01; ///< of the table, as a share of its colors; that of a bake

struct Bin {
    double weight = 0, height = 0;
    Rgb color{};
};

double weight_at(const reference::Relief& relief, size_t i)
{
    if (!std::isfinite(relief.heights[i]))
        return 0;
    return relief.weights.empty() ? 1 : static_cast<double>(relief.weights[i]);
}

} // namespace

ColorMap color_by_height(const reference::Relief& relief, double h0, double h1)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (size_t i = 0; i < relief.heights.size(); ++i)
        if (weight_at(relief, i) > 0) {
            low = std::min(low, relief.heights[i]);
            high = std::max(high, relief.heights[i]);
        }
    std::array<Bin, kBins> bins;
    for (size_t i = 0; i < relief.heights.size(); ++i) {
        const double weight = weight_at(relief, i);
        if (!(weight > 0))
            continue;
        const double place = high > low ? (relief.heights[i] - low) / (high - low) : 0;
        Bin& bin = bins[std::min(static_cast<size_t>(place * kBins), kBins - 1)];
        bin.weight += weight;
        bin.height += weight * (relief.heights[i] - h0) / h1;
        for (size_t c = 0; c < 3; ++c)
            bin.color[c] += weight * relief.colors[i][c];
    }
    std::vector<Knot> knots;
    for (Bin& bin : bins) {
        if (bin.weight == 0)
            continue;
        for (double& c : bin.color)
            c /= bin.weight;
        knots.push_back({bin.height / bin.weight, bin.color});
    }
    return ColorMap(std::move(knots));
}

MapTable filtered_by_height(const ColorMap& map)
{
    return make_filtered_map(map, MapVariable::normal, map.first(), map.last(),
                             (map.last() - map.first()) / 2, kTolerance)
        .table;
}

} // namespace scree
