#include "visibility/line_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "visibility/line_steps.h"

namespace scree {

namespace {

/// Steps that heights are read for at a time.
constexpr int kStretch = 64;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kLowest = -std::numeric_limits<float>::infinity();

int size_along(const HeightGrid& grid, int level, bool s)
{
    return s ? grid.width(level) : grid.height(level);
}

/// The place on a coarser level of one on a finer, halves included.
double coarser(double place, int fine_size, int coarse_size)
{
    return (place + 0.5) * coarse_size / fine_size - 0.5;
}

int whole(double position) { return static_cast<int>(std::floor(position)); }

/// Nodes [begin, end) of a path, of the lines from one on.
LineNodes nodes_of(const LinePath& path, int begin, int end, const LineHeights& heights, int line)
{
    LineNodes nodes;
    nodes.count = end - begin;
    for (int n = begin; n < end; ++n) {
        nodes.heights[n - begin] = heights[static_cast<size_t>(n) + 1].data() + line;
        nodes.drops[n - begin] = path.nodes[n].drop;
    }
    return nodes;
}

} // namespace

bool goes_along_s(const HeightGrid& grid, double azimuth_rad)
{
    return std::abs(std::cos(azimuth_rad)) * grid.shape().texel_height >
           std::abs(std::sin(azimuth_rad)) * grid.shape().texel_width;
}

LineDirection::LineDirection(const HeightGrid& grid, int level, double azimuth_rad, bool s)
    : along_s(s)
{
    const HeightGrid::Shape& shape = grid.shape();
    // Texels a world unit towards the viewer.
    const double ds = std::cos(azimuth_rad) * grid.width(level) / (shape.texel_width * shape.width);
    const double dt =
        std::sin(azimuth_rad) * grid.height(level) / (shape.texel_height * shape.height);
    const double along = s ? ds : dt, over = s ? dt : ds;
    away = along > 0 ? -1 : 1;
    length = 1 / std::abs(along);
    shift = -over / std::abs(along);
}

LineSweep::LineSweep(const HeightGrid& grid, int level, double azimuth_rad, bool along_s,
                     double offset, const std::vector<double>& cotangents)
    : grid_(grid), level_(level), direction_(grid, level, azimuth_rad, along_s), offset_(offset),
      has_ends_(grid.shape().holes || !goes_on(grid.shape().edge_s) ||
                !goes_on(grid.shape().edge_t)),
      window_(grid, level, along_s), whole_window_(grid, level, along_s)
{
    for (const double cotangent : cotangents) {
        drops_.push_back(cotangent * direction_.length);
        scales_.push_back(static_cast<float>(1 / drops_.back()));
    }
    maxima_.resize(drops_.size());
}

bool LineSweep::ends() const
{
    return !goes_on(direction_.along_s ? grid_.shape().edge_s : grid_.shape().edge_t);
}

int LineSweep::first_place() const
{
    return direction_.away > 0 ? 0 : size_along(grid_, level_, direction_.along_s) - 1;
}

double LineSweep::across(double place) const
{
    return offset_ + direction_.shift * place * direction_.away;
}

void LineSweep::lay(int place, double from, double to)
{
    first_ = whole(from - across(place)) - 1;
    count_ = whole(to - across(place)) + 3 - first_;
    const auto n = static_cast<size_t>(count_);
    for (auto& maximum : maxima_)
        maximum.assign(n, kLowest);
    for (auto* heights : {&hiding_, &shown_})
        for (auto& of_node : *heights)
            of_node.resize(n);
}

int LineSweep::end_before(const LineSweep& fine, int place) const
{
    const bool s = direction_.along_s;
    const double edge = coarser(place - 0.5 * direction_.away, size_along(grid_, fine.level_, s),
                                size_along(grid_, level_, s));
    const double last = edge - 0.5 * direction_.away;
    return static_cast<int>(direction_.away > 0 ? std::floor(last) : std::ceil(last));
}

void LineSweep::take_over(const LineSweep& coarse, int place)
{
    const bool s = direction_.along_s;
    const int fine_along = size_along(grid_, level_, s);
    const int coarse_along = size_along(grid_, coarse.level_, s);
    const int fine_across = size_along(grid_, level_, !s);
    const int coarse_across = size_along(grid_, coarse.level_, !s);
    // Where the coarse lines end, as a place of the fine ones.
    const double end = coarser(coarse.end_, coarse_along, fine_along);
    const double gap = std::abs(place - 0.5 * direction_.away - end);
    for (size_t k = 0; k < maxima_.size(); ++k) {
        const double ratio = coarse.drops_[k] / drops_[k];
        for (int j = 0; j < count_; ++j) {
            const double position = coarser(first_position(end) + j, fine_across, coarse_across) -
                                    coarse.first_position(coarse.end_);
            const double at = std::clamp(position, 0.0, coarse.count_ - 1.0);
            const auto line = static_cast<size_t>(at);
            const size_t next = std::min(line + 1, coarse.maxima_[k].size() - 1);
            const double a = static_cast<double>(coarse.maxima_[k][line]);
            const double b = static_cast<double>(coarse.maxima_[k][next]);
            const double f = at - static_cast<double>(line);
            const double maximum =
                std::isfinite(a) && std::isfinite(b) ? a + f * (b - a) : std::max(a, b);
            maxima_[k][static_cast<size_t>(j)] = static_cast<float>(maximum * ratio - gap);
        }
    }
}

/// On coarser levels nothing is seen, and a step may be many columns wide: rows are enough.
LinePath LineSweep::path(int place) const
{
    const double half = 0.5 * direction_.away;
    return {place,         direction_.away,      across(place - half),
            across(place), across(place + half), level_ == 0};
}

/// Lines in texels of the map, line 0 in that one; where there are none they end before they begin.
LineSweep::Lines LineSweep::inside(int place, int texel) const
{
    const bool s = direction_.along_s;
    if (ends() && (place < 0 || place >= size_along(grid_, level_, s)))
        return {count_, 0};
    if (goes_on(s ? grid_.shape().edge_t : grid_.shape().edge_s))
        return {0, count_};
    const int size = size_along(grid_, level_, !s), first = first_ + texel;
    return {std::clamp(-first, 0, count_), std::clamp(size - first, 0, count_)};
}

/// Reads what the lines touch in some steps, and a row more on both sides.
void LineSweep::read(int place, int steps, int margin, LineWindow& window) const
{
    const int end = place + (steps - 1) * direction_.away;
    const int low = std::min(place, end) - 1, high = std::max(place, end) + 1;
    const double a = across(low), b = across(high);
    const int first = first_ + whole(std::min(a, b));
    const int last = first_ + count_ + whole(std::max(a, b));
    window.read(low - margin, high - low + 1 + 2 * margin, first - margin,
                last - first + 1 + 2 * margin);
}

/// What hides of lines in a step.
void LineSweep::go_to(int place, const LinePath& path, Lines lines)
{
    const int count = lines.end - lines.begin;
    for (int n = 0; n < path.node_count; ++n) {
        float* heights = hiding_[static_cast<size_t>(n) + 1].data() + lines.begin;
        if (has_ends_)
            window_.whole_cells_at(path.nodes[n], first_ + lines.begin, count, heights);
        else
            window_.at(path.nodes[n], first_ + lines.begin, count, heights);
    }
    end_ = place + 0.5 * direction_.away;
    if (has_ends_)
        stay_inside(place, path, lines);
}

/// Leaves out what lies beyond the map; its edge is the last that hides.
void LineSweep::stay_inside(int place, const LinePath& path, Lines lines)
{
    for (int p = 0; p < path.piece_count; ++p) {
        const LinePath::Piece& piece = path.pieces[p];
        const Lines here = inside(place, piece.texel);
        const Lines next = p + 1 < path.piece_count ? inside(place, path.pieces[p + 1].texel)
                                                    : inside(place + direction_.away, piece.texel);
        for (int n = piece.begin; n < piece.end; ++n) {
            const bool is_edge = n + 1 == piece.end;
            const int begin = is_edge ? std::min(here.begin, next.begin) : here.begin;
            const int end = is_edge ? std::max(here.end, next.end) : here.end;
            for (int j = lines.begin; j < lines.end; ++j)
                if (j < begin || j >= end)
                    hiding_[static_cast<size_t>(n) + 1][static_cast<size_t>(j)] = kNone;
        }
    }
}

void LineSweep::pass(int place, int steps)
{
    for (int done = 0; done < steps; ++done) {
        const int here = place + done * direction_.away;
        if (done % kStretch == 0)
            read(here, std::min(kStretch, steps - done), 0, window_);
        const LinePath path = this->path(here);
        go_to(here, path, {0, count_});
        pass_lines(path, 0, path.node_count, {0, count_});
    }
}

/// Lines go on through nodes [begin, end) of a step.
void LineSweep::pass_lines(const LinePath& path, int begin, int end, Lines lines)
{
    const LineNodes hiding = nodes_of(path, begin, end, hiding_, lines.begin);
    for (size_t k = 0; k < scales_.size(); ++k)
        pass_nodes(hiding, scales_[k], lines.end - lines.begin, maxima_[k].data() + lines.begin);
}

void LineSweep::see(int place, int steps, int from, int count, float* const* visible,
                    ptrdiff_t stride)
{
    for (int done = 0; done < steps; ++done) {
        const int here = place + done * direction_.away;
        if (done % kStretch == 0) {
            read(here, std::min(kStretch, steps - done), 0, window_);
            if (has_ends_) {
                read(here, std::min(kStretch, steps - done), LineWindow::kMargin, whole_window_);
                whole_window_.make_whole();
            }
        }
        see_step(here, from, count, visible, done * stride);
    }
}

/// In each piece of a step another line is in a texel.
///
/// offset  to the place's numbers of `visible`
void LineSweep::see_step(int place, int from, int count, float* const* visible, ptrdiff_t offset)
{
    const LinePath path = this->path(place);
    const int first = from - first_ - path.pieces[0].texel;
    const int last = from - first_ - path.pieces[path.piece_count - 1].texel;
    const Lines seen{std::min(first, last), std::max(first, last) + count};
    assert(seen.begin >= 0 && seen.end <= count_);
    go_to(place, path, direction_.shift > 0 ? Lines{0, seen.end} : Lines{seen.begin, count_});
    if (has_ends_) {
        const int lines = seen.end - seen.begin, position = first_ + seen.begin;
        whole_window_.at(path.beginning, position, lines, shown_[0].data() + seen.begin);
        for (int n = 0; n < path.node_count; ++n)
            whole_window_.at(path.nodes[n], position, lines,
                             shown_[static_cast<size_t>(n) + 1].data() + seen.begin);
    }
    for (int p = 0; p < path.piece_count; ++p)
        see_piece(place, path, path.pieces[p], from, count, visible, offset);
}

void LineSweep::see_piece(int place, const LinePath& path, const LinePath::Piece& piece, int from,
                          int count, float* const* visible, ptrdiff_t offset)
{
    const int line = from - first_ - piece.texel;
    // Those that are still to come lie before these or behind.
    pass_lines(path, piece.begin, piece.end,
               direction_.shift > 0 ? Lines{0, line} : Lines{line + count, count_});
    const LineNodes hiding = nodes_of(path, piece.begin, piece.end, hiding_, line);
    const LineNodes shown = nodes_of(path, piece.begin, piece.end, shown_, line);
    const float* shown_first = shown_[static_cast<size_t>(piece.begin)].data() + line;
    for (size_t k = 0; k < scales_.size(); ++k) {
        float *maxima = maxima_[k].data() + line, *seen = visible[k] + offset;
        if (has_ends_)
            see_nodes_with_ends(window_.heights(place, from), hiding, shown_first, shown,
                                scales_[k], count, maxima, seen);
        else
            see_nodes(hiding, scales_[k], count, maxima, seen);
    }
}

} // namespace scree
