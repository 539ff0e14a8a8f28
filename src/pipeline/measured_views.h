#pragma once

#include <vector>

#include "visibility/view_components.h"

namespace scree {

/// A view that models are measured from.
struct MeasuredView {
    int elevation;
    double x, y, z; ///< unit, towards the viewer
};

/// Elevations that rise to the largest view angle, each from four sides: opposite ones, two close
/// to an axis of the map, where walls hide the most, two farther off; halfway between the azimuths
/// that tables are made of, where a series in the azimuth is told least.
struct MeasuredViews {
    explicit MeasuredViews(double max_view_angle_deg);

    std::vector<double> elevations_deg;
    std::vector<MeasuredView> views;
    std::vector<ViewAngles> angles; ///< the same as angles, for sweeps
};

} // namespace scree
