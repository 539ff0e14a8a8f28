#pragma once

#include "stats/merge.h"

#include <vector>

namespace scree {

/// Sizes of the MIP levels of an axis: max(1, floor(n / 2)) from level to level.
int coarser_size(int size);

/// Number of levels down to 1x1.
int level_count(int width, int height);

/// The fine texels under one coarse texel along an axis, and the part of it that each covers.
///
/// Coarse texel j of m covers [j n/m, (j+1) n/m) of the n fine texels: two halves when n = 2m,
/// three with fractional shares when n = 2m + 1, the one when n = m = 1. The shares are computed
/// from exact integers and sum to 1.
struct Share {
    int first;       ///< first fine texel
    int count;       ///< 1 to 3
    double parts[3]; ///< of the coarse texel's width
};
Share share_of(int coarse, int fine_size, int coarse_size);

/// Rows of one MIP level made from rows of the level above it.
class Reduction {
public:
    Reduction(const MomentLayout& layout, int fine_width, int coarse_width);

    /// Coarse texels [x0, x1) of one row.
    ///
    /// fine_rows  the `rows.count` rows that `rows` names, whole
    /// rows       their shares, from share_of() along t
    /// coarse     the whole coarse row
    void row(const MomentRow* fine_rows, const Share& rows, int x0, int x1, MomentRow coarse) const;

private:
    MomentLayout layout_;
    std::vector<Share> columns_;
};

} // namespace scree
