#pragma once

#include "reference/gather.h"
#include "support/memory_source.h"

namespace scree::test {

/// A map that repeats, texels of one unit, as the reference renderer has it.
reference::DisplacedSurface displaced(const MemorySource& map);

/// What a view sees of the whole map: degrees from the normal, azimuth from +s towards +t.
/// Half a million rays: colors to 0.0002, as the two halves of the samples tell.
reference::Seen seen_of_map(const reference::DisplacedSurface& surface, double angle_deg,
                            double azimuth_deg);

/// What a view sees of each texel of a level, 32x32 rays a texel; at most 16x16 texels, evenly.
struct SeenTexel {
    int x = 0, y = 0;
    reference::Seen seen;
};
std::vector<SeenTexel> seen_of_level(const reference::DisplacedSurface& surface, int level,
                                     double angle_deg, double azimuth_deg);

} // namespace scree::test
