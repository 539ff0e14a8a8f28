#pragma once

#include <cstddef>
#include <vector>

#include "visibility/height_grid.h"
#include "visibility/line_path.h"

namespace scree {

/// Heights under lines side by side: rows are places along the lines, columns positions across.
class LineWindow {
public:
    /// along_s  places are texels along s
    LineWindow(const HeightGrid& grid, int level, bool along_s)
        : grid_(grid), level_(level), along_s_(along_s)
    {}

    void read(int place, int places, int position, int positions);

    /// Makes up heights of texels without data beside some with data, so that a plane stays a
    /// plane: the mean of what the texels around one and those behind them continue to (of the
    /// texels around it where none has data behind). So texels with data have surface up to their
    /// edges. The statistics make one up for each neighbour
    /// alone (stats/height_rows.h), which differs where the surface is curved.
    ///
    /// The outermost rows and columns stay as they are, kMargin of them.
    void make_whole();
    static constexpr int kMargin = 2;

    /// The bilinear surface under lines at a node, the first of them `position` columns further.
    void at(const LineNode& node, int position, int count, float* heights) const;

    /// The same, but NaN between two texels where the cells on both sides lack one: as in them.
    void whole_cells_at(const LineNode& node, int position, int count, float* heights) const;

    /// Heights of a place from a position on; NaN where there is none.
    [[nodiscard]] const float* heights(int place, int position) const
    {
        return heights_.data() + static_cast<std::ptrdiff_t>(place - place_) * columns_ +
               (position - position_);
    }

private:
    const HeightGrid& grid_;
    int level_;
    bool along_s_;
    int place_ = 0, position_ = 0, rows_ = 0, columns_ = 0;
    std::vector<float> heights_, other_; ///< the other: before it is turned, or made whole
};

} // namespace scree
