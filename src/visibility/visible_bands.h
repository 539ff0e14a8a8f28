#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "visibility/view_components.h"

namespace scree {

/// What views see of some rows of a map.
struct VisibleBand {
    int first_row = 0, rows = 0, width = 0;
    std::vector<float> excess; ///< component by component, row by row

    [[nodiscard]] const float* row(int component, int y) const
    {
        const auto w = static_cast<std::ptrdiff_t>(width);
        return excess.data() +
               (static_cast<std::ptrdiff_t>(component) * rows + (y - first_row)) * w;
    }
};

constexpr int kBandRows = 128;

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
