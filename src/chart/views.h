#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "math/vec.h"

namespace scree {

/// Views between two angles from the normal.
struct ViewBand {
    double from_deg = 0, to_deg = 0;
    size_t first = 0, count = 0; ///< of ChartViews::views

    [[nodiscard]] std::string name() const; ///< "60-75"
};

/// The directions a chart looks and lights from.
struct ChartViews {
    std::vector<Vec3> views, lights; ///< unit, away from the surface
    std::vector<ViewBand> bands;
};

/// Bands 0-30, 30-60, 60-75 and 75-85 degrees, in each two elevations, a quarter of the band from
/// its ends, of four azimuths a right angle apart; lights at 20, 50 and 70 degrees. No azimuth
/// lies along an axis of the texture, and no view in the plane of a light.
ChartViews chart_views();

} // namespace scree
