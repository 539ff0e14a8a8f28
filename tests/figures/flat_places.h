#pragma once

#include "reference/displaced_surface.h"

namespace scree::test {

/// What flat places of a surface, of slopes below 0.2, see along a view and the way it is mirrored
/// to; over all azimuths.
struct FlatPlaces {
    double open = 0;        ///< share that the view sees, of those that face both ways
    double open_both = 0;   ///< share that is open both ways
    double smith_both = 0;  ///< 1 / (1 + 2 Lambda) of the whole surface, Lambda = E[W] / cos - 1
    double height_rank = 0; ///< their mean; 1/2 where they lie like the rest
};

/// angle_deg  of the view from the normal
FlatPlaces flat_places(const reference::DisplacedSurface& surface, double angle_deg);

} // namespace scree::test
