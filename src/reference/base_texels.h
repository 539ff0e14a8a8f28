#pragma once

#include <optional>

#include "reference/statistics.h"

namespace scree::reference {

/// Level 0, as the footprints of all levels are summed from it; grids are height x width.
struct BaseTexels {
    /// Throws std::invalid_argument as Statistics does.
    explicit BaseTexels(const StatisticsInput& input);

    [[nodiscard]] size_t index(int x, int y) const
    {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
    /// Slopes inside a texel with data.
    [[nodiscard]] SlopePoints slopes(int x, int y) const;

    int width, height;
    std::vector<double> weights; ///< 0: no data, and the rest is 0
    std::vector<std::array<double, 2>> mean_slopes;
    std::vector<double> hn;
    std::vector<Rgb> colors;
    double h0 = 0, h1 = 1;
    size_t valid = 0;

private:
    void check(const StatisticsInput& input) const;
    void normalise_heights(const std::vector<double>& heights,
                           const std::optional<std::array<double, 2>>& given);

    std::optional<HeightGrid> heights_; ///< absent for a normal map
};

} // namespace scree::reference
