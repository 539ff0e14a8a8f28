#include "pipeline/profile_pyramid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace scree {

namespace {

/// Texels of a run, so that runs of coarse levels, whose texels are many atoms, are work for
/// several threads too. Divides kBlockColumns of pipeline/moment_pyramid.h.
int run_texels_of(int level) { return std::max(4, 256 >> level); }

} // namespace

ProfilePyramid::ProfilePyramid(const MomentLayout& layout, int width, int height) : layout_(layout)
{
    const int levels = level_count(width, height);
    for (int l = 0, w = width, h = height; l < levels; ++l) {
        levels_.push_back({w, h, run_texels_of(l), {}, 0, {}});
        const int next_w = coarser_size(w);
        if (l + 1 < levels)
            reductions_.emplace_back(l, w, next_w);
        w = next_w;
        h = coarser_size(h);
    }
}

void ProfilePyramid::Level::forget_below(int y)
{
    while (first_row < y) {
        spare.push_back(std::move(rows.front()));
        rows.pop_front();
        ++first_row;
    }
}

void ProfilePyramid::rows_begin(int level, int begin, int end)
{
    Level& own = levels_[static_cast<size_t>(level)];
    const int runs = (own.width + own.run_texels - 1) / own.run_texels;
    for (int y = begin; y < end; ++y) {
        if (own.spare.empty())
            own.spare.push_back(
                {own.run_texels, std::vector<ProfileRun>(static_cast<size_t>(runs))});
        own.rows.push_back(std::move(own.spare.back()));
        own.spare.pop_back();
    }
}

const ProfileRow& ProfilePyramid::make(int level, int y, int x0, int count, MomentRow moments)
{
    Level& own = levels_[static_cast<size_t>(level)];
    const int first = x0 / own.run_texels;
    const int end = (x0 + count - 1) / own.run_texels + 1;
    tbb::parallel_for(first, end, [&](int run) {
        const int begin = run * own.run_texels;
        make_run(level, y, begin, std::min(begin + own.run_texels, x0 + count),
                 moments.from(begin - x0));
    });
    return own.row(y);
}

void ProfilePyramid::make_run(int level, int y, int x0, int x1, MomentRow moments)
{
    Level& own = levels_[static_cast<size_t>(level)];
    ProfileRun& made = own.row(y).runs[static_cast<size_t>(x0 / own.run_texels)];
    if (level == 0) {
        texel_profiles(layout_, moments, x1 - x0, made);
        return;
    }
    Level& fine = levels_[static_cast<size_t>(level) - 1];
    const Share share = share_of(y, fine.height, own.height);
    const ProfileRow* fine_rows[3] = {};
    for (int k = 0; k < share.count; ++k)
        fine_rows[k] = &fine.row(share.first + k);
    reductions_[static_cast<size_t>(level) - 1].run(fine_rows, share, x0, x1, made, layout_,
                                                    moments);
}

void ProfilePyramid::rows_end(int level, int end)
{
    Level& own = levels_[static_cast<size_t>(level)];
    if (level > 0) {
        Level& fine = levels_[static_cast<size_t>(level) - 1];
        fine.forget_below(end < own.height ? share_of(end, fine.height, own.height).first
                                           : fine.height);
    }
    if (static_cast<size_t>(level) + 1 == levels_.size())
        own.forget_below(end);
}

} // namespace scree
