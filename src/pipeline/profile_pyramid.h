#pragma once

#include <deque>
#include <vector>

#include "stats/rank_rows.h"

namespace scree {

/// Rank profiles of every level, kept as long as the next level needs them.
///
/// Goes along with MomentPyramid, which makes the rows of a level in order, blocks of a row on
/// several threads. A row of level l holds as many atoms as 2^l rows of texels, up to
/// kExactLevels; at most two or three rows a level are kept, and a batch of the finest.
class ProfilePyramid {
public:
    ProfilePyramid(const MomentLayout& layout, int width, int height);

    /// Rows [begin, end) of a level come next. One thread.
    void rows_begin(int level, int begin, int end);

    /// Makes `count` texels of a row from column x0 on, one of the row's blocks, and puts their
    /// coefficients into `moments`, which at level 0 has their weight, height and color.
    ///
    /// moments  at column x0
    /// returns  the row, to be asked for these columns, until rows_end()
    const ProfileRow& make(int level, int y, int x0, int count, MomentRow moments);

    /// They are made: what no later row needs is let go of. One thread.
    void rows_end(int level, int end);

private:
    struct Level {
        int width, height;
        int run_texels;
        std::deque<ProfileRow> rows;
        int first_row = 0;             ///< number of rows.front()
        std::vector<ProfileRow> spare; ///< rows let go of; their memory is used again

        ProfileRow& row(int y) { return rows[static_cast<size_t>(y - first_row)]; }
        void forget_below(int y);
    };

    void make_run(int level, int y, int x0, int x1, MomentRow moments);

    MomentLayout layout_;
    std::vector<Level> levels_;
    std::vector<RankReduction> reductions_; ///< [l] makes level l + 1
};

} // namespace scree
