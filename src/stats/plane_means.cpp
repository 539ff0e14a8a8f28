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

} // namespace

void mean_planes(int first, int count, const MomentRow* fine_rows, const Share& rows,
                 const Share* columns, int x0, int x1, MomentRow coarse)
{
    FineRun weighed[3];
    FineRun sum;
    CoarseRun per_weight;
    if (count == 0)
        return;
    for (int begin = x0; begin < x1; begin += kRun) {
        const int run = std::min(kRun, x1 - begin);
        const Share* of_run = columns + begin;
        const int fine_begin = of_run[0].first;
        const int fine_count = of_run[run - 1].first + of_run[run - 1].count - fine_begin;

        std::fill_n(sum, fine_count, 0.0);
        for (int k = 0; k < rows.count; ++k) {
            weigh(fine_rows[k].plane(MomentLayout::weight) + fine_begin, rows.parts[k], fine_count,
                  weighed[k]);
            for (int x = 0; x < fine_count; ++x)
                sum[x] += weighed[k][x];
        }
        gather(sum, of_run, fine_begin, run, per_weight);
        for (int x = 0; x < run; ++x)
            per_weight[x] = per_weight[x] > 0 ? 1 / per_weight[x] : 0;

        for (int plane = first; plane < first + count; ++plane) {
            std::fill_n(sum, fine_count, 0.0);
            for (int k = 0; k < rows.count; ++k)
                add_products(weighed[k], fine_rows[k].plane(plane) + fine_begin, fine_count, sum);
            double* out = coarse.plane(plane) + begin;
            gather(sum, of_run, fine_begin, run, out);
            for (int x = 0; x < run; ++x)
                out[x] *= per_weight[x];
        }
    }
}

} // namespace scree
