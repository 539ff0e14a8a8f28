#pragma once

#include <vector>

#include "math/storage.h"
#include "stats/moment_layout.h"
#include "stats/ranks.h"
#include "texset/channels.h"
#include "texset/manifest.h"
#include "visibility/visibility_plan.h"

namespace scree {

/// What the numbers of a map need besides moments.
struct ValueScale {
    double h0 = 0, h1 = 1;  ///< back from normalised to world height, for the bumpslopes layout
    bool has_height = true; ///< without, the bumpslopes height is -1, as maketx writes it
    std::vector<ExponentFit> exponents = {}; ///< a level, of Map::exponent
};

/// Sizes of the tables that come in several.
struct TableSizes {
    int rank_terms = kDefaultRankTerms; ///< 1 to kMaxRankTerms
    VisibilityPlan visibility = {};     ///< of Map::visible
    VisibilityPlan tried = {};          ///< another, to choose from
};

/// The channels of a map for a run of texels, as the file stores them.
///
/// level   of the texels
/// row     moments, at texel 0 of the run
/// count   texels, at most kTileSize
/// stored  one array of `count` numbers a channel, in the order of MapInfo::channels
template <class Store>
void texture_values(Map map, const MomentLayout& layout, int level, MomentRow row, int count,
                    const ValueScale& scale, typename Store::Bits* const* stored);

/// The most channels a map has.
constexpr int kMostChannels = kMostVisibleChannels;
static_assert(kMostVisibleChannels ==
              MomentLayout::kVisiblePlanes * kMaxNodes * (1 + 2 * kMaxHarmonics));

/// Which moments a map needs.
///
/// tables  sizes of those of rank and of visibility
void require_moments(Map map, const TableSizes& tables, MomentSet& set);

} // namespace scree
