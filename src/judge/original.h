#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "reference/statistics.h"

namespace scree {

/// What heights of a set are relative to, world units, and where they lie.
struct HeightScale {
    double h0 = 0, h1 = 1, lowest = 0, highest = 0;
};

/// The surface a set was baked from, whole, in memory: what truth is computed of.
struct Original {
    /// Heights in world units, empty of a normal map; scene-linear colors, a color map's already
    /// looked up.
    reference::Relief relief;
    std::vector<std::array<double, 2>> slopes; ///< of a normal map, else empty
    bool has_color = false;
    std::optional<HeightScale> scale; ///< of a tile: its set's
};

/// Reads files as a bake with these options would. Throws Error as FileSource and
/// read_color_map_input() do.
///
/// scale  of a tile: what its set found of all tiles
Original read_original(const BakeOptions& options, const BakeMonitor& monitor,
                       const std::optional<HeightScale>& scale = {});

/// The same from any source without a color map.
Original read_original(Source& source, const BakeOptions& options, const BakeMonitor& monitor);

/// The surface as its statistics by brute force take it.
reference::StatisticsInput statistics_input(const Original& original,
                                            Reconstruction reconstruction);

} // namespace scree
