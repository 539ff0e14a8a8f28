#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "reference/rank_terms.h"
#include "reference/relief.h"
#include "reference/slope_points.h"

namespace scree::reference {

/// What the statistics are of.
///
/// A texel is no data when its height, one of its color channels or one of its slopes is NaN or
/// infinite, or when its weight is NaN or <= 0.
struct StatisticsInput {
    Relief relief; ///< without colors their statistics are 0; without heights there are `slopes`
    std::vector<std::array<double, 2>> slopes; ///< (s, t) of a normal map; empty: from the heights
    Reconstruction reconstruction = Reconstruction::bilinear;
    std::optional<std::array<double, 2>> h0_h1; ///< of a tile: its set's; absent: found
};

/// What lies in the footprint of one texel; all zero where coverage is 0.
struct Texel {
    double coverage = 0;                  ///< weight / weight if all own weights were 1
    std::array<double, 2> mean_slope{};   ///< s, t
    std::array<double, 3> cov_slope{};    ///< ss, tt, st; central, as all that follow
    std::array<double, 4> third_slope{};  ///< sss, sst, stt, ttt
    std::array<double, 5> fourth_slope{}; ///< ssss, ssst, sstt, sttt, tttt
    double mean_hn = 0;                   ///< of hn = (h - h0) / h1
    double var_hn = 0;
    Rgb mean_color{};
    Rgb var_color{};
    Rgb cov_color_hn{};
    Rgb cov_color_s{}, cov_color_t{};
    double kurtosis = 0; ///< Mardia's E[(d' C^-1 d)^2], d = slope - mean; 8 for a Gaussian.
                         ///< C thin (det <= 1e-6 trace^2): 8 k1 / 3 with k1 the kurtosis along the
                         ///< principal axis; trace 0: 0
    double tau = 0;      ///< clamp((kurtosis - 8) / 8, 0, 1): 0 Gaussian, 1 K0
    RankTerms rank{};
};

/// The statistics of a texture set, straight from their definitions: every texel of every MIP level
/// is summed from the level-0 texels under it, nothing is merged from the level above, slopes are
/// summed point by point, heights are sorted anew.
///
/// Sums are in double, mean first and central sums second, row by row of the footprint, so that
/// rounding grows with its side. Nothing is kept but the inputs; statistics are made when asked
/// for.
///
/// error  rounding, about 1e-15 times the side of the footprint. Equal values have exactly their
///        value for mean, and variance 0; but where the true covariance is 0 and the inputs are
///        rounded (a plane of slope 0.1), kurtosis and tau are those of the rounding errors:
///        compare them only where the trace is well above (1e-16 max|h| / d)^2, d the texel's
///        smaller side.
class Statistics {
public:
    /// rank_terms  how many to make, 0 to kMaxRankTerms
    /// Throws std::invalid_argument for grids of the wrong size, sizes <= 0, an infinite weight.
    explicit Statistics(const StatisticsInput& input, int rank_terms = 0);
    ~Statistics();
    Statistics(Statistics&&) noexcept;

    /// As given, or weighted mean height of the texels with data, world units.
    [[nodiscard]] double h0() const;
    /// As given, or their population standard deviation; 1 if all are equal.
    [[nodiscard]] double h1() const;
    [[nodiscard]] size_t valid_texels() const; ///< of level 0: those with data

    /// Sizes max(1, floor(n / 2)) from level to level, down to 1x1.
    [[nodiscard]] int levels() const;
    [[nodiscard]] int width(int level) const;
    [[nodiscard]] int height(int level) const;

    [[nodiscard]] Texel at(int level, int x, int y) const;

    /// Rows [first, first + count) of a level, count x width, on all cores.
    [[nodiscard]] std::vector<Texel> rows(int level, int first, int count) const;

private:
    struct Base;
    std::unique_ptr<const Base> base_;
};

} // namespace scree::reference
