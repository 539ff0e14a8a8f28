#pragma once

#include "texset/channels.h"

namespace scree {

/// Means of several texels' numbers, as a file stores them.
///
/// Second moments are taken about the means as stored, see stats/raw_moments.h: what rounding does
/// to the blend makes no variance and no determinant negative.
///
/// map       any but the table of a color map
/// channels  how many it has
/// means     `count` numbers a channel, in the order of MapInfo::channels
/// count     texels, at most kTileSize
/// stored    likewise
template <class Store>
void store_blend(Map map, int channels, const double* const* means, int count,
                 typename Store::Bits* const* stored);

} // namespace scree
