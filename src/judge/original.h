#pragma once

#include <array>
#include <vector>

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "reference/statistics.h"

namespace scree {

/// The surface a set was baked from, whole, in memory: what truth is computed of.
struct Original {
    /// Heights in world units, empty of a normal map; scene-linear colors, a color map's already
    /// looked up.
    reference::Relief relief;
    std::vector<std::array<double, 2>> slopes; ///< of a normal map, else empty
    bool has_color = false;
};

/// Reads files as a bake with these options would. Throws Error as FileSource and
/// read_color_map_input() do.
Original read_original(const BakeOptions& options, const BakeMonitor& monitor);

/// The same from any source without a color map.
Original read_original(Source& source, const BakeOptions& options, const BakeMonitor& monitor);

/// The surface as its statistics by brute force take it.
reference::StatisticsInput statistics_input(const Original& original,
                                            Reconstruction reconstruction);

} // namespace scree
