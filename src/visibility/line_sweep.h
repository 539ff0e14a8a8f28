#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "visibility/height_grid.h"
#include "visibility/line_path.h"
#include "visibility/line_window.h"

namespace scree {

/// How lines lie on a level: they step from texel to texel along one axis, away from the viewer.
struct LineDirection {
    bool along_s;  ///< the axis that the lines cross faster
    int away;      ///< +1 where the texels' number grows on the way
    double length; ///< of a step, world units
    double shift;  ///< texels across, a step away

    /// azimuth_rad  of the viewer, from +s towards +t
    LineDirection(const HeightGrid& grid, int level, double azimuth_rad, bool along_s);
};

/// The axis that lines of an azimuth cross faster, counted in texels of level 0.
bool goes_along_s(const HeightGrid& grid, double azimuth_rad);

/// Heights of lines where a step begins and at its nodes.
using LineHeights = std::array<std::vector<float>, 1 + LinePath::kMostNodes>;

/// Lines side by side on one level, a texel apart, followed away from the viewer: of each elevation
/// the running maximum of the height above the line of sight.
///
/// Places are texels along the lines, positions lie across them; texel centres are whole numbers.
/// At place 0 lines are at `offset` beyond whole positions: they are tied to the map, so that
/// whoever follows a line sees the same.
class LineSweep {
public:
    /// cotangents  of the elevations' angles from the normal
    LineSweep(const HeightGrid& grid, int level, double azimuth_rad, bool along_s, double offset,
              const std::vector<double>& cotangents);

    [[nodiscard]] const LineDirection& direction() const { return direction_; }
    [[nodiscard]] int level() const { return level_; }
    [[nodiscard]] double offset() const { return offset_; }
    [[nodiscard]] int first_place() const; ///< of the map, as seen from the viewer
    [[nodiscard]] bool ends() const;       ///< the map does, along the lines

    /// The lines from before position `from` to after `to` at a place; nothing is seen so far.
    void lay(int place, double from, double to);

    /// Positions of the lines at a place, halves included.
    [[nodiscard]] double first_position(double place) const { return first_ + across(place); }
    [[nodiscard]] double last_position(double place) const
    {
        return first_position(place) + count_ - 1;
    }

    /// What coarser lines have seen, before the step to `place`. They end before it.
    void take_over(const LineSweep& coarse, int place);

    /// The place where coarser lines are to end so that they may be taken over at `place`.
    [[nodiscard]] int end_before(const LineSweep& fine, int place) const;

    /// Follows the lines through `steps` places from `place` on.
    void pass(int place, int steps);

    /// The same; of each place the visible areas of the texels at positions [from, from + count),
    /// E[V W] / cos theta, are added. Lines that have left these are not followed any more.
    ///
    /// visible  an elevation: `count` numbers for the first place
    /// stride   to those of the next
    void see(int place, int steps, int from, int count, float* const* visible,
             std::ptrdiff_t stride);

private:
    struct Lines {
        int begin, end;
    };

    [[nodiscard]] double across(double place) const;
    [[nodiscard]] LinePath path(int place) const;
    [[nodiscard]] Lines inside(int place, int texel) const;
    void read(int place, int steps, int margin, LineWindow& window) const;
    void go_to(int place, const LinePath& path, Lines lines);
    void stay_inside(int place, const LinePath& path, Lines lines);
    void pass_lines(const LinePath& path, int begin, int end, Lines lines);
    void see_step(int place, int from, int count, float* const* visible, std::ptrdiff_t offset);
    void see_piece(int place, const LinePath& path, const LinePath::Piece& piece, int from,
                   int count, float* const* visible, std::ptrdiff_t offset);

    const HeightGrid& grid_;
    int level_;
    LineDirection direction_;
    double offset_;
    bool has_ends_;                          ///< the surface: borders or holes
    std::vector<float> scales_;              ///< drops of the line of sight a world unit
    std::vector<double> drops_;              ///< of the line of sight a step, world units
    std::vector<std::vector<float>> maxima_; ///< an elevation: of each line, in drops
    int first_ = 0, count_ = 0;              ///< lines are at first_ + j + across(place)
    double end_ = 0;                         ///< the last place, halves included
    LineWindow window_, whole_window_;
    LineHeights hiding_; ///< what hides: cells between texels with data, inside the map
    LineHeights shown_;  ///< of texels that have data, up to their edges, from a step's beginning
};

} // namespace scree
