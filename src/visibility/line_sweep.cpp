#include "visibility/line_sweep.h"

#include <algorithm>
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
      window_(grid, level, along_s)
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
    centre_.resize(n);
    edge_.resize(n);
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

/// Reads what the lines touch in some steps, and a row more on both sides.
void LineSweep::read(int place, int steps)
{
    const int end = place + (steps - 1) * direction_.away;
    const int low = std::min(place, end) - 1, high = std::max(place, end) + 1;
    const double a = across(low), b = across(high);
    const int first = first_ + whole(std::min(a, b));
    const int last = first_ + count_ + whole(std::max(a, b));
    window_.read(low, high - low + 1, first, last - first + 1);
}

/// Heights of lines [begin, end) at the centre of a place and at its edge away from the viewer.
void LineSweep::go_to(int place, int begin, int end)
{
    const int count = end - begin;
    const int size = size_along(grid_, level_, direction_.along_s);
    const double centre = across(place), edge = across(place + 0.5 * direction_.away);
    const int first = first_ + begin;
    if (ends() && (place < 0 || place >= size)) // the surface begins at the map's edge
        std::fill_n(centre_.data() + begin, count, kNone);
    else
        in_row(window_.heights(place, first + whole(centre)), part(centre), count,
               centre_.data() + begin);
    between_rows(window_.heights(place, first + whole(edge)),
                 window_.heights(place + direction_.away, first + whole(edge)), part(edge), count,
                 edge_.data() + begin);
    end_ = place + 0.5 * direction_.away;
}

void LineSweep::pass(int place, int steps)
{
    for (int done = 0; done < steps; ++done) {
        if (done % kStretch == 0)
            read(place + done * direction_.away, std::min(kStretch, steps - done));
        go_to(place + done * direction_.away, 0, count_);
        for (size_t k = 0; k < scales_.size(); ++k)
            pass_step(centre_.data(), edge_.data(), scales_[k], count_, maxima_[k].data());
    }
}

void LineSweep::see(int place, int steps, int from, int count, float* const* visible,
                    ptrdiff_t stride)
{
    const HeightGrid::Shape& shape = grid_.shape();
    const bool all = !shape.holes && goes_on(shape.edge_s) && goes_on(shape.edge_t);
    for (int done = 0; done < steps; ++done) {
        if (done % kStretch == 0)
            read(place + done * direction_.away, std::min(kStretch, steps - done));
        const int here = place + done * direction_.away;
        // Line j is nearest to the texel at nearest + j.
        const int nearest = first_ + whole(across(here) + 0.5);
        const int begin = from - nearest, end = begin + count;
        // Those that are still to come lie before it or behind.
        const int pass_begin = direction_.shift > 0 ? 0 : end;
        const int pass_end = direction_.shift > 0 ? begin : count_;
        go_to(here, std::min(pass_begin, begin), std::max(pass_end, end));
        for (size_t k = 0; k < scales_.size(); ++k) {
            float* maxima = maxima_[k].data();
            float* seen = visible[k] + done * stride;
            pass_step(centre_.data() + pass_begin, edge_.data() + pass_begin, scales_[k],
                      pass_end - pass_begin, maxima + pass_begin);
            if (all)
                see_step(centre_.data() + begin, edge_.data() + begin, scales_[k], count,
                         maxima + begin, seen);
            else
                see_step_where(window_.texels(here, from), centre_.data() + begin,
                               edge_.data() + begin, scales_[k], count, maxima + begin, seen);
        }
    }
}

} // namespace scree
