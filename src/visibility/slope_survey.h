#pragma once

#include "visibility/height_grid.h"

namespace scree {

/// How steep a height map is, and which way; of at most 1024 of its rows.
struct SlopeSurvey {
    /// sqrt(E[r^4] / E[r^2]), r^2 = s^2 + t^2 the mean over the bilinear cell between four texels:
    /// how steep is what is steep. Of grooves and walls of one slope it is that slope, however far
    /// apart they are; of normal slopes sqrt 2 times their rms. 0 where nothing slopes.
    double steepness = 0;

    /// The direction that most slopes lie along or across, degrees from +s towards +t, in
    /// (-45, 45]; 0 where they lie in no direction more than in others, or within a quarter of a
    /// degree of it.
    ///
    /// With slope (s, t) = r (cos phi, sin phi) it is a quarter of the angle of the sum of
    /// r^2 exp(4 i phi): walls of bricks and sides of a groove all point to it, 90 degrees apart.
    /// Of differences of heights two texels apart.
    double axis_deg = 0;
};

SlopeSurvey survey_slopes(const HeightGrid& heights);

} // namespace scree
