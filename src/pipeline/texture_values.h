#pragma once

#include "math/storage.h"
#include "stats/moment_layout.h"
#include "stats/ranks.h"
#include "texset/channels.h"

namespace scree {

/// What the numbers of a map need besides moments.
struct ValueScale {
    double h0 = 0, h1 = 1;  ///< back from normalised to world height, for the bumpslopes layout
    bool has_height = true; ///< without, the bumpslopes height is -1, as maketx writes it
};

/// The channels of a map for a run of texels, as the file stores them.
///
/// row     moments, at texel 0 of the run
/// count   texels, at most kTileSize
/// stored  one array of `count` numbers a channel, in the order of MapInfo::channels
template <class Store>
void texture_values(Map map, const MomentLayout& layout, MomentRow row, int count,
                    const ValueScale& scale, typename Store::Bits* const* stored);

/// The most channels a map has.
constexpr int kMostChannels = 3 * kMaxRankTerms;

/// Which moments a map needs.
///
/// rank_terms  of a rank table, 1 to kMaxRankTerms
void require_moments(Map map, int rank_terms, MomentSet& set);

} // namespace scree
