#include "visibility/line_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace scree {

namespace {

/// Steps that heights are read for at a time.
constexpr int kStretch = 64;

/// Where between two texel centres the lines of an axis-aligned azimuth run: there the variance of
/// an interpolated height, (1 - u)^2 + u^2 = 2/3, is its mean over all places.
constexpr double kLineOffset = 0.21132486540518712;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kLowest = -std::numeric_limits<float>::infinity();

// The clones give the same numbers on every machine: no fused multiply-add.

/// Heights of lines side by side, at the fraction f between two texels of a row.
[[gnu::target_clones("avx2", "default")]] void in_row(const float* row, float f, int count,
                                                      float* heights)
{
    for (int j = 0; j < count; ++j)
        heights[j] = row[j] + f * (row[j + 1] - row[j]);
}

/// The same halfway between two rows.
[[gnu::target_clones("avx2", "default")]] void between_rows(const float* row, const float* next,
                                                            float f, int count, float* heights)
{
    for (int j = 0; j < count; ++j) {
        const float a = row[j] + f * (row[j + 1] - row[j]);
        const float b = next[j] + f * (next[j + 1] - next[j]);
        heights[j] = 0.5F * (a + b);
    }
}

/// A step: to the centre and on to the edge. Where a height is NaN the maximum just falls.
[[gnu::target_clones("avx2", "default")]] void pass_step(const float* centre, const float* edge,
                                                         float scale, int count, float* maximum)
{
    for (int j = 0; j < count; ++j) {
        const float c = centre[j] * scale, e = edge[j] * scale;
        const float before = maximum[j] - 0.5F;
        const float middle = (c > before ? c : before) - 0.5F;
        maximum[j] = e > middle ? e : middle;
    }
}

/// A step and what the maximum rises by in it.
[[gnu::target_clones("avx2", "default")]] void see_step(const float* centre, const float* edge,
                                                        float scale, int count, float* maximum,
                                                        float* rise)
{
    for (int j = 0; j < count; ++j) {
        const float c = centre[j] * scale, e = edge[j] * scale;
        const float before = maximum[j] - 0.5F;
        const float at_centre = c > before ? c : before;
        const float middle = at_centre - 0.5F;
        const float at_edge = e > middle ? e : middle;
        maximum[j] = at_edge;
        rise[j] = (at_centre - before) + (at_edge - middle);
    }
}

/// The same where heights may be NaN: what lies between one and none is no surface.
[[gnu::target_clones("avx2", "default")]] void
see_step_with_holes(const float* nearer_edge, const float* centre, const float* edge, float scale,
                    int count, float* maximum, float* rise)
{
    for (int j = 0; j < count; ++j) {
        const float c = centre[j] * scale, e = edge[j] * scale;
        const float before = maximum[j] - 0.5F;
        const float at_centre = c > before ? c : before;
        const float middle = at_centre - 0.5F;
        const float at_edge = e > middle ? e : middle;
        maximum[j] = at_edge;
        const float near = nearer_edge[j] * c == nearer_edge[j] * c ? at_centre - before : 0;
        const float far = c * e == c * e ? at_edge - middle : 0;
        rise[j] = near + far;
    }
}

[[gnu::target_clones("avx2", "default")]] void add(const float* from, int count, float* to)
{
    for (int j = 0; j < count; ++j)
        to[j] += from[j];
}

bool goes_on(Edge edge) { return edge == Edge::periodic || edge == Edge::repeat; }

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
                     const std::vector<double>& cotangents)
    : grid_(grid), level_(level), direction_(grid, level, azimuth_rad, along_s)
{
    for (const double cotangent : cotangents)
        drops_.push_back(cotangent * direction_.length);
    maxima_.resize(drops_.size());
}

bool LineSweep::ends() const
{
    return !goes_on(direction_.along_s ? grid_.shape().edge_s : grid_.shape().edge_t);
}

int LineSweep::first_place() const
{
    const int size = direction_.along_s ? grid_.width(level_) : grid_.height(level_);
    return direction_.away > 0 ? 0 : size - 1;
}

double LineSweep::across(double place) const
{
    return kLineOffset + direction_.shift * (place - origin_) * direction_.away;
}

void LineSweep::lay(int place, double from, double to)
{
    origin_ = place;
    first_ = static_cast<int>(std::floor(from)) - 1;
    count_ = static_cast<int>(std::ceil(to)) + 1 - first_;
    const auto n = static_cast<size_t>(count_);
    for (auto& maximum : maxima_)
        maximum.assign(n, kLowest);
    centre_.resize(n);
    rise_.resize(n);
    edge_.assign(n, kNone);
    nearer_edge_.resize(n);
}

