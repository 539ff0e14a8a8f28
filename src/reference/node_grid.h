#pragma once

#include <cstddef>
#include <vector>

#include "reference/relief.h"

namespace scree::reference {

/// Heights at the corners of the bilinear cells: the relief's texels and one more beyond each edge.
///
/// Node (i, j) is texel (i - 1, j - 1), so it lies at x = i, y = j in grid coordinates
/// (x, y) = (s + 0.5, t + 0.5), texels; the relief is [0.5, width + 0.5] x [0.5, height + 0.5], and
/// cell (i, j) has the nodes (i, j) to (i + 1, j + 1). Rows are continued at their ends first, then
/// columns from the rows so continued, as Beyond says:
///   repeats  the texel at the opposite edge
///   mirrors  the texel at the edge again
///   extends  2 last - before last, or the last where there is just one
///   ends     height 0
///
/// Heights are world units above the lowest, so that a small relief on a large height keeps its
/// digits; NaN where there is no data.
class NodeGrid {
public:
    explicit NodeGrid(const Relief& relief);

    [[nodiscard]] int columns() const { return columns_; } ///< nodes along s, width + 2
    [[nodiscard]] int rows() const { return rows_; }       ///< nodes along t, height + 2
    [[nodiscard]] double base() const { return base_; } ///< of the heights; 0 where there are none
    [[nodiscard]] double range() const { return range_; } ///< all heights lie in [0, range]
    [[nodiscard]] const double* row(int j) const
    {
        return heights_.data() + static_cast<size_t>(j) * static_cast<size_t>(columns_);
    }

    /// Differences of heights below this are rounding: that of positions in texels (2^-52 of the
    /// grid's size) times the steepest cell there can be (the whole range in one texel), and some.
    [[nodiscard]] double tolerance() const { return tolerance_; }

private:
    int columns_, rows_;
    double base_ = 0, range_ = 0, tolerance_ = 0;
    std::vector<double> heights_;
};

} // namespace scree::reference
