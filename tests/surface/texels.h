#pragma once

#include <algorithm>
#include <vector>

#include "surface/texel_metric.h"

namespace scree::test {

/// A whole tile in memory.
struct TexelImage {
    TexelGrid grid;
    TexelCounts counts;
    std::vector<TexelMetric> texels;

    [[nodiscard]] const TexelMetric& at(int x, int y) const
    {
        return texels[static_cast<size_t>(y) * static_cast<size_t>(grid.width) +
                      static_cast<size_t>(x)];
    }
    /// Texture coordinates of a centre, v up.
    [[nodiscard]] Vec2 uv(int x, int y) const
    {
        return {grid.tile_u + (x + 0.5) / grid.width, grid.tile_v + 1 - (y + 0.5) / grid.height};
    }
};

/// band  rows a call
inline TexelImage texels_of(const Mesh& mesh, const TexelGrid& grid,
                            const SurfaceOptions& options = {}, int band = 64)
{
    const LimitSurface surface(mesh, options);
    const TexelMetrics metrics(surface);
    TexelImage image{grid, {}, {}};
    image.texels.resize(static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height));
    for (int first = 0; first < grid.height; first += band)
        image.counts += metrics.rows(grid, first, std::min(band, grid.height - first),
                                     image.texels.data() + static_cast<size_t>(first) *
                                                               static_cast<size_t>(grid.width));
    return image;
}

} // namespace scree::test
