#pragma once

#include <vector>

#include "chart/footprints.h"
#include "chart/views.h"
#include "reference/displaced_surface.h"

namespace scree {

/// Nanoseconds for one footprint, one view and one light: processor time of one thread, so that
/// what else runs on the machine counts little. Over the rounds.
struct Cost {
    double median_ns = 0, least_ns = 0, most_ns = 0;
    double lower_ns = 0, upper_ns = 0; ///< quartiles
};

constexpr int kCostTexels = 4096; ///< lookups in memory: a tile of 64 x 64 pixels

/// Time of Method::radiance, of every method: they take turns, so that what disturbs the machine
/// disturbs them alike. The lookups of a tile lie in memory one after the other, filtered already;
/// each has a view and a light of its own.
///
/// rounds  at least 1; one more goes before, to warm up
std::vector<Cost> time_methods(const ChartFootprints& footprints, const MethodSetting& setting,
                               const ChartViews& views, int rounds, const BakeMonitor& monitor);

/// Time of supersampling with grids of samples, by the reference renderer: some of the footprints,
/// the same for all grids, each with a view and a light of its own.
///
/// grids  side lengths: 4 is 16 samples
std::vector<Cost> time_supersampling(const reference::DisplacedSurface& surface,
                                     const std::vector<reference::Footprint>& footprints,
                                     const std::vector<int>& grids, const Material& material,
                                     const ChartViews& views, int rounds,
                                     const BakeMonitor& monitor);

} // namespace scree
