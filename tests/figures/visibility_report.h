#pragma once

#include <vector>

#include "figures/visibility_measure.h"

namespace scree::test {

/// All figures as markdown, on stdout: of all surfaces together, then surface by surface.
///
/// The first model is what the others are held against.
void print_figures(const std::vector<SurfaceFigures>& all, const AllViews& views);

/// Only those of all surfaces together.
void print_summary(const std::vector<SurfaceFigures>& all);

} // namespace scree::test
