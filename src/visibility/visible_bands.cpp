#include "visibility/visible_bands.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace scree {

namespace {

/// Columns that are swept together: longer than what lines start with before them.
constexpr int kBlockWidth = 512;

} // namespace

std::shared_ptr<const VisibleBand> VisibleBands::with_row(int y)
{
    if (last_ && y >= last_->first_row && y < last_->first_row + last_->rows)
        return last_;
    const HeightGrid::Shape& shape = heights_.shape();
    auto band = std::make_shared<VisibleBand>();
    band->first_row = y / kBandRows * kBandRows;
    band->rows = std::min(kBandRows, shape.height - band->first_row);
    band->width = shape.width;
    band->excess.resize(static_cast<size_t>(components_.count()) * static_cast<size_t>(band->rows) *
                        static_cast<size_t>(band->width));
    const int blocks = (shape.width + kBlockWidth - 1) / kBlockWidth;
    tbb::parallel_for(0, blocks, [&](int i) {
        const int x0 = i * kBlockWidth;
        const TexelBlock block{x0, band->first_row, std::min(kBlockWidth, shape.width - x0),
                               band->rows};
        const size_t texels = static_cast<size_t>(block.width) * static_cast<size_t>(block.height);
        std::vector<float> excess(static_cast<size_t>(components_.count()) * texels);
        std::vector<float*> planes;
        planes.reserve(static_cast<size_t>(components_.count()));
        for (int c = 0; c < components_.count(); ++c)
            planes.push_back(excess.data() + static_cast<size_t>(c) * texels);
        components_.see(heights_, block, planes.data());
        for (int c = 0; c < components_.count(); ++c)
            for (int row = 0; row < block.height; ++row)
                std::copy_n(planes[static_cast<size_t>(c)] +
                                static_cast<ptrdiff_t>(row) * block.width,
                            block.width,
                            band->excess.data() +
                                (static_cast<ptrdiff_t>(c) * band->rows + row) * band->width + x0);
    });
    last_ = std::move(band);
    return last_;
}

} // namespace scree
