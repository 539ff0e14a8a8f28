#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "chart/errors.h"
#include "pipeline/options.h"
#include "reference/displaced_surface.h"

namespace scree {

/// The truth about the footprints of a chart, by the reference renderer.
struct ChartTruth {
    ErrorScale yardstick;
    std::vector<RelativeErrors> noise; ///< its own, one a band: half the difference of two halves
    long long rays = 0;                ///< cast
};

/// What to gather, and how well.
struct TruthPlan {
    ChartViews views;
    Material material;
    int grid = 64; ///< grid x grid samples a footprint
    uint64_t seed = 1;
};

/// monitor  is told of phase "truth", and may stop it
ChartTruth gather_truth(const reference::DisplacedSurface& surface,
                        const std::vector<reference::Footprint>& places, const TruthPlan& plan,
                        const BakeMonitor& monitor);

/// What supersampling shows: the same renderer with fewer samples, and a seed of its own.
///
/// progress  as of reference::gather_all
std::vector<Appearance> supersample(const reference::DisplacedSurface& surface,
                                    const std::vector<reference::Footprint>& places,
                                    const TruthPlan& plan,
                                    const std::function<void(double)>& progress);

} // namespace scree
