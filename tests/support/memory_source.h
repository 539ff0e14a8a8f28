#pragma once

#include "pipeline/source.h"
#include "reference/statistics.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::test {

/// A surface held in memory, handed out row by row.
///
/// heights or slopes (one of them), colors and weights as in reference::StatisticsInput; a texel
/// without data is marked as a Source marks it.
class MemorySource : public Source {
public:
    int map_width = 0, map_height = 0;
    std::vector<double> heights;
    std::vector<std::array<double, 2>> slopes;
    std::vector<std::array<double, 3>> colors;
    std::vector<float> weights;

    /// The same for brute force: texels of size 1, periodic.
    reference::StatisticsInput statistics_input() const
    {
        reference::StatisticsInput input;
        input.relief.width = map_width;
        input.relief.height = map_height;
        input.relief.heights = heights;
        input.relief.colors = colors;
        input.relief.weights = weights;
        input.slopes = slopes;
        return input;
    }

    std::string name() const override { return "memory"; }
    int width() const override { return map_width; }
    int height() const override { return map_height; }
    bool has_heights() const override { return slopes.empty(); }
    bool has_color() const override { return !colors.empty(); }
    void rewind(bool /*last_time*/) override { next_ = 0; }

    void read(int count, SurfaceRows& rows) override
    {
        rows = {};
        const auto end = next_ + static_cast<size_t>(count) * static_cast<size_t>(map_width);
        for (; next_ < end; ++next_) {
            bool valid = slopes.empty() ? std::isfinite(heights[next_])
                                        : std::isfinite(slopes[next_][0] + slopes[next_][1]);
            if (!colors.empty())
                for (const double c : colors[next_]) {
                    rows.color.push_back(static_cast<float>(c));
                    valid = valid && std::isfinite(c);
                }
            if (!weights.empty()) {
                rows.weight.push_back(weights[next_]);
                valid = valid && weights[next_] > 0;
            }
            const double nan = std::numeric_limits<double>::quiet_NaN();
            if (slopes.empty()) {
                rows.height.push_back(valid ? heights[next_] : nan);
            } else {
                rows.slope_s.push_back(valid ? slopes[next_][0] : nan);
                rows.slope_t.push_back(valid ? slopes[next_][1] : nan);
            }
        }
    }

    const Rejects& rejects() const override { return rejects_; }

private:
    size_t next_ = 0;
    Rejects rejects_;
};

} // namespace scree::test
