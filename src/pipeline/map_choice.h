#pragma once

#include <vector>

#include "pipeline/options.h"
#include "pipeline/source.h"
#include "pipeline/texture_values.h"
#include "stats/moment_layout.h"

namespace scree {

/// The maps of a set: those asked for, or all that the inputs allow, in the order of map_table().
///
/// has_color  the source's own, or by a color map
/// complete   every texel has data; otherwise a coverage map joins them
/// Throws Error when a map that was asked for needs what the inputs do not have.
std::vector<Map> choose_maps(const Source& source, const BakeOptions& options, bool has_color,
                             bool complete);

/// Sizes of the tables among the maps, of visibility without nodes where there is none; for
/// BakeOptions::auto_maps with one along axes to try besides. Axes lie along s.
TableSizes tables_of(const std::vector<Map>& maps, const BakeOptions& options);

/// Whether something among the maps is measured on the heights, and with them the models of color.
bool needs_views(const std::vector<Map>& maps, const BakeOptions& options);

/// The moments that maps need, and those that the fit report takes besides.
///
/// tables  sizes of those of rank and of visibility
/// views   single views that a measurement takes besides
MomentLayout moments_for(const std::vector<Map>& maps, const TableSizes& tables, int views,
                         const Source& source, const BakeOptions& options);

} // namespace scree
