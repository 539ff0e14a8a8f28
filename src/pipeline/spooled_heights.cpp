#include "pipeline/spooled_heights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>

#include "math/error.h"
#include "pipeline/strip.h"
#include "stats/pyramid.h"
#include "visibility/memory_heights.h"

namespace scree {

namespace {

HeightGrid::Shape shape_of(const Surface& surface)
{
    HeightGrid::Shape shape;
    shape.width = surface.width();
    shape.height = surface.height();
    shape.texel_width = surface.texel[0];
    shape.texel_height = surface.texel[1];
    shape.edge_s = edge_of(surface.options.wrap_s, Reconstruction::bilinear);
    shape.edge_t = edge_of(surface.options.wrap_t, Reconstruction::bilinear);
    shape.lowest = surface.found.height_min - surface.found.h0;
    shape.highest = surface.found.height_max - surface.found.h0;
    shape.ground = static_cast<float>(-surface.found.h0);
    shape.holes = !surface.found.complete;
    return shape;
}

/// Rows of one level on their way to its spool and to the next level.
struct LevelRows {
    Spool* spool;
    int width, height;
    int made = 0;
    std::deque<std::vector<float>> last; ///< the rows that the next level still needs, newest last
};

void append(std::vector<LevelRows>& levels, size_t level, std::vector<float> row)
{
    LevelRows& own = levels[level];
    if (!own.spool->append(row.data(), row.size()))
        throw Error("no room beside the output for a temporary file with the heights; make room, "
                    "or bake with --visibility smith");
    own.last.push_back(std::move(row));
    if (own.last.size() > 3)
        own.last.pop_front();
    ++own.made;
    if (level + 1 == levels.size())
        return;
    LevelRows& next = levels[level + 1];
    if (next.made == next.height)
        return;
    const Share share = share_of(next.made, own.height, next.height);
    if (share.first + share.count > own.made)
        return;
    const float* rows[3];
    const int oldest = own.made - static_cast<int>(own.last.size());
    for (int j = 0; j < share.count; ++j)
        rows[j] = own.last[static_cast<size_t>(share.first + j - oldest)].data();
    std::vector<float> coarse(static_cast<size_t>(next.width));
    coarser_heights(rows, share.parts, share.count, own.width, coarse.data());
    append(levels, level + 1, std::move(coarse));
}

} // namespace

SpooledHeights::SpooledHeights(const Surface& surface, const std::filesystem::path& folder)
    : HeightGrid(shape_of(surface))
{
    std::vector<LevelRows> rows;
    for (int level = 0; level < levels(); ++level) {
        spools_.push_back(std::make_unique<Spool>(folder));
        rows.push_back({spools_.back().get(), width(level), height(level), 0, {}});
    }
    Source& source = surface.source;
    source.rewind(false);
    SurfaceRows read;
    const auto columns = static_cast<size_t>(surface.width());
    for (int y = 0; y < surface.height();) {
        const int count = std::min(kStripRows, surface.height() - y);
        source.read(count, read);
        for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
            std::vector<float> row(columns);
            for (size_t x = 0; x < columns; ++x) {
                const size_t texel = i * columns + x;
                const bool counts = read.weight.empty() || read.weight[texel] > 0;
                row[x] = counts ? static_cast<float>(read.height[texel] - surface.found.h0)
                                : std::numeric_limits<float>::quiet_NaN();
            }
            append(rows, 0, std::move(row));
        }
        y += count;
        surface.monitor.report("heights", static_cast<double>(y) / surface.height());
    }
    for (const auto& spool : spools_) {
        spool->finish();
        levels_.push_back(spool->all());
    }
}

void SpooledHeights::read_row(int level, int x, int y, int count, float* heights) const
{
    const float* row =
        levels_[static_cast<size_t>(level)] + static_cast<ptrdiff_t>(y) * width(level) + x;
    std::copy_n(row, count, heights);
}

} // namespace scree
