#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stats/moment_layout.h"
#include "stats/pyramid.h"
#include "stats/ranks.h"

namespace scree {

/// Profiles of some texels of a row, side by side, made from left to right.
class ProfileRun {
public:
    /// Forgets all texels; their memory stays.
    void clear();
    /// The next texel's profile.
    void append(const RankProfile& profile);

    /// texel  counted from the first of the run
    [[nodiscard]] RankProfile at(int texel) const;

private:
    std::vector<RankAtom> atoms_;
    std::vector<uint32_t> ends_; ///< of the texels' atoms in atoms_
};

/// Rank profiles of one row of texels, in runs of equal length so that several threads can make it.
struct ProfileRow {
    int run_texels = 0;
    std::vector<ProfileRun> runs;

    [[nodiscard]] RankProfile at(int x) const
    {
        return runs[static_cast<size_t>(x / run_texels)].at(x % run_texels);
    }
};

/// Footprints up to 64x64 texels keep all their atoms; coarser ones are made of summaries.
constexpr int kExactLevels = 6;
/// Atoms of a summary, see summarise(); its error is measured in tests/stats/ranks_test.cpp.
constexpr int kSummaryAtoms = 512;

/// Rank profiles of one MIP level, and the coefficients of its tables, from the level above it.
class RankReduction {
public:
    /// fine_level  of the rows it is made from, 0 the finest
    RankReduction(int fine_level, int fine_width, int coarse_width);

    /// Coarse texels of one run.
    ///
    /// fine_rows  the `rows.count` rows that `rows` names
    /// rows       their shares, from share_of() along t
    /// x0, x1     columns of the run
    /// coarse     gets their profiles; summaries from kExactLevels on
    /// layout     where in `moments` (at texel x0) the coefficients go
    void run(const ProfileRow* const* fine_rows, const Share& rows, int x0, int x1,
             ProfileRun& coarse, const MomentLayout& layout, MomentRow moments) const;

private:
    int coarse_level_;
    std::vector<Share> columns_;
};

/// Profiles of level-0 texels, one atom each or none without data; their coefficients are 0.
///
/// moments  a run of texels with weight, height and color
void texel_profiles(const MomentLayout& layout, MomentRow moments, int count, ProfileRun& run);

} // namespace scree
