#pragma once

#include <optional>

#include "judge/original.h"
#include "reference/statistics.h"

namespace scree {

/// Heights split in two at the threshold that explains most of their variance (Otsu 1979).
struct HeightModes {
    double low = 0, high = 0; ///< mean height on either side, world units
    double low_share = 0;     ///< of the area, below the threshold
    /// Variance between the two over all variance: 1 of two heights, 3/4 of evenly spread ones,
    /// 2/pi of normal ones, less of long tails.
    double explained = 0;
};

/// Heights as numbers.
struct HeightSteps {
    size_t values = 0; ///< different ones
    /// Of neighbours those of equal height, along s or along t, whichever has fewer: grooves are
    /// level along themselves.
    double level_share = 0;
};

/// Figures of a surface that its models stand or fall with.
struct AssetMeasures {
    size_t texels = 0;      ///< with data
    double rms_slope = 0;   ///< over the map
    double slope_ratio = 1; ///< of the slope's deviations along its principal axes, >= 1
    double azimuth_deg = 0; ///< of the axis with the larger, from +s towards +t, in (-90, 90]
    /// Mardia's, median over footprints of `footprint` x `footprint` texels whose slope varies.
    std::optional<double> kurtosis;
    int footprint = 1;
    /// Smallest share of the area that has nine tenths of the squared slope; 0.59 for normal
    /// slopes.
    double steep_share = 1;
    std::optional<HeightModes> modes; ///< absent of normal maps and of level heights
    std::optional<HeightSteps> steps; ///< absent of normal maps
    /// Of height and squared slope, texel by texel; 0 where either does not vary.
    double height_steepness = 0;
};

AssetMeasures measure_asset(const Original& original, Reconstruction reconstruction);

} // namespace scree
