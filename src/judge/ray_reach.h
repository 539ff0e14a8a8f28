#pragma once

#include <string>

#include "reference/displaced_surface.h"

namespace scree {

/// Why rays cannot be followed over a surface in sensible time; empty: they can.
///
/// A ray that leaves a low place is free above the highest one only: at an elevation e over a map
/// of width w that goes on along its way it crosses range / (w tan(e)) images of it. Where heights
/// range over more than 100 widths of the map, 1100 at 5 degrees, it is taken for a mistake in the
/// scale.
std::string too_high_for_rays(const reference::DisplacedSurface& surface);

} // namespace scree
