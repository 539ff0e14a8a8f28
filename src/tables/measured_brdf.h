#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tables/brdf_table.h"

namespace scree {

/// What a table is made of.
struct BrdfSource {
    BrdfFunction brdf;
    BrdfFunction again; ///< the same from other samples, to tell the noise; empty: has none
};

struct MeasuredBrdf {
    std::vector<float> values; ///< as of brdf_table()
    /// By region of brdf_regions(): "rms error in %, hybrid, all" is what interpolation leaves,
    /// "rms noise in %, all" what the source itself is uncertain by.
    std::vector<TableFigure> figures;
};

/// Tabulates a BRDF and measures what interpolation leaves of it, at 1000 pairs of each region.
///
/// compare   also tabulates it in the other parametrizations with as many nodes, to measure them
/// progress  as of brdf_table()
MeasuredBrdf measured_brdf(const BrdfGrid& grid, const BrdfSource& source, bool compare,
                           const std::function<void(double)>& progress);

} // namespace scree
