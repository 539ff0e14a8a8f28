#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "chart/asset.h"
#include "chart/cost.h"
#include "chart/errors.h"
#include "texset/manifest.h"

namespace scree {

struct ChartOptions {
    Material material;
    int footprints = 24; ///< a level
    int grid = 64;       ///< of the truth: grid x grid samples a footprint
    uint64_t seed = 1;   ///< of the choice of footprints and of the samples
    int rounds = 21;     ///< of timing
    int threads = 0;     ///< of everything but the timing, which has one; 0: all there are
};

/// A way to shade a footprint, what it costs and how wrong it is.
struct ChartRow {
    std::string name, what;
    MethodFamily family = MethodFamily::plain;
    int samples = 0; ///< of supersampling; 0: one lookup and a closed form
    /// That one lookup reads; NaN for supersampling, which reads the inputs themselves.
    double bytes = std::numeric_limits<double>::quiet_NaN();
    Cost cost;
    std::vector<RelativeErrors> errors; ///< one a band
};

/// All methods on one asset: the same footprints, views and lights for each, in one run.
struct AssetChart {
    std::string asset;
    int width = 0, height = 0; ///< texels
    int footprints = 0;
    /// Of the tables of visibility with harmonics, and of those along axes.
    VisibilityRecord visibility, visibility_axes;
    std::vector<ViewBand> bands;
    std::vector<RelativeErrors> noise; ///< of the truth itself, one a band
    std::vector<ChartRow> rows;        ///< the methods, then supersampling by rising samples
    long long rays = 0;                ///< cast for the truth
};

/// Bakes the asset, gathers the truth, and holds every method against it.
///
/// The errors depend on asset and options alone; the costs are measured.
/// Throws Error as bake_footprints() does, for options that make no sense, and for heights that are
/// too high for rays (judge/ray_reach.h).
AssetChart make_chart(const Asset& asset, const ChartOptions& options,
                      const BakeMonitor& monitor = {});

/// What the cost of a row is counted in.
enum class CostAxis { time, bytes };
/// Which of its errors.
enum class ErrorKind { radiance, color };

double cost_of(const ChartRow& row, CostAxis axis);
double error_of(const RelativeErrors& errors, ErrorKind kind);

/// Which rows no other beats at once in cost and in error.
std::vector<bool> front_of(const AssetChart& chart, size_t band, CostAxis axis, ErrorKind kind);

} // namespace scree
