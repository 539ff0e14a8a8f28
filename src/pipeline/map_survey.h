#pragma once

#include "pipeline/baked_map.h"
#include "pipeline/map_lanes.h"

namespace scree {

/// Surveys all maps of a bake: their heights get one normalisation, their texels on a mesh one
/// unit of weight, and where their borders meet they know of each other's heights.
///
/// Tiles without any data are left out, with a warning. Throws Error where nothing is left.
///
/// Borders of maps on a mesh meet where the surface goes on, those of tiles on a plane with
/// BakeOptions::udim_wrap.
void survey_maps(BakedMaps& maps, const BakeOptions& options, const BakeMonitor& monitor,
                 std::vector<std::string>& warnings);

/// What a texel of weight 1 stands for in each map, in one unit for all.
std::vector<double> texel_areas(const BakedMaps& maps);

/// Widths of the maps, texels.
std::vector<int> widths_of(const BakedMaps& maps);

} // namespace scree
