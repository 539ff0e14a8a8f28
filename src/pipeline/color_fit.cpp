#include "pipeline/color_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scree {

namespace {

/// Variance below this share of the mean square is what rounding leaves.
constexpr double kRounding = 1e-24;

/// det / trace^2 below which slopes vary along one line.
constexpr double kThin = 1e-12;

} // namespace

ColorFitStatistics::ColorFitStatistics(const MomentLayout& layout, int width, int height)
    : layout_(layout)
{
    for (int l = 0; l < level_count(width, height); ++l) {
        const int level_width = std::max(1, width >> l);
        blocks_.emplace_back(
            static_cast<size_t>((level_width + kBlockColumns - 1) / kBlockColumns));
    }
}

void ColorFitStatistics::Sums::add(const Sums& other)
{
    weight += other.weight;
    height_variance += other.height_variance;
    for (size_t c = 0; c < 3; ++c) {
        variance[c] += other.variance[c];
        by_height[c] += other.by_height[c];
        by_slope[c] += other.by_slope[c];
        with_height[c] += other.with_height[c];
    }
    for (size_t n = 0; n < by_rank.size(); ++n)
        by_rank[n] += other.by_rank[n];
}

void ColorFitStatistics::add_heights(MomentRow row, int count, Sums& sums) const
{
    const double* weight = row.plane(MomentLayout::weight);
    const double* variance = row.plane(layout_.height_var);
    for (int i = 0; i < count; ++i)
        sums.height_variance += weight[i] * variance[i];
    for (int c = 0; c < 3; ++c) {
        const double* covariance = row.plane(layout_.color_height + c);
        double explained = 0, together = 0;
        for (int i = 0; i < count; ++i) {
            together += weight[i] * covariance[i];
            explained += variance[i] > kRounding
                             ? weight[i] * (covariance[i] * covariance[i] / variance[i])
                             : 0;
        }
        sums.by_height[static_cast<size_t>(c)] += explained;
        sums.with_height[static_cast<size_t>(c)] += together;
    }
}

void ColorFitStatistics::add_slopes(MomentRow row, int count, Sums& sums) const
{
    const double* weight = row.plane(MomentLayout::weight);
    const double* ss = row.plane(layout_.slope_ss);
    const double* tt = row.plane(layout_.slope_tt);
    const double* st = row.plane(layout_.slope_st);
    for (int c = 0; c < 3; ++c) {
        const double* cs = row.plane(layout_.color_slope_s + c);
        const double* ct = row.plane(layout_.color_slope_t + c);
        double explained = 0;
        for (int i = 0; i < count; ++i) {
            const double trace = ss[i] + tt[i], det = ss[i] * tt[i] - st[i] * st[i];
            // On one line C is trace e e', and what covaries with it lies along e.
            const double line = (cs[i] * cs[i] + ct[i] * ct[i]) / (trace > 0 ? trace : 1);
            const double plane =
                (tt[i] * cs[i] * cs[i] - 2 * st[i] * cs[i] * ct[i] + ss[i] * ct[i] * ct[i]) /
                (det > 0 ? det : 1);
            explained += weight[i] * (det > kThin * trace * trace ? plane : line);
        }
        sums.by_slope[static_cast<size_t>(c)] += explained;
    }
}

void ColorFitStatistics::texels(int level, int /*y*/, int x0, int count, MomentRow row)
{
    Sums& sums = blocks_[static_cast<size_t>(level)][static_cast<size_t>(x0 / kBlockColumns)];
    const double* weight = row.plane(MomentLayout::weight);
    for (int i = 0; i < count; ++i)
        sums.weight += weight[i];
    for (int c = 0; c < 3; ++c) {
        const double* variance = row.plane(layout_.color_var + c);
        for (int i = 0; i < count; ++i)
            sums.variance[static_cast<size_t>(c)] += weight[i] * variance[i];
    }
    if (layout_.color_height >= 0)
        add_heights(row, count, sums);
    if (layout_.color_slope_s >= 0)
        add_slopes(row, count, sums);
    for (int n = 0; n < layout_.rank_terms; ++n)
        for (int c = 0; c < 3; ++c) {
            const double* a = row.plane(layout_.rank + 3 * n + c);
            double squares = 0;
            for (int i = 0; i < count; ++i)
                squares += weight[i] * a[i] * a[i];
            sums.by_rank[static_cast<size_t>(n)] += squares / (2 * n + 3);
        }
}

ColorFit ColorFitStatistics::fit_of(const Sums& sums) const
{
    auto total = [](const std::array<double, 3>& rgb) { return rgb[0] + rgb[1] + rgb[2]; };
    const double variance = total(sums.variance);
    double best = 0;
    // Not above 1: rounding, and where the slope varies inside a level-0 texel but not its color.
    auto share = [&](double explained) {
        const double r2 = std::min(1.0, explained / variance);
        best = std::max(best, r2);
        return r2;
    };
    auto correlation = [&](auto explained) {
        std::array<double, 3> rgb{};
        for (size_t c = 0; c < 3; ++c)
            rgb[c] = sums.variance[c] > 0 ? explained(c) : 0;
        return rgb;
    };
    ColorFit fit;
    fit.sigma = std::sqrt(variance / (3 * sums.weight));
    if (layout_.color_height >= 0) {
        fit.height = share(total(sums.by_height));
        fit.height_correlation = correlation([&](size_t c) {
            const double product = sums.variance[c] * sums.height_variance;
            return product > 0 ? std::clamp(sums.with_height[c] / std::sqrt(product), -1.0, 1.0)
                               : 0;
        });
    }
    if (layout_.color_slope_s >= 0) {
        fit.slope = share(total(sums.by_slope));
        fit.slope_correlation = correlation([&](size_t c) {
            return std::sqrt(std::min(1.0, sums.by_slope[c] / sums.variance[c]));
        });
    }
    auto by_rank = [&](int terms) -> std::optional<double> {
        if (layout_.rank_terms < terms)
            return std::nullopt;
        return share(std::accumulate(sums.by_rank.begin(), sums.by_rank.begin() + terms, 0.0));
    };
    fit.rank1 = by_rank(1);
    fit.rank2 = by_rank(2);
    fit.rank4 = by_rank(4);
    fit.residual = fit.sigma * std::sqrt(1 - best);
    return fit;
}

std::vector<std::optional<ColorFit>> ColorFitStatistics::fits() const
{
    std::vector<std::optional<ColorFit>> fits;
    for (const auto& blocks : blocks_) {
        Sums sums;
        for (const Sums& block : blocks)
            sums.add(block);
        const double variance = sums.variance[0] + sums.variance[1] + sums.variance[2];
        fits.push_back(variance > 0 ? std::optional(fit_of(sums)) : std::nullopt);
    }
    return fits;
}

} // namespace scree
