#include "visibility/line_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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
float part(double position) { return static_cast<float>(position - std::floor(position)); }

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
    hiding_.resize(n);
    shown_.resize(n);
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

/// The texel that line 0 is nearest to.
int LineSweep::nearest(int place) const { return first_ + whole(across(place) + 0.5); }

/// Lines that are nearest to texels of the map; where there are none they end before they begin.
LineSweep::Lines LineSweep::inside(int place) const
{
    const bool s = direction_.along_s;
    if (ends() && (place < 0 || place >= size_along(grid_, level_, s)))
        return {count_, 0};
    if (goes_on(s ? grid_.shape().edge_t : grid_.shape().edge_s))
        return {0, count_};
    const int size = size_along(grid_, level_, !s), first = nearest(place);
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

void LineSweep::at_centre(const LineWindow& window, int place, Lines lines,
                          std::vector<float>& heights) const
{
    const double position = across(place);
    const int first = first_ + lines.begin + whole(position);
    in_row(window.heights(place, first), part(position), lines.end - lines.begin,
           heights.data() + lines.begin);
}

/// Heights at the edge between two places.
void LineSweep::at_edge(const LineWindow& window, int place, int next, Lines lines,
                        std::vector<float>& heights) const
{
    const double position = across(0.5 * (place + next));
    const int first = first_ + lines.begin + whole(position);
    between_rows(window.heights(place, first), window.heights(next, first), part(position),
                 lines.end - lines.begin, heights.data() + lines.begin);
}

/// What hides of lines at a place.
void LineSweep::go_to(int place, Lines lines)
{
    const int next = place + direction_.away;
    at_centre(window_, place, lines, hiding_.centre);
    at_edge(window_, place, next, lines, hiding_.edge);
    end_ = place + 0.5 * direction_.away;
    if (!has_ends_)
        return;
    const auto keep = [&](int begin, int end, std::vector<float>& heights) {
        for (int j = lines.begin; j < lines.end; ++j)
            if (j < begin || j >= end)
                heights[static_cast<size_t>(j)] = kNone;
    };
    const Lines here = inside(place), there = inside(next);
    keep(here.begin, here.end, hiding_.centre);
    keep(std::min(here.begin, there.begin), std::max(here.end, there.end), hiding_.edge);
}

/// What lines show of the texels of a place.
void LineSweep::show(int place, Lines lines)
{
    at_edge(whole_window_, place - direction_.away, place, lines, shown_.near);
    at_centre(whole_window_, place, lines, shown_.centre);
    at_edge(whole_window_, place, place + direction_.away, lines, shown_.edge);
}

void LineSweep::pass(int place, int steps)
{
    for (int done = 0; done < steps; ++done) {
        if (done % kStretch == 0)
            read(place + done * direction_.away, std::min(kStretch, steps - done), 0, window_);
        go_to(place + done * direction_.away, {0, count_});
        for (size_t k = 0; k < scales_.size(); ++k)
            pass_step(hiding_.from(0), scales_[k], count_, maxima_[k].data());
    }
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
        const int begin = from - nearest(here), end = begin + count;
        // Those that are still to come lie before these or behind.
        const Lines ahead = direction_.shift > 0 ? Lines{0, begin} : Lines{end, count_};
        go_to(here, {std::min(ahead.begin, begin), std::max(ahead.end, end)});
        if (has_ends_)
            show(here, {begin, end});
        for (size_t k = 0; k < scales_.size(); ++k) {
            float* maxima = maxima_[k].data();
            float* seen = visible[k] + done * stride;
            pass_step(hiding_.from(ahead.begin), scales_[k], ahead.end - ahead.begin,
                      maxima + ahead.begin);
            if (has_ends_)
                see_step_with_ends(window_.heights(here, from), hiding_.from(begin),
                                   shown_.from(begin), scales_[k], count, maxima + begin, seen);
            else
                see_step(hiding_.from(begin), scales_[k], count, maxima + begin, seen);
        }
    }
}

void LineSweep::Heights::resize(size_t count)
{
    near.resize(count);
    centre.resize(count);
    edge.resize(count);
}

StepHeights LineSweep::Heights::from(int line) const
{
    return {near.data() + line, centre.data() + line, edge.data() + line};
}

} // namespace scree
