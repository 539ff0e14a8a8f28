#pragma once

#include <vector>

#include "math/vec.h"

namespace scree::test {

/// Views and lights, all with all. Azimuths are of (j + offset) 360 / 16 degrees.
struct LightPairs {
    static constexpr size_t kAzimuths = 16;
    static constexpr size_t kViewsOfAngle = 4;

    std::vector<double> view_angles_deg, light_angles_deg; ///< from the normal; the first view's: 0
    size_t lights_of_angle = 0;
    /// Straight above, then four of every angle, a quarter turn apart, each angle from the next
    /// azimuth on.
    std::vector<Vec3> views;
    std::vector<Vec3> lights; ///< angle by angle, evenly around

    [[nodiscard]] size_t view_angle(size_t view) const;   ///< place in the list of angles
    [[nodiscard]] size_t light_angle(size_t light) const; ///< likewise
};

/// What is judged: views up to 83 degrees, lights up to 85, offset 1/4. No direction is one that
/// tables are swept at, an axis or a diagonal; all differences of azimuth come equally often.
LightPairs judged_pairs();

/// What joint tables are fitted to: none of the directions that are judged, offset 3/4.
LightPairs fitted_pairs();

} // namespace scree::test