namespace {

/// The place on a coarser level of one on a finer, halves included.
double coarser(double place, int fine_size, int coarse_size)
{
    return (place + 0.5) * coarse_size / fine_size - 0.5;
}

int size_along(const HeightGrid& grid, int level, bool s)
{
    return s ? grid.width(level) : grid.height(level);
}

} // namespace

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
    window_place_ = low;
    window_first_ = first_ + static_cast<int>(std::floor(std::min(a, b)));
    window_columns_ =
        first_ + count_ + static_cast<int>(std::floor(std::max(a, b))) + 1 - window_first_;
    const int rows = high - low + 1;
    const auto n = static_cast<size_t>(rows), m = static_cast<size_t>(window_columns_);
    window_.resize(n * m);
    if (!direction_.along_s) {
        grid_.read(level_, window_first_, low, window_columns_, rows, window_.data());
        return;
    }
    unturned_.resize(n * m);
    grid_.read(level_, low, window_first_, rows, window_columns_, unturned_.data());
    constexpr size_t kTile = 16;
    for (size_t tile = 0; tile < m; tile += kTile)
        for (size_t p = 0; p < n; ++p)
            for (size_t q = tile; q < std::min(tile + kTile, m); ++q)
                window_[p * m + q] = unturned_[q * n + p];
}

const float* LineSweep::heights_from(int place, int position) const
{
    return window_.data() +
           static_cast<ptrdiff_t>(place - window_place_) * static_cast<ptrdiff_t>(window_columns_) +
           (position - window_first_);
}

/// The lines' heights at the centre of a place and at its edge away from the viewer.
void LineSweep::go_to(int place)
{
    std::swap(edge_, nearer_edge_);
    const double centre = across(place), edge = across(place + 0.5 * direction_.away);
    const int size = size_along(grid_, level_, direction_.along_s);
    const auto split = [](double x) { return static_cast<float>(x - std::floor(x)); };
    if (ends() && (place < 0 || place >= size)) // the surface begins at the map's edge
        std::fill(centre_.begin(), centre_.end(), kNone);
    else
        in_row(heights_from(place, first_ + static_cast<int>(std::floor(centre))), split(centre),
               count_, centre_.data());
    const int column = first_ + static_cast<int>(std::floor(edge));
    between_rows(heights_from(place, column), heights_from(place + direction_.away, column),
                 split(edge), count_, edge_.data());
    end_ = place + 0.5 * direction_.away;
}

void LineSweep::pass(int place, int steps)
{
    for (int done = 0; done < steps; ++done) {
        if (done % kStretch == 0)
            read(place + done * direction_.away, std::min(kStretch, steps - done));
        go_to(place + done * direction_.away);
        for (size_t k = 0; k < drops_.size(); ++k)
            pass_step(centre_.data(), edge_.data(), static_cast<float>(1 / drops_[k]), count_,
                      maxima_[k].data());
    }
}

void LineSweep::see(int place, int steps, int from, int count, float* const* visible)
{
    const HeightGrid::Shape& shape = grid_.shape();
    const bool holes = shape.holes || !goes_on(shape.edge_s) || !goes_on(shape.edge_t);
    for (int done = 0; done < steps; ++done) {
        if (done % kStretch == 0)
            read(place + done * direction_.away, std::min(kStretch, steps - done));
        const int here = place + done * direction_.away;
        go_to(here);
        // Line j is nearest to the texel at nearest + j.
        const int nearest = first_ + static_cast<int>(std::floor(across(here) + 0.5));
        const int begin = std::max(from, nearest), end = std::min(from + count, nearest + count_);
        for (size_t k = 0; k < drops_.size(); ++k) {
            const auto scale = static_cast<float>(1 / drops_[k]);
            if (holes)
                see_step_with_holes(nearer_edge_.data(), centre_.data(), edge_.data(), scale,
                                    count_, maxima_[k].data(), rise_.data());
            else
                see_step(centre_.data(), edge_.data(), scale, count_, maxima_[k].data(),
                         rise_.data());
            add(rise_.data() + (begin - nearest), end - begin,
                visible[k] + static_cast<ptrdiff_t>(done) * count + (begin - from));
        }
    }
}

} // namespace scree
