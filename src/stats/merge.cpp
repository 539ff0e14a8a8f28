#include "stats/merge.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace scree {

namespace {

constexpr int kMaxParts = 3;
constexpr int kMaxMeans = 6;

using Run = double[kMergeRun];

/// d_k of every part and mean, and p_k / w of every part.
struct Scratch {
    Run part[kMaxParts];
    Run offset[kMaxMeans][kMaxParts];
};

// The clones give the same numbers on every machine: no fused multiply-add.

[[gnu::target_clones("avx2", "default")]] void
merge_weights(const MergePart* parts, int part_count, double* weight, int count, Scratch& tmp)
{
    for (int x = 0; x < count; ++x)
        weight[x] = 0;
    for (int k = 0; k < part_count; ++k) {
        const double* share = parts[k].shares;
        const double* w = parts[k].row.plane(MomentLayout::weight);
        for (int x = 0; x < count; ++x) {
            tmp.part[k][x] = share[x] * w[x];
            weight[x] += tmp.part[k][x];
        }
    }
    for (int k = 0; k < part_count; ++k)
        for (int x = 0; x < count; ++x)
            tmp.part[k][x] /= weight[x] > 0 ? weight[x] : 1;
}

[[gnu::target_clones("avx2", "default")]] void merge_mean(const MergePart* parts, int part_count,
                                                          int plane, double* mean, int count,
                                                          const Scratch& tmp, Run* offset)
{
    const double* first = parts[0].row.plane(plane);
    for (int x = 0; x < count; ++x)
        mean[x] = first[x];
    for (int k = 1; k < part_count; ++k) {
        const double* other = parts[k].row.plane(plane);
        for (int x = 0; x < count; ++x)
            mean[x] += tmp.part[k][x] * (other[x] - first[x]);
    }
    for (int k = 0; k < part_count; ++k) {
        const double* other = parts[k].row.plane(plane);
        for (int x = 0; x < count; ++x)
            offset[k][x] = other[x] - mean[x];
    }
}

[[gnu::target_clones("avx2", "default")]] void
merge_covariance(const MergePart* parts, int part_count, int plane, const Run* a, const Run* b,
                 double* covariance, int count, const Scratch& tmp)
{
    for (int x = 0; x < count; ++x)
        covariance[x] = 0;
    for (int k = 0; k < part_count; ++k) {
        const double* inner = parts[k].row.plane(plane);
        for (int x = 0; x < count; ++x)
            covariance[x] += tmp.part[k][x] * (inner[x] + a[k][x] * b[k][x]);
    }
}

/// Third and fourth central moments of the slope (s, t), with `a` and `b` the offsets of its means.
[[gnu::target_clones("avx2", "default")]] void
merge_tail(const MomentLayout& layout, const MergePart* parts, int part_count, const Run* a,
           const Run* b, MomentRow merged, int count, const Scratch& tmp)
{
    Run out[MomentLayout::kTailPlanes] = {};
    for (int k = 0; k < part_count; ++k) {
        const MomentRow& row = parts[k].row;
        const double* ss = row.plane(layout.slope_ss);
        const double* tt = row.plane(layout.slope_tt);
        const double* st = row.plane(layout.slope_st);
        const double *sss = row.plane(layout.slope_tail), *sst = row.plane(layout.slope_tail + 1),
                     *stt = row.plane(layout.slope_tail + 2),
                     *ttt = row.plane(layout.slope_tail + 3),
                     *ssss = row.plane(layout.slope_tail + 4),
                     *ssst = row.plane(layout.slope_tail + 5),
                     *sstt = row.plane(layout.slope_tail + 6),
                     *sttt = row.plane(layout.slope_tail + 7),
                     *tttt = row.plane(layout.slope_tail + 8);
        for (int x = 0; x < count; ++x) {
            const double p = tmp.part[k][x];
            const double u = a[k][x];
            const double v = b[k][x];
            const double c20 = ss[x], c11 = st[x], c02 = tt[x];
            const double c30 = sss[x], c21 = sst[x], c12 = stt[x], c03 = ttt[x];
            out[0][x] += p * (c30 + 3 * u * c20 + u * u * u);
            out[1][x] += p * (c21 + 2 * u * c11 + v * c20 + u * u * v);
            out[2][x] += p * (c12 + 2 * v * c11 + u * c02 + u * v * v);
            out[3][x] += p * (c03 + 3 * v * c02 + v * v * v);
            out[4][x] += p * (ssss[x] + 4 * u * c30 + 6 * u * u * c20 + u * u * u * u);
            out[5][x] += p * (ssst[x] + 3 * u * c21 + v * c30 + 3 * u * u * c11 + 3 * u * v * c20 +
                              u * u * u * v);
            out[6][x] += p * (sstt[x] + 2 * v * c21 + 2 * u * c12 + v * v * c20 + 4 * u * v * c11 +
                              u * u * c02 + u * u * v * v);
            out[7][x] += p * (sttt[x] + 3 * v * c12 + u * c03 + 3 * v * v * c11 + 3 * u * v * c02 +
                              u * v * v * v);
            out[8][x] += p * (tttt[x] + 4 * v * c03 + 6 * v * v * c02 + v * v * v * v);
        }
    }
    for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
        std::copy_n(out[i], count, merged.plane(layout.slope_tail + i));
}

} // namespace

void merge(const MomentLayout& layout, const MergePart* parts, int part_count, MomentRow merged,
           int count)
{
    assert(part_count >= 1 && part_count <= kMaxParts && count <= kMergeRun);
    assert(layout.means.size() <= kMaxMeans);

    Scratch tmp;
    merge_weights(parts, part_count, merged.plane(MomentLayout::weight), count, tmp);
    for (size_t i = 0; i < layout.means.size(); ++i)
        merge_mean(parts, part_count, layout.means[i], merged.plane(layout.means[i]), count, tmp,
                   tmp.offset[i]);
    for (const auto& c : layout.covariances)
        merge_covariance(parts, part_count, c.plane, tmp.offset[c.a], tmp.offset[c.b],
                         merged.plane(c.plane), count, tmp);
    if (layout.slope_tail >= 0)
        merge_tail(layout, parts, part_count, tmp.offset[0], tmp.offset[1], merged, count, tmp);
}

} // namespace scree
