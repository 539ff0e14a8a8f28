#include "visibility/visible_bands.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace scree {

std::shared_ptr<const VisibleBand> VisibleBands::with_row(int y)
{
    if (last_ && y >= last_->first_row && y < last_->first_row + last_->rows)
        return last_;
    const HeightGrid::Shape& shape = heights_.shape();
    auto band = std::make_shared<VisibleBand>();
    band->first_row = y / kBandRows * kBandRows;
    band->rows = std::min(kBandRows, shape.height - band->first_row);
    band->width = shape.width;
    band->components = components_.count();
    band->excess.reset(
        new float[static_cast<size_t>(band->components) * static_cast<size_t>(band->rows) *
                  static_cast<size_t>(band->width)]); // see() fills it
    const int blocks = (shape.width + kSweptColumns - 1) / kSweptColumns;
    tbb::parallel_for(0, blocks, [&](int i) {
        const int x0 = i * kSweptColumns;
        const TexelBlock block{x0, band->first_row, std::min(kSweptColumns, shape.width - x0),
                               band->rows};
        std::vector<float*> planes;
        planes.reserve(static_cast<size_t>(band->components));
        for (int c = 0; c < band->components; ++c)
            planes.push_back(band->at(c, x0, band->first_row));
        components_.see(heights_, block, planes.data());
    });
    last_ = std::move(band);
    return last_;
}

} // namespace scree
