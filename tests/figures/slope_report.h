#pragma once

#include "figures/slope_pooling.h"

namespace scree::test {

/// All figures as markdown, on stdout, in percent.
void print_slope_figures(const SurfacesSlopeFigures& all, const SlopeViews& views);

} // namespace scree::test
