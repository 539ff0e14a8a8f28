#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chart/asset.h"
#include "figures/light_truth.h"

namespace scree::test {

/// A way as reports name it.
struct LightWayInfo {
    std::string name;
    std::optional<size_t> numbers; ///< a texel; absent: nothing a set could hold
    bool of_light_alone = true;    ///< as of LightWay
};

/// What was measured of footprints of one size.
struct LightSizeFigures {
    std::string footprint;               ///< texels along a side, or "map"
    std::vector<SquaresOfPairs> squares; ///< one a way
    SquaresOfPairs noise;
};

/// What was measured of a surface at a slope; errors are relative to the map's mean color.
struct LightFigures {
    std::string surface;
    double slope = 0; ///< rms length
    std::vector<LightWayInfo> ways;
    std::vector<LightSizeFigures> sizes;
};

/// Bakes the asset, reads footprints of 16x16 and 64x64 texels and the whole map, and holds what
/// light_ways() and joint_forms() tell of the color seen and lit against the reference renderer.
LightFigures measure_light(const Asset& asset, double slope);

} // namespace scree::test
