#include "visibility/sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "visibility/line_steps.h"
#include "visibility/line_sweep.h"

namespace scree {

namespace {

/// Where between two texel centres the lines of an axis-aligned azimuth run: there the variance of
/// an interpolated height, (1 - u)^2 + u^2 = 2/3, is its mean over all places. With n lines a texel
/// it is so on average for u = (this + 0, 1, ... n - 1) / n.
constexpr double kLineOffset = 0.21132486540518712;

/// Steps after which what lines saw along s is turned into rows.
constexpr int kTurnedSteps = 32;

class BlockSweep {
public:
    BlockSweep(const HeightGrid& heights, double azimuth_rad, const std::vector<double>& cotangents,
               const SweepOptions& options)
        : heights_(heights), azimuth_(azimuth_rad), along_s_(goes_along_s(heights, azimuth_rad)),
          cotangents_(cotangents), options_(options)
    {}

    void run(const TexelBlock& block, float* const* visible) const;

private:
    [[nodiscard]] LineSweep lines_before(const TexelBlock& block, double offset) const;
    void start(LineSweep& lines, int place, double reach) const;
    void see(std::vector<LineSweep>& sweeps, const TexelBlock& block, float* const* visible) const;
    void see_turned(std::vector<LineSweep>& sweeps, const TexelBlock& block,
                    float* const* visible) const;

    const HeightGrid& heights_;
    double azimuth_;
    bool along_s_;
    const std::vector<double>& cotangents_;
    const SweepOptions& options_;
};

/// Lines that were followed up to the first place of the block.
LineSweep BlockSweep::lines_before(const TexelBlock& block, double offset) const
{
    const int low = along_s_ ? block.x0 : block.y0;
    const int steps = along_s_ ? block.width : block.height;
    const int from = along_s_ ? block.y0 : block.x0;
    const int to = from + (along_s_ ? block.height : block.width) - 1;
    LineSweep lines(heights_, 0, azimuth_, along_s_, offset, cotangents_);
    const int place = lines.direction().away > 0 ? low : low + steps - 1;
    const double drift = lines.direction().shift * (steps - 1);
    lines.lay(place, from - std::max(drift, 0.0), to - std::min(drift, 0.0));
    const double range = heights_.shape().highest - heights_.shape().lowest;
    start(lines, place, range / *std::min_element(cotangents_.begin(), cotangents_.end()));
    return lines;
}

/// Follows lines up to before `place` from where nothing beyond can hide it.
///
/// reach  how far that is, world units
void BlockSweep::start(LineSweep& lines, int place, double reach) const
{
    const LineDirection& direction = lines.direction();
    const double needed = std::ceil(reach / direction.length) + 1;
    int steps = static_cast<int>(std::min<double>(needed, options_.near_steps));
    bool goes_on = needed > steps;
    if (lines.ends()) { // one place more: the surface reaches the edge
        const int there = std::abs(place - lines.first_place()) + (lines.level() == 0 ? 1 : 0);
        const bool is_inside = (place - lines.first_place()) * direction.away >= 0;
        goes_on = goes_on && is_inside && steps < there;
        steps = is_inside ? std::min(steps, there) : 0;
    }
    const int begin = place - steps * direction.away;
    const int coarser_level = lines.level() + 1;
    if (goes_on && coarser_level < heights_.levels()) {
        LineSweep coarse(heights_, coarser_level, azimuth_, along_s_, lines.offset(), cotangents_);
        const int end = coarse.end_before(lines, begin);
        const double scale =
            static_cast<double>(along_s_ ? heights_.height(coarser_level)
                                         : heights_.width(coarser_level)) /
            (along_s_ ? heights_.height(lines.level()) : heights_.width(lines.level()));
        coarse.lay(end, (lines.first_position(begin) + 0.5) * scale - 0.5,
                   (lines.last_position(begin) + 0.5) * scale - 0.5);
        start(coarse, end, reach - steps * direction.length);
        coarse.pass(end, 1);
        lines.take_over(coarse, begin);
    }
    lines.pass(begin, steps);
}

void BlockSweep::see(std::vector<LineSweep>& sweeps, const TexelBlock& block,
                     float* const* visible) const
{
    const bool forwards = sweeps.front().direction().away > 0;
    const int first = forwards ? 0 : block.height - 1;
    std::vector<float*> rows(visible, visible + cotangents_.size());
    for (float*& row : rows)
        row += static_cast<ptrdiff_t>(first) * block.width;
    for (LineSweep& lines : sweeps)
        lines.see(block.y0 + first, block.height, block.x0, block.width, rows.data(),
                  forwards ? block.width : -block.width);
}

/// The same along s: columns are seen one after the other, and turned some at a time.
void BlockSweep::see_turned(std::vector<LineSweep>& sweeps, const TexelBlock& block,
                            float* const* visible) const
{
    const bool forwards = sweeps.front().direction().away > 0;
    const ptrdiff_t count = block.height;
    const ptrdiff_t space = count * kTurnedSteps;
    std::vector<float> seen(cotangents_.size() * static_cast<size_t>(space));
    std::vector<float*> columns(cotangents_.size());
    for (int done = 0; done < block.width; done += kTurnedSteps) {
        const int steps = std::min(kTurnedSteps, block.width - done);
        const int low = forwards ? done : block.width - done - steps;
        const int first = forwards ? 0 : steps - 1;
        std::fill(seen.begin(), seen.end(), 0.0F);
        for (size_t k = 0; k < columns.size(); ++k)
            columns[k] = seen.data() + static_cast<ptrdiff_t>(k) * space + first * count;
        for (LineSweep& lines : sweeps)
            lines.see(block.x0 + low + first, steps, block.y0, block.height, columns.data(),
                      forwards ? count : -count);
        for (size_t k = 0; k < columns.size(); ++k)
            turn(seen.data() + static_cast<ptrdiff_t>(k) * space, steps, block.height,
                 visible[k] + low, block.width);
    }
}

void BlockSweep::run(const TexelBlock& block, float* const* visible) const
{
    const int lines = options_.lines_per_texel;
    const auto texels = static_cast<ptrdiff_t>(block.width) * block.height;
    std::vector<LineSweep> sweeps;
    sweeps.reserve(static_cast<size_t>(lines));
    for (int i = 0; i < lines; ++i)
        sweeps.push_back(lines_before(block, (i + kLineOffset) / lines));
    for (size_t k = 0; k < cotangents_.size(); ++k)
        std::fill_n(visible[k], texels, 0.0F);
    if (along_s_)
        see_turned(sweeps, block, visible);
    else
        see(sweeps, block, visible);
    if (lines == 1)
        return;
    for (size_t k = 0; k < cotangents_.size(); ++k)
        for (ptrdiff_t i = 0; i < texels; ++i)
            visible[k][i] /= static_cast<float>(lines);
}

} // namespace

void sweep(const HeightGrid& heights, const TexelBlock& block, double azimuth_rad,
           const std::vector<double>& cotangents, float* const* visible,
           const SweepOptions& options)
{
    assert(block.x0 >= 0 && block.width > 0 && block.x0 + block.width <= heights.width(0));
    assert(block.y0 >= 0 && block.height > 0 && block.y0 + block.height <= heights.height(0));
    assert(!cotangents.empty() && *std::min_element(cotangents.begin(), cotangents.end()) > 0);
    assert(options.lines_per_texel > 0 && options.near_steps > 0);
    BlockSweep(heights, azimuth_rad, cotangents, options).run(block, visible);
}

} // namespace scree
