#pragma once

#include <vector>

#include "pipeline/map_edges.h"
#include "texset/udim.h"

namespace scree {

/// A map among others, as far as its borders go.
struct BorderedMap {
    UdimTile tile;
    int width = 1, height = 1;
    MapEdges edges;
};

/// What lies beyond the sides of a map: its neighbours' texels.
///
/// Maps on a mesh meet texel by texel, where both sides of the border are one place of the surface,
/// to half a texel; maps on a plane meet all along. Of a neighbour of another resolution heights
/// are taken at places between its texels, linear from texel to texel, so that a plane over both
/// maps stays one; of corners only where all resolutions are the same.
///
/// maps                  in any order
/// wraps_s, wraps_t      a map without a neighbour meets its own other side
Surroundings surroundings_of(const BorderedMap& map, const std::vector<BorderedMap>& maps,
                             bool wraps_s, bool wraps_t);

} // namespace scree
