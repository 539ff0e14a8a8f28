#pragma once

#include <array>
#include <vector>

#include "pipeline/options.h"
#include "pipeline/source.h"

namespace scree {

/// What must be known of a whole map before its first texel can be written.
struct Survey {
    double h0 = 0; ///< weighted mean height, world units
    double h1 = 1; ///< its standard deviation; 1 where the map is flat
    double height_min = 0, height_max = 0;
    std::array<float, 3> mean_color{}; ///< weighted, scene-linear
    bool complete = true;              ///< every texel has data, with weight 1
    bool covered = true;               ///< every texel has data, with some weight
    long long no_data_texels = 0;
    std::vector<double> first_row, last_row; ///< heights, for a map that is periodic along t
    Rejects rejects;
};

/// Strips in which a map is read: one row of tiles of level 0.
constexpr int kStripRows = 64;

/// The first, cheap pass over the input.
///
/// Means and variances are merged row by row (Chan et al.), in the order of the rows. Throws Error
/// when no texel has data.
Survey survey(Source& source, const BakeMonitor& monitor);

} // namespace scree
