#include "stats/rank_rows.h"

#include <algorithm>
#include <cstddef>

namespace scree {

void ProfileRun::clear() { ends_.clear(); }

void ProfileRun::append(const RankProfile& profile)
{
    const size_t begin = ends_.empty() ? 0 : ends_.back();
    const size_t end = begin + static_cast<size_t>(profile.count);
    if (atoms_.size() < end)
        atoms_.resize(std::max(end, 2 * atoms_.size()));
    std::copy_n(profile.atoms, profile.count, atoms_.begin() + static_cast<ptrdiff_t>(begin));
    ends_.push_back(static_cast<uint32_t>(end));
}

RankProfile ProfileRun::at(int texel) const
{
    const auto i = static_cast<size_t>(texel);
    const uint32_t begin = i == 0 ? 0 : ends_[i - 1];
    return {atoms_.data() + begin, static_cast<int>(ends_[i] - begin)};
}

RankReduction::RankReduction(int fine_level, int fine_width, int coarse_width)
    : coarse_level_(fine_level + 1)
{
    columns_.reserve(static_cast<size_t>(coarse_width));
    for (int x = 0; x < coarse_width; ++x)
        columns_.push_back(share_of(x, fine_width, coarse_width));
}

void RankReduction::run(const ProfileRow* const* fine_rows, const Share& rows, int x0, int x1,
                        ProfileRun& coarse, const MomentLayout& layout, MomentRow moments) const
{
    const int terms = layout.rank_terms;
    thread_local ProfileMerger merger; // megabytes at coarse levels: kept from run to run
    thread_local std::vector<RankAtom> summary;
    double a[3 * kMaxRankTerms];
    coarse.clear();
    for (int x = x0; x < x1; ++x) {
        const Share& columns = columns_[static_cast<size_t>(x)];
        ProfilePart parts[9];
        int count = 0;
        for (int j = 0; j < rows.count; ++j)
            for (int i = 0; i < columns.count; ++i)
                parts[count++] = {fine_rows[j]->at(columns.first + i),
                                  static_cast<float>(rows.parts[j] * columns.parts[i])};
        RankProfile merged = merger.merge(parts, count);
        rank_coefficients(merged, terms, a);
        for (int i = 0; i < 3 * terms; ++i)
            moments.plane(layout.rank + i)[x - x0] = a[i];
        if (coarse_level_ >= kExactLevels && merged.count > kSummaryAtoms) {
            summarise(merged, kSummaryAtoms, summary);
            merged = {summary.data(), static_cast<int>(summary.size())};
        }
        coarse.append(merged);
    }
}

void texel_profiles(const MomentLayout& layout, MomentRow moments, int count, ProfileRun& run)
{
    const double* weight = moments.plane(MomentLayout::weight);
    const double* height = moments.plane(layout.height);
    run.clear();
    for (int x = 0; x < count; ++x) {
        RankAtom atom{height[x], static_cast<float>(weight[x]), {}};
        for (int c = 0; c < 3; ++c)
            atom.color[static_cast<size_t>(c)] =
                static_cast<float>(moments.plane(layout.color + c)[x]);
        run.append({&atom, weight[x] > 0 ? 1 : 0});
    }
    for (int i = 0; i < 3 * layout.rank_terms; ++i)
        std::fill_n(moments.plane(layout.rank + i), count, 0.0);
}

} // namespace scree
