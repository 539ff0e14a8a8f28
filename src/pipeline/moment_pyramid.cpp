#include "pipeline/moment_pyramid.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace scree {

namespace {

/// Level-0 rows made at a time: enough work for every thread, few enough to stay in the cache.
constexpr int kBatchRows = 16;

/// A coarse row needs at most 3 fine rows, and shares one with the next.
constexpr int kRowsKept = 3;

} // namespace

MomentPyramid::MomentPyramid(const MomentLayout& layout, int width, int height,
                             std::vector<TexelVisitor*> visitors)
    : layout_(layout), visitors_(std::move(visitors))
{
    const int levels = level_count(width, height);
    for (int l = 0, w = width, h = height; l < levels; ++l) {
        const int capacity = std::min(h, kBatchRows + kRowsKept);
        levels_.push_back({w, h, 0, capacity, {}, {}});
        const size_t texels = static_cast<size_t>(capacity) * static_cast<size_t>(w);
        const int planes = l == 0 ? layout.texel_planes : layout.planes;
        levels_.back().data.resize(texels * static_cast<size_t>(planes));
        if (l == 0)
            levels_.back().seen.resize(texels * static_cast<size_t>(layout.seen_components()));
        const int next_w = coarser_size(w), next_h = coarser_size(h);
        if (l + 1 < levels)
            reductions_.emplace_back(layout, w, next_w);
        w = next_w;
        h = next_h;
    }
    if (layout.rank >= 0)
        profiles_.emplace(layout, width, height);
}

MomentRow MomentPyramid::row(Level& level, int y) const
{
    const size_t size = level.data.size() / static_cast<size_t>(level.capacity);
    const size_t seen_size = level.seen.size() / static_cast<size_t>(level.capacity);
    const auto slot = static_cast<size_t>(y % level.capacity);
    return {level.data.data() + slot * size, level.width,
            seen_size > 0 ? level.seen.data() + slot * seen_size : nullptr};
}

void MomentPyramid::push(int rows, const Fill& fill)
{
    for (int done = 0; done < rows; done += kBatchRows)
        push_batch(std::min(kBatchRows, rows - done), fill);
}

void MomentPyramid::push_batch(int rows, const Fill& fill)
{
    make(0, rows, fill);
    for (size_t l = 1; l < levels_.size(); ++l) {
        const Level& fine = levels_[l - 1];
        Level& coarse = levels_[l];
        int ready = 0;
        while (coarse.done + ready < coarse.height) {
            const Share share = share_of(coarse.done + ready, fine.height, coarse.height);
            if (share.first + share.count > fine.done)
                break;
            ++ready;
        }
        if (ready > 0)
            make(static_cast<int>(l), ready, fill);
    }
}

void MomentPyramid::make(int level, int rows, const Fill& fill)
{
    Level& own = levels_[static_cast<size_t>(level)];
    const int begin = own.done, end = own.done + rows;
    for (TexelVisitor* visitor : visitors_)
        visitor->rows_begin(level, begin, end);

    if (profiles_)
        profiles_->rows_begin(level, begin, end);
    const int blocks = (own.width + kBlockColumns - 1) / kBlockColumns;
    tbb::parallel_for(0, blocks, [&](int block) {
        for (int y = begin; y < end; ++y)
            make_run(level, y, block, fill);
    });
    own.done = end;
    if (profiles_)
        profiles_->rows_end(level, end);
    for (TexelVisitor* visitor : visitors_)
        visitor->rows_end(level, end);
}

void MomentPyramid::make_run(int level, int y, int block, const Fill& fill)
{
    Level& own = levels_[static_cast<size_t>(level)];
    const int x0 = block * kBlockColumns;
    const int count = std::min(kBlockColumns, own.width - x0);
    const MomentRow out = row(own, y);
    if (level == 0) {
        fill(y, x0, count, out.from(x0));
    } else {
        Level& fine = levels_[static_cast<size_t>(level) - 1];
        const Share share = share_of(y, fine.height, own.height);
        MomentRow fine_rows[3];
        for (int k = 0; k < share.count; ++k)
            fine_rows[k] = row(fine, share.first + k);
        reductions_[static_cast<size_t>(level) - 1].row(fine_rows, share, x0, x0 + count, out);
    }
    if (profiles_)
        profiles_->make(level, y, x0, count, out.from(x0));
    for (TexelVisitor* visitor : visitors_)
        visitor->texels(level, y, x0, count, out.from(x0));
}

} // namespace scree
