#pragma once

#include <vector>

#include "figures/light_measure.h"

namespace scree::test {

/// All figures as markdown, on stdout: of the light alone, then of view and light together; by
/// footprint, by angle and by surface.
///
/// The first way is what the others are held against.
void print_light_figures(const std::vector<LightFigures>& all);

} // namespace scree::test
