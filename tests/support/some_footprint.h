#pragma once

#include <string>

#include "chart/methods.h"
#include "math/vec.h"

namespace scree::test {

/// Throws std::runtime_error where there is none.
const Method& method_named(const std::string& name);

/// Unit vector at an angle from the normal and an azimuth, radians.
Vec3 toward(double theta, double phi);

/// A table that is a straight line in the mean, from `low` to `high` at -10 to 10.
MapTable straight_table(const Rgb& low, const Rgb& high);

/// Footprints of any slopes and colors, with moments as a set has them.
FootprintData some_footprint(unsigned seed);

/// Nodes at angles that no bake begins with, all different, and an axis that is none of the map's.
VisibilityNodes some_nodes();

} // namespace scree::test
