#pragma once

#include "stats/moment_layout.h"

namespace scree {

/// One of the texels side by side that a coarser texel is made of, for a run of coarse texels.
struct MergePart {
    MomentRow row;        ///< its moments, one entry a coarse texel
    const double* shares; ///< the part of the coarse texel's area it covers, in (0, 1]
};

/// Moments of the union of footprints, texel by texel along a run.
///
///   w = sum p_k,  p_k = share_k w_k
///   mean = sum p_k mean_k / w,  d_k = mean_k - mean
///   cov  = sum p_k (cov_k + d_k d_k') / w
/// and likewise for the central moments of order 3 and 4, expanded by the binomial theorem. Every
/// term of a variance is >= 0, so a variance cannot turn negative; means are summed as
/// differences from the first part, so equal means stay equal to the last bit.
///
/// parts   2 or 3 rows of `count` texels; for each texel the shares sum to 1
/// merged  row of `count` texels; where the weight is 0 the first part's means and no spread
/// source  Chan, Golub, LeVeque 1979 (order 2); Pebay 2008, eq. 2.9 (order 3 and 4)
void merge(const MomentLayout& layout, const MergePart* parts, int part_count, MomentRow merged,
           int count);

/// The longest run that merge() takes: short enough for its scratch to stay in the first cache.
constexpr int kMergeRun = 192;

} // namespace scree
