#include "stats/plane_means.h"

#include <algorithm>

namespace scree {

namespace {

constexpr int kRun = kMergeRun / 3; // coarse texels, so that 3 kRun fine ones fit a run

using FineRun = double[kMergeRun];
using CoarseRun = double[kRun];

/// Shares times weights of the fine rows.
[[gnu::target_clones("avx2", "default")]] void weigh(const double* weight, double share, int count,
                                                     double* weighed)
{
    for (int x = 0; x < count; ++x)
        weighed[x] = share * weight[x];
}

[[gnu::target_clones("avx2", "default")]] void add_products(const double* a, const double* b,
                                                            int count, double* sum)
{
    for (int x = 0; x < count; ++x)
        sum[x] += a[x] * b[x];
}

/// Sums over the columns of coarse texels: at most three fine ones each.
void gather(const double* fine, const Share* columns, int fine_begin, int count, double* coarse)
{
    for (int x = 0; x < count; ++x) {
        const Share& share = columns[x];
        const double* from = fine + (share.first - fine_begin);
        double sum = share.parts[0] * from[0];
        for (int k = 1; k < share.count; ++k)
            sum += share.parts[k] * from[k];
        coarse[x] = sum;
    }
}

/// Adds weighed v to sums[0], weighed v times colors[c] to sums[1 + c].
[[gnu::target_clones("avx2", "default")]] void add_seen(const double* weighed, const float* seen,
                                                        const double* const* colors, int count,
                                                        FineRun* sums)
{
    for (int x = 0; x < count; ++x)
        sums[0][x] += weighed[x] * static_cast<double>(seen[x]);
    for (int c = 0; c < 3; ++c) {
        const double* color = colors[c];
        double* sum = sums[1 + c];
        for (int x = 0; x < count; ++x)
            sum[x] += weighed[x] * (static_cast<double>(seen[x]) * color[x]);
    }
}

/// Up to kRun coarse texels of a row: what weighs in them.
struct CoarseTexels {
    CoarseTexels(const MomentRow* fine_rows, const Share& rows, const Share* of_run, int texels)
        : columns(of_run), run(texels), fine_begin(of_run[0].first),
          fine_count(of_run[run - 1].first + of_run[run - 1].count - fine_begin)
    {
        FineRun sum;
        std::fill_n(sum, fine_count, 0.0);
        for (int k = 0; k < rows.count; ++k) {
            weigh(fine_rows[k].plane(MomentLayout::weight) + fine_begin, rows.parts[k], fine_count,
                  weighed[k]);
            for (int x = 0; x < fine_count; ++x)
                sum[x] += weighed[k][x];
        }
        gather(sum, columns, fine_begin, run, per_weight);
        for (int x = 0; x < run; ++x)
            per_weight[x] = per_weight[x] > 0 ? 1 / per_weight[x] : 0;
    }

    /// Means of what was summed up over the fine rows.
    void finish(const double* sum, double* out) const
    {
        gather(sum, columns, fine_begin, run, out);
        for (int x = 0; x < run; ++x)
            out[x] *= per_weight[x];
    }

    const Share* columns;
    int run, fine_begin, fine_count;
    FineRun weighed[3]; ///< fine row by fine row
    CoarseRun per_weight;
};

} // namespace

void mean_planes(int first, int count, const MomentRow* fine_rows, const Share& rows,
                 const Share* columns, int x0, int x1, MomentRow coarse)
{
    if (count == 0)
        return;
    FineRun sum;
    for (int begin = x0; begin < x1; begin += kRun) {
        const CoarseTexels texels(fine_rows, rows, columns + begin, std::min(kRun, x1 - begin));
        for (int plane = first; plane < first + count; ++plane) {
            std::fill_n(sum, texels.fine_count, 0.0);
            for (int k = 0; k < rows.count; ++k)
                add_products(texels.weighed[k], fine_rows[k].plane(plane) + texels.fine_begin,
                             texels.fine_count, sum);
            texels.finish(sum, coarse.plane(plane) + begin);
        }
    }
}

void mean_seen(const MomentLayout& layout, const MomentRow* fine_rows, const Share& rows,
               const Share* columns, int x0, int x1, MomentRow coarse)
{
    constexpr int kSums = MomentLayout::kVisiblePlanes;
    FineRun sums[kSums];
    for (int begin = x0; begin < x1; begin += kRun) {
        const CoarseTexels texels(fine_rows, rows, columns + begin, std::min(kRun, x1 - begin));
        for (int component = 0; component < layout.seen_components(); ++component) {
            for (FineRun& sum : sums)
                std::fill_n(sum, texels.fine_count, 0.0);
            for (int k = 0; k < rows.count; ++k) {
                const MomentRow fine = fine_rows[k].from(texels.fine_begin);
                const double* const colors[] = {fine.plane(layout.color + 2), // B G R
                                                fine.plane(layout.color + 1),
                                                fine.plane(layout.color)};
                add_seen(texels.weighed[k], fine.seen_of(component), colors, texels.fine_count,
                         sums);
            }
            for (int i = 0; i < kSums; ++i)
                texels.finish(sums[i],
                              coarse.plane(layout.texel_planes + kSums * component + i) + begin);
        }
    }
}

} // namespace scree
