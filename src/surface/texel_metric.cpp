#include "surface/texel_metric.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "surface/metric_rows.h"

namespace scree {

namespace {

/// Faces that are ready at one time; one beside many-sided corners takes 40 kB.
constexpr size_t kFacesAtOnce = 512;
/// Rows of one task.
constexpr int kRowsOfTask = 4;

} // namespace

TexelCounts& TexelCounts::operator+=(const TexelCounts& other)
{
    covered += other.covered;
    overlapped += other.overlapped;
    mirrored += other.mirrored;
    singular += other.singular;
    if (other.first_overlap)
        note_overlap(*other.first_overlap);
    return *this;
}

void TexelCounts::note_overlap(const UvOverlap& overlap)
{
    if (!first_overlap ||
        std::pair(overlap.y, overlap.x) < std::pair(first_overlap->y, first_overlap->x))
        first_overlap = overlap;
}

TexelMetrics::TexelMetrics(const LimitSurface& surface)
    : surface_(surface),
      boxes_(static_cast<size_t>(surface.face_count()), Box{Vec2(1, 1), Vec2(0, 0)})
{
    tbb::parallel_for(size_t{0}, boxes_.size(), [&](size_t i) {
        const FaceSurface face = surface_.face(static_cast<int>(i));
        if (face.pieces().empty())
            return;
        const auto [low, high] = face.uv_bounds();
        boxes_[i] = {low, high};
    });
}

std::vector<std::pair<int, int>> TexelMetrics::tiles() const
{
    // Boxes in tiles, each once: many faces share few.
    std::set<std::array<int, 4>> boxes;
    constexpr double kNoise = 1e-5; // of files that write coordinates with five digits
    const auto below = [](double x) { return static_cast<int>(std::floor(x + kNoise)); };
    const auto above = [](double x) { return static_cast<int>(std::ceil(x - kNoise)); };
    for (const Box& box : boxes_)
        if (!box.is_empty())
            boxes.insert(
                {below(box.low.x), below(box.low.y), above(box.high.x), above(box.high.y)});
    std::set<std::pair<int, int>> rows_then_columns;
    for (const auto& [left, bottom, right, top] : boxes)
        for (int v = bottom; v < top; ++v)
            for (int u = left; u < right; ++u)
                rows_then_columns.emplace(v, u);
    std::vector<std::pair<int, int>> tiles;
    tiles.reserve(rows_then_columns.size());
    for (const auto& [v, u] : rows_then_columns)
        tiles.emplace_back(u, v);
    return tiles;
}

int TexelMetrics::faces_without_surface() const
{
    return static_cast<int>(
        std::count_if(boxes_.begin(), boxes_.end(), [](const Box& box) { return box.is_empty(); }));
}

TexelCounts TexelMetrics::rows(const TexelGrid& grid, int first, int count,
                               TexelMetric* texels) const
{
    const TexelRows band(grid, first, count, texels);
    const UvBox reach = band.box();
    std::vector<int> faces;
    for (size_t i = 0; i < boxes_.size(); ++i)
        if (reach.meets(boxes_[i].low, boxes_[i].high))
            faces.push_back(static_cast<int>(i));
    band.clear();

    const int tasks = (count + kRowsOfTask - 1) / kRowsOfTask;
    std::vector<TexelCounts> counts(static_cast<size_t>(tasks));
    std::vector<ReadyFace> ready;
    for (size_t begin = 0; begin < faces.size(); begin += kFacesAtOnce) {
        const size_t size = std::min(kFacesAtOnce, faces.size() - begin);
        ready.resize(size);
        tbb::parallel_for(size_t{0}, size,
                          [&](size_t i) { ready[i] = ReadyFace(surface_, faces[begin + i]); });
        tbb::parallel_for(0, tasks, [&](int task) {
            const int row = task * kRowsOfTask;
            band.draw(ready, row, std::min(count, row + kRowsOfTask),
                      counts[static_cast<size_t>(task)]);
        });
    }
    TexelCounts total;
    for (const TexelCounts& part : counts)
        total += part;
    return total;
}

} // namespace scree
