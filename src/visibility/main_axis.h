#pragma once

#include "visibility/height_grid.h"

namespace scree {

/// The direction that most slopes lie along or across, degrees from +s towards +t, in (-45, 45];
/// 0 where they lie in no direction more than in others, or within a quarter of a degree of it.
///
/// With slope (s, t) = r (cos phi, sin phi) it is a quarter of the angle of the sum of
/// r^2 exp(4 i phi): walls of bricks and sides of a groove all point to it, 90 degrees apart.
/// Slopes are differences of heights two texels apart, of at most 1024 rows.
double main_axis_deg(const HeightGrid& heights);

} // namespace scree
