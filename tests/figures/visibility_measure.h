#pragma once

#include <string>
#include <vector>

#include "chart/asset.h"
#include "figures/visibility_truth.h"

namespace scree::test {

/// What was measured of footprints of one size.
struct SizeFigures {
    std::string footprint; ///< texels along a side, or "map"
    /// One a model, in the order of SurfaceFigures::models.
    std::vector<SquaresOfAngles> squares;
    SquaresOfAngles noise;
};

/// What was measured of a surface at a slope; errors are relative to the map's mean color.
struct SurfaceFigures {
    std::string surface;
    double slope = 0; ///< rms length
    std::vector<std::string> models;
    std::vector<SizeFigures> sizes;
};

/// What to compare.
enum class Comparison {
    models, ///< a set with all there is: colors_of_views()
    /// Tables of 2 to 6 nodes, and of 4 as half floats and in other coordinates, all of 2
    /// harmonics; only footprints of 64x64 texels and the map.
    nodes,
};

/// Bakes the asset, reads footprints of 16x16, 64x64, 256x256 texels and the whole map, and holds
/// what the kernel tells of them against the reference renderer.
SurfaceFigures measure(const Asset& asset, double slope, Comparison comparison,
                       const AllViews& views);

} // namespace scree::test
