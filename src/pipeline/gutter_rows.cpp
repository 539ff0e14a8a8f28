#include "pipeline/gutter_rows.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "stats/pyramid.h"

namespace scree {

GutterRows::GutterRows(int width, int height, Wrap wrap_s, Wrap wrap_t,
                       std::vector<TextureRows*> textures)
    : periodic_s_(wrap_s == Wrap::periodic), periodic_t_(wrap_t == Wrap::periodic),
      textures_(std::move(textures))
{
    for (int l = 0; l < level_count(width, height); ++l) {
        Level level;
        level.width = std::max(1, width >> l);
        level.height = std::max(1, height >> l);
        if (periodic_t_)
            for (size_t ring = 0; ring < level.grown.size(); ++ring)
                level.grown[ring] = static_cast<int>(ring);
        levels_.push_back(std::move(level));
    }
}

void GutterRows::rows_begin(int level, int begin, int end)
{
    Level& own = levels_[static_cast<size_t>(level)];
    for (int y = begin; y < end; ++y)
        own.rings[y].resize(static_cast<size_t>(own.width));
    for (TextureRows* texture : textures_)
        texture->rows_begin(level, begin, end);
}

void GutterRows::texels(int level, int y, int x0, int count, MomentRow row)
{
    Ring* rings = levels_[static_cast<size_t>(level)].rings.find(y)->second.data() + x0;
    const double* weight = row.plane(MomentLayout::weight);
    for (int x = 0; x < count; ++x)
        rings[x] = weight[x] > 0 ? 0 : kBeyondGutter;
    for (TextureRows* texture : textures_)
        texture->texels(level, y, x0, count, row);
}

RingRows GutterRows::rows_around(Level& level, int y) const
{
    auto rings = [&](int row) -> Ring* {
        if (periodic_t_)
            row = (row + level.height) % level.height;
        return row < 0 || row == level.height ? nullptr : level.rings.find(row)->second.data();
    };
    return {rings(y - 1), rings(y), rings(y + 1)};
}

void GutterRows::grow(int level, int ring, bool complete)
{
    Level& own = levels_[static_cast<size_t>(level)];
    const auto r = static_cast<size_t>(ring);
    const int first = periodic_t_ ? ring : 0;
    // A row needs the one below; past the last row come those that were left out at the top.
    const int end = complete ? own.height + first : own.grown[r - 1] - 1;
    std::vector<GrownRow> grown;
    for (; own.grown[r] < end; ++own.grown[r]) {
        GrownRow row;
        row.y = own.grown[r] % own.height;
        grow_ring(rows_around(own, row.y), own.width, periodic_s_, static_cast<Ring>(ring),
                  row.texels);
        if (!row.texels.empty())
            grown.push_back(std::move(row));
    }
    tbb::parallel_for(size_t{0}, grown.size() * textures_.size(), [&](size_t i) {
        const GrownRow& row = grown[i % grown.size()];
        textures_[i / grown.size()]->blend(level, row.y, row.texels);
    });
}

void GutterRows::forget(Level& level) const
{
    const int kept_at_top = periodic_t_ ? kGutterRings + 1 : 0;
    const int needed = std::max(kept_at_top, level.grown[kGutterRings] - 1);
    level.rings.erase(level.rings.lower_bound(kept_at_top), level.rings.lower_bound(needed));
}

void GutterRows::rows_end(int level, int end)
{
    Level& own = levels_[static_cast<size_t>(level)];
    own.grown[0] = end;
    const bool complete = end == own.height;
    for (int ring = 1; ring <= kGutterRings; ++ring)
        grow(level, ring, complete);
    if (complete)
        own.rings.clear();
    else
        forget(own);
    const int begin = periodic_t_ && !complete ? kTileSize : 0;
    // The last row grown is a neighbour of the next.
    const int settled = complete ? end : own.grown[kGutterRings] - 1;
    for (TextureRows* texture : textures_)
        texture->finish(level, begin, settled);
}

} // namespace scree
