#pragma once

#include <functional>
#include <vector>

#include "judge/shading.h"
#include "tables/brdf_grid.h"

namespace scree {

/// R, G, B of a BRDF, 1 / sr. Called by several threads at once.
using BrdfFunction = std::function<Rgbf(const filter::Directions<double>&)>;

/// A BRDF at the nodes of a grid.
///
/// progress  told the share that is done, from one thread; may throw to stop the work
/// returns   nodes x 3, first axis fastest, then the second; the same for any number of threads
std::vector<float> brdf_table(const BrdfGrid& grid, const BrdfFunction& brdf,
                              const std::function<void(double)>& progress);

/// What the table's manifest says of it.
TableManifest brdf_manifest(const BrdfGrid& grid);

} // namespace scree
