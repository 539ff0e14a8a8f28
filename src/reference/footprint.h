#pragma once

#include <vector>

namespace scree::reference {

/// What a footprint takes of the level-0 texels first, first + 1, ... along one axis.
struct AxisShares {
    int first = 0;
    std::vector<double> share; ///< sums to 1
};

/// A part of the relief: the product of its shares along s and t.
struct Footprint {
    AxisShares s, t;
};

/// Shares of texel `index` of a MIP level in the n level-0 texels of an axis.
///
/// Sizes follow max(1, floor(n / 2)); texel j of m takes [j n/m, (j + 1) n/m) of the level below,
/// and the levels are composed.
AxisShares axis_shares(int n, int level, int index);

/// The footprint of texel (x, y) of a level of a width x height map.
Footprint footprint_of(int width, int height, int level, int x, int y);

/// Levels of a map down to 1x1, and the size of one of them along an axis.
int level_count(int width, int height);
int level_size(int n, int level);

/// Positions along the shares of a footprint: what uniform numbers are turned into to sample it.
class SharePositions {
public:
    explicit SharePositions(const AxisShares& shares);

    /// The position, in texels, before which a share u in [0, 1) of the footprint lies.
    [[nodiscard]] double at(double u) const;

private:
    int first_;
    std::vector<double> edges_; ///< share that lies before each texel; the last: all of it
};

} // namespace scree::reference
