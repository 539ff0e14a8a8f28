#include "pipeline/level_statistics.h"

#include <algorithm>
#include <cmath>

#include "stats/kurtosis.h"

namespace scree {

LevelStatistics::LevelStatistics(const MomentLayout& layout, int width, int height, double h1)
    : layout_(layout), width_(width), height_(height), h1_(h1)
{
    for (int l = 0; l < level_count(width, height); ++l) {
        Sums empty;
        empty.planes.assign(static_cast<size_t>(layout.planes), 0.0);
        const int level_width = std::max(1, width >> l);
        blocks_.emplace_back(static_cast<size_t>((level_width + kBlockColumns - 1) / kBlockColumns),
                             empty);
    }
}

namespace {

/// sum w_i v_i, in eight running sums that the compiler keeps in vector registers.
[[gnu::target_clones("avx2", "default")]] double weighted_sum(const double* w, const double* v,
                                                              int count)
{
    constexpr int kLanes = 8;
    double sums[kLanes] = {};
    int i = 0;
    for (; i + kLanes <= count; i += kLanes)
        for (int lane = 0; lane < kLanes; ++lane)
            sums[lane] += w[i + lane] * v[i + lane];
    for (; i < count; ++i)
        sums[0] += w[i] * v[i];
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) +
           ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

} // namespace

void LevelStatistics::texels(int level, int /*y*/, int x0, int count, MomentRow row)
{
    auto& blocks = blocks_[static_cast<size_t>(level)];
    Sums& sums = blocks[static_cast<size_t>(x0 / kBlockColumns)];
    const double* weight = row.plane(MomentLayout::weight);
    sums.texels += count;
    for (int i = 0; i < count; ++i)
        sums.weight += weight[i];
    const int last_summed = layout_.slope_tail >= 0 ? layout_.slope_tail : layout_.merged_planes;
    for (int plane = 1; plane < last_summed; ++plane) {
        sums.planes[static_cast<size_t>(plane)] += weighted_sum(weight, row.plane(plane), count);
    }
    if (layout_.slope_s >= 0) {
        const double* s = row.plane(layout_.slope_s);
        const double* t = row.plane(layout_.slope_t);
        double squares[kBlockColumns];
        for (int i = 0; i < count; ++i)
            squares[i] = s[i] * s[i] + t[i] * t[i];
        sums.mean_square += weighted_sum(weight, squares, count);
        for (int i = 0; i < count; ++i) { // without data they are 0
            sums.steepest_s = std::max(sums.steepest_s, std::abs(s[i]));
            sums.steepest_t = std::max(sums.steepest_t, std::abs(t[i]));
        }
    }
    if (layout_.slope_tail >= 0)
        for (int i = 0; i < count; ++i) {
            const Tail tail = tail_of(layout_, row, i);
            const double varies = tail.kurtosis > 0 ? weight[i] : 0;
            sums.slope_weight += varies;
            sums.kurtosis += varies * tail.kurtosis;
            sums.tau += varies * tail.tau;
        }
}

LevelStatistics::Sums LevelStatistics::total(const std::vector<Sums>& blocks) const
{
    Sums total = blocks.front();
    for (size_t b = 1; b < blocks.size(); ++b) {
        total.weight += blocks[b].weight;
        total.texels += blocks[b].texels;
        total.slope_weight += blocks[b].slope_weight;
        total.kurtosis += blocks[b].kurtosis;
        total.tau += blocks[b].tau;
        total.mean_square += blocks[b].mean_square;
        total.steepest_s = std::max(total.steepest_s, blocks[b].steepest_s);
        total.steepest_t = std::max(total.steepest_t, blocks[b].steepest_t);
        for (size_t p = 0; p < total.planes.size(); ++p)
            total.planes[p] += blocks[b].planes[p];
    }
    return total;
}

std::vector<LevelSummary> LevelStatistics::summaries() const
{
    std::vector<LevelSummary> levels;
    for (size_t l = 0; l < blocks_.size(); ++l) {
        const Sums sums = total(blocks_[l]);
        auto mean = [&sums](int plane) {
            return sums.planes[static_cast<size_t>(plane)] / sums.weight;
        };
        LevelSummary level;
        level.width = std::max(1, width_ >> l);
        level.height = std::max(1, height_ >> l);
        level.coverage = sums.weight / sums.texels;
        if (layout_.slope_s >= 0) {
            const double inside = mean(layout_.slope_ss) + mean(layout_.slope_tt);
            level.mean_slope = {mean(layout_.slope_s), mean(layout_.slope_t)};
            level.steepest = {sums.steepest_s, sums.steepest_t};
            level.rms_slope = std::sqrt(sums.mean_square / sums.weight + inside);
            level.slope_sigma = std::sqrt(inside);
        }
        if (layout_.slope_tail >= 0 && sums.slope_weight > 0) {
            level.kurtosis = sums.kurtosis / sums.slope_weight;
            level.tau = sums.tau / sums.slope_weight;
        }
        if (layout_.height >= 0)
            level.height_sigma = std::sqrt(mean(layout_.height_var)) * h1_;
        if (layout_.color >= 0)
            level.mean_color = {mean(layout_.color), mean(layout_.color + 1),
                                mean(layout_.color + 2)};
        levels.push_back(level);
    }
    return levels;
}

} // namespace scree
