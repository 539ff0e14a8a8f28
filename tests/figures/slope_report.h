#pragma once

#include "figures/slope_pooling.h"

namespace scree::test {

/// All figures as markdown, on stdout, in percent.
///
/// plane  of base masking, on a surface without slopes
void print_slope_figures(const SurfacesSlopeFigures& all, const BaseMaskingFigures& plane,
                         const SlopeViews& views);

} // namespace scree::test
