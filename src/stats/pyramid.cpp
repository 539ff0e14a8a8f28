#include "stats/pyramid.h"

#include <algorithm>

#include "stats/plane_means.h"

namespace scree {

int coarser_size(int size) { return std::max(1, size / 2); }

int level_count(int width, int height)
{
    int levels = 1;
    for (int n = std::max(width, height); n > 1; n /= 2)
        ++levels;
    return levels;
}

Share share_of(int coarse, int fine_size, int coarse_size)
{
    // In units of 1/m of a fine texel: coarse j is [j n, (j+1) n), fine i is [i m, (i+1) m).
    const long long n = fine_size;
    const long long m = coarse_size;
    const long long begin = coarse * n;
    const long long end = begin + n;
    Share share{static_cast<int>(begin / m), 0, {0, 0, 0}};
    for (long long i = share.first; i * m < end; ++i) {
        const long long overlap = std::min((i + 1) * m, end) - std::max(i * m, begin);
        share.parts[share.count++] = static_cast<double>(overlap) / static_cast<double>(n);
    }
    return share;
}

Reduction::Reduction(const MomentLayout& layout, int fine_width, int coarse_width) : layout_(layout)
{
    columns_.reserve(static_cast<size_t>(coarse_width));
    for (int x = 0; x < coarse_width; ++x)
        columns_.push_back(share_of(x, fine_width, coarse_width));
}

namespace {

/// Texels index[0], index[1], ... of `row`, side by side.
void gather(const MomentLayout& layout, MomentRow row, const int* index, MomentRow out, int count)
{
    for (int plane = 0; plane < layout.merged_planes; ++plane) {
        const double* from = row.plane(plane);
        double* to = out.plane(plane);
        for (int x = 0; x < count; ++x)
            to[x] = from[index[x]];
    }
}

} // namespace

void Reduction::row(const MomentRow* fine_rows, const Share& rows, int x0, int x1,
                    MomentRow coarse) const
{
    // Rows first (contiguous), then columns (gathered), in runs short enough for the cache.
    constexpr int kRun = kMergeRun / 3; // coarse texels, so that 3 kRun fine ones fit a run
    constexpr int kMaxPlanes = MomentLayout::kMaxMergedPlanes;
    static_assert(3 * kRun <= kMergeRun);
    double merged_data[kMaxPlanes * kMergeRun]; // the fine texels of the run, rows merged
    double part_data[3][kMaxPlanes * kRun];
    double shares[3][kMergeRun];
    const MomentRow merged{merged_data, kMergeRun};

    for (int begin = x0; begin < x1; begin += kRun) {
        const int count = std::min(kRun, x1 - begin);
        const Share* columns = &columns_[static_cast<size_t>(begin)];
        const int fine_begin = columns[0].first;
        const int fine_count = columns[count - 1].first + columns[count - 1].count - fine_begin;

        MergePart parts[3];
        for (int k = 0; k < rows.count; ++k) {
            std::fill_n(shares[k], fine_count, rows.parts[k]);
            parts[k] = {fine_rows[k].from(fine_begin), shares[k]};
        }
        merge(layout_, parts, rows.count, merged, fine_count);

        int part_count = 1;
        for (int x = 0; x < count; ++x)
            part_count = std::max(part_count, columns[x].count);
        for (int k = 0; k < part_count; ++k) {
            int index[kRun];
            for (int x = 0; x < count; ++x) {
                // A texel with fewer parts than its neighbours repeats its last with no share.
                const bool has_part = k < columns[x].count;
                shares[k][x] = has_part ? columns[x].parts[k] : 0;
                index[x] = columns[x].first - fine_begin + (has_part ? k : columns[x].count - 1);
            }
            parts[k] = {{part_data[k], kRun}, shares[k]};
            gather(layout_, merged, index, parts[k].row, count);
        }
        merge(layout_, parts, part_count, coarse.from(begin), count);
    }
    if (fine_rows[0].seen != nullptr)
        mean_seen(layout_, fine_rows, rows, columns_.data(), x0, x1, coarse);
    else
        mean_planes(layout_.texel_planes, layout_.planes - layout_.texel_planes, fine_rows, rows,
                    columns_.data(), x0, x1, coarse);
}

} // namespace scree
