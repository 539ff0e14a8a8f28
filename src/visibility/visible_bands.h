#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "visibility/view_components.h"

namespace scree {

constexpr int kBandRows = 128;

/// Columns that are swept together: longer than what lines start with before them.
constexpr int kSweptColumns = 512;

/// What views see of some rows of a map, in blocks of kSweptColumns.
struct VisibleBand {
    int first_row = 0, rows = 0, width = 0, components = 0;
    std::unique_ptr<float[]> excess; ///< block by block, component by component, row by row

    /// From a texel on, up to the end of its block.
    [[nodiscard]] float* at(int component, int x, int y) const
    {
        const int before = x / kSweptColumns * kSweptColumns;
        const std::ptrdiff_t columns = std::min(kSweptColumns, width - before);
        const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(component) * rows + (y - first_row);
        return excess.get() + static_cast<std::ptrdiff_t>(before) * rows * components +
               row * columns + (x - before);
    }
};

/// Bands of kBandRows rows, made one after the other as they are asked for, on all cores.
class VisibleBands {
public:
    /// Both are kept by reference.
    VisibleBands(const HeightGrid& heights, const ViewComponents& components)
        : heights_(heights), components_(components)
    {}

    /// The band that row y lies in; the last one asked for is kept.
    std::shared_ptr<const VisibleBand> with_row(int y);

private:
    const HeightGrid& heights_;
    const ViewComponents& components_;
    std::shared_ptr<const VisibleBand> last_;
};

} // namespace scree
