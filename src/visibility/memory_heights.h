#pragma once

#include <vector>

#include "visibility/height_grid.h"

namespace scree {

/// A height grid that is held in memory with all its levels, 16 bytes for 3 texels.
class MemoryHeights : public HeightGrid {
public:
    /// shape    its lowest, highest and holes are found here
    /// heights  of level 0, row by row, world units; NaN: no data
    MemoryHeights(const Shape& shape, std::vector<float> heights);

protected:
    void read_row(int level, int x, int y, int count, float* heights) const override;

private:
    std::vector<std::vector<float>> levels_;
};

/// A row of a level from the rows of the level above it: halfway between the mean and the highest
/// of the heights there are, NaN where there are none.
///
/// fine_rows     those that share_of(row, ...) along t names
/// coarse        coarser_size(fine_width) heights
void coarser_heights(const float* const* fine_rows, const double* row_shares, int rows,
                     int fine_width, float* coarse);

} // namespace scree
