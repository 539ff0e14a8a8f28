#include "pipeline/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/error.h"

namespace scree {

namespace {

/// Weight, mean and sum of squared deviations, merged.
struct Running {
    double weight = 0, mean = 0, squares = 0;

    void merge(const Running& other)
    {
        const double total = weight + other.weight;
        if (!(total > 0))
            return;
        const double offset = other.mean - mean;
        mean += offset * (other.weight / total);
        squares += other.squares + offset * offset * weight * (other.weight / total);
        weight = total;
    }
};

struct HeightStatistics {
    Running sum;
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();

    void add_row(const double* height, const float* weight, int width)
    {
        // Two loops a row: its mean, then deviations from it. NaN (no data) compares false.
        double total = 0, first = 0;
        for (int x = 0; x < width; ++x) {
            const bool valid = height[x] == height[x];
            const double w = valid ? (weight != nullptr ? static_cast<double>(weight[x]) : 1) : 0;
            const double h = valid ? height[x] : 0;
            total += w;
            first += w * h;
            min = valid && height[x] < min ? height[x] : min;
            max = valid && height[x] > max ? height[x] : max;
        }
        if (!(total > 0))
            return;
        Running row{total, first / total, 0};
        for (int x = 0; x < width; ++x) {
            const bool valid = height[x] == height[x];
            const double w = valid ? (weight != nullptr ? static_cast<double>(weight[x]) : 1) : 0;
            const double d = valid ? height[x] - row.mean : 0;
            row.squares += w * d * d;
        }
        sum.merge(row);
    }
};

} // namespace

Survey survey(Source& source, const BakeMonitor& monitor)
{
    const int width = source.width(), height = source.height();
    Survey result;
    HeightStatistics heights;
    std::array<double, 3> color_sum{};
    SurfaceRows rows;

    source.rewind();
    for (int y0 = 0; y0 < height; y0 += kStripRows) {
        monitor.report("survey", static_cast<double>(y0) / height);
        const int count = std::min(kStripRows, height - y0);
        source.read(count, rows);
        for (int row = 0; row < count; ++row) {
            const auto begin = static_cast<size_t>(row) * static_cast<size_t>(width);
            const double* presence =
                source.has_heights() ? &rows.height[begin] : &rows.slope_s[begin];
            const float* weight = rows.weight.empty() ? nullptr : &rows.weight[begin];
            heights.add_row(presence, weight, width);
            for (int x = 0; x < width; ++x) {
                const bool valid = !std::isnan(presence[x]);
                result.no_data_texels += valid ? 0 : 1;
                result.complete = result.complete && valid && (weight == nullptr || weight[x] == 1);
                if (!valid || rows.color.empty())
                    continue;
                const double w = weight != nullptr ? static_cast<double>(weight[x]) : 1;
                for (size_t c = 0; c < 3; ++c)
                    color_sum[c] += w * static_cast<double>(
                                            rows.color[3 * (begin + static_cast<size_t>(x)) + c]);
            }
        }
        if (source.has_heights() && y0 == 0)
            result.first_row.assign(rows.height.begin(), rows.height.begin() + width);
        if (source.has_heights() && y0 + count == height)
            result.last_row.assign(rows.height.end() - width, rows.height.end());
    }
    result.rejects = source.rejects();
    result.weight = heights.sum.weight;
    if (!(result.weight > 0))
        throw Error("no texel of the map has data: all are not finite, turned away, transparent "
                    "or marked as no data");
    for (size_t c = 0; c < 3; ++c)
        result.mean_color[c] = static_cast<float>(color_sum[c] / result.weight);
    if (source.has_heights()) {
        result.h0 = heights.sum.mean;
        result.height_min = heights.min;
        result.height_max = heights.max;
        const double deviation = std::sqrt(heights.sum.squares / heights.sum.weight);
        result.h1 = deviation > 0 ? deviation : 1;
    }
    return result;
}

} // namespace scree
