#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "chart/asset.h"
#include "chart/methods.h"
#include "reference/footprint.h"
#include "texset/manifest.h"

namespace scree {

/// The footprints a chart tries its methods on, and what the methods read of them.
struct ChartFootprints {
    std::vector<reference::Footprint> places;
    std::vector<FootprintData> data; ///< one a place
    MapTable height_colors;
    std::map<MethodTexture, PixelType> types; ///< that `--pixel-type auto` takes; of normals half
    /// Of the tables of visibility with harmonics, and of those along axes.
    VisibilityRecord visibility, visibility_axes;
};

/// Bakes the asset with all maps, rank tables of 8 terms, tables of visibility of four nodes with
/// two harmonics, once more with such tables along axes, and once with Sobel slopes, and picks
/// footprints of at least 4 x 4 texels.
///
/// count  a level, or as many as it has
/// seed   of the choice
/// Throws Error as a bake does, and for assets of less than 4 x 4 texels.
ChartFootprints bake_footprints(const Asset& asset, int count, uint64_t seed,
                                const BakeMonitor& monitor);

/// Of what a method reads.
int bytes_per_texel(const Method& method, const std::map<MethodTexture, PixelType>& types);

} // namespace scree
