#pragma once

#include <vector>

#include "reference/gather.h"

namespace scree::test {

/// All of a relief.
inline reference::Footprint whole(const reference::Relief& relief)
{
    return reference::footprint_of(relief.width, relief.height,
                                   reference::level_count(relief.width, relief.height) - 1, 0, 0);
}

/// Every value of an estimate that is a mean over samples.
inline std::vector<double> values(const reference::Gathered& g)
{
    std::vector<double> all;
    for (const reference::Seen& s : g.seen)
        all.insert(all.end(), {s.facing, s.area, s.color[0], s.color[1], s.color[2], s.slope.x,
                               s.slope.y, s.covariance[0], s.covariance[1], s.covariance[2]});
    for (const reference::Lit& l : g.lit)
        all.insert(all.end(), {l.share, l.color[0], l.color[1], l.color[2], l.diffuse[0],
                               l.diffuse[1], l.diffuse[2], l.white, l.specular});
    return all;
}

} // namespace scree::test
