#pragma once

#include <cstddef>
#include <vector>

#include "visibility/height_grid.h"

namespace scree {

/// Heights under lines side by side: rows are places along the lines, columns positions across.
///
/// On level 0 a texel without data beside some with data gets a height made up so that a plane
/// stays a plane, the mean of what the texels around it and those behind them continue to: texels
/// with data then have surface up to their edges. The statistics make one up for each neighbour
/// alone (stats/height_rows.h), which differs where the surface is curved.
class LineWindow {
public:
    /// along_s  places are texels along s
    LineWindow(const HeightGrid& grid, int level, bool along_s)
        : grid_(grid), level_(level), along_s_(along_s)
    {}

    void read(int place, int places, int position, int positions);

    /// Heights of a place from a position on; NaN where there is none.
    [[nodiscard]] const float* heights(int place, int position) const
    {
        return whole_.data() + at(place, position);
    }

    /// The same, with nothing made up.
    [[nodiscard]] const float* texels(int place, int position) const
    {
        return (completes() ? given_.data() : whole_.data()) + at(place, position);
    }

private:
    [[nodiscard]] bool completes() const { return level_ == 0 && grid_.shape().holes; }
    [[nodiscard]] std::ptrdiff_t at(int place, int position) const
    {
        return static_cast<std::ptrdiff_t>(place - place_) * columns_ + (position - position_);
    }
    void complete();

    const HeightGrid& grid_;
    int level_;
    bool along_s_;
    int place_ = 0, position_ = 0, rows_ = 0, columns_ = 0;
    std::vector<float> whole_, given_, unturned_;
};

} // namespace scree
