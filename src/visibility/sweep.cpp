#include "visibility/sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "visibility/line_sweep.h"

namespace scree {

namespace {

class BlockSweep {
public:
    BlockSweep(const HeightGrid& heights, double azimuth_rad, const std::vector<double>& cotangents)
        : heights_(heights), azimuth_(azimuth_rad), along_s_(goes_along_s(heights, azimuth_rad)),
          cotangents_(cotangents)
    {}

    void run(const TexelBlock& block, float* const* visible) const;

private:
    void start(LineSweep& lines, int place, double reach) const;

    const HeightGrid& heights_;
    double azimuth_;
    bool along_s_;
    const std::vector<double>& cotangents_;
};

/// Follows lines up to before `place` from where nothing beyond can hide it.
///
/// reach  how far that is, world units
void BlockSweep::start(LineSweep& lines, int place, double reach) const
{
    const LineDirection& direction = lines.direction();
    const double needed = std::ceil(reach / direction.length) + 1;
    int steps = static_cast<int>(std::min<double>(needed, kNearSteps));
    bool goes_on = needed > steps;
    if (lines.ends()) { // one place more: the surface reaches the edge
        const int there = std::abs(place - lines.first_place()) + (lines.level() == 0 ? 1 : 0);
        const bool is_inside = (place - lines.first_place()) * direction.away >= 0;
        goes_on = goes_on && is_inside && steps < there;
        steps = is_inside ? std::min(steps, there) : 0;
    }
    const int begin = place - steps * direction.away;
    const int coarser_level = lines.level() + 1;
    if (goes_on && std::min(heights_.width(coarser_level), heights_.height(coarser_level)) >= 4) {
        LineSweep coarse(heights_, coarser_level, azimuth_, along_s_, cotangents_);
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

void BlockSweep::run(const TexelBlock& block, float* const* visible) const
{
    const int low = along_s_ ? block.x0 : block.y0;
    const int steps = along_s_ ? block.width : block.height;
    const int from = along_s_ ? block.y0 : block.x0;
    const int count = along_s_ ? block.height : block.width;

    LineSweep lines(heights_, 0, azimuth_, along_s_, cotangents_);
    const int away = lines.direction().away;
    const int place = away > 0 ? low : low + steps - 1;
    const double drift = lines.direction().shift * (steps - 1);
    lines.lay(place, from - std::max(drift, 0.0), from + count - 1 - std::min(drift, 0.0));
    const double range = heights_.shape().highest - heights_.shape().lowest;
    start(lines, place, range / *std::min_element(cotangents_.begin(), cotangents_.end()));

    const auto texels = static_cast<size_t>(steps) * static_cast<size_t>(count);
    std::vector<float> seen(cotangents_.size() * texels, 0.0F);
    std::vector<float*> rows;
    for (size_t k = 0; k < cotangents_.size(); ++k)
        rows.push_back(seen.data() + k * texels);
    lines.see(place, steps, from, count, rows.data());
    for (size_t k = 0; k < cotangents_.size(); ++k)
        for (int done = 0; done < steps; ++done) {
            const int along = away > 0 ? done : steps - 1 - done;
            const float* row = rows[k] + static_cast<ptrdiff_t>(done) * count;
            for (int q = 0; q < count; ++q)
                visible[k][along_s_ ? q * block.width + along : along * block.width + q] = row[q];
        }
}

} // namespace

void sweep(const HeightGrid& heights, const TexelBlock& block, double azimuth_rad,
           const std::vector<double>& cotangents, float* const* visible)
{
    BlockSweep(heights, azimuth_rad, cotangents).run(block, visible);
}

} // namespace scree
