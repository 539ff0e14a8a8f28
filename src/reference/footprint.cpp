#include "reference/footprint.h"

#include <algorithm>
#include <cassert>

namespace scree::reference {
namespace {

/// The same part of the axis in texels of the level below, which has `fine_size` of them.
AxisShares finer(const AxisShares& coarse, long long coarse_size, long long fine_size)
{
    // Places times coarse_size are whole numbers, so a border that falls on a texel's edge does so
    // exactly.
    const auto count = static_cast<long long>(coarse.share.size());
    const long long first = coarse.first * fine_size / coarse_size;
    const long long end =
        ((coarse.first + count) * fine_size + coarse_size - 1) / coarse_size; // rounded up
    AxisShares fine{static_cast<int>(first), std::vector<double>(static_cast<size_t>(end - first))};
    for (long long k = 0; k < count; ++k) {
        const long long from = (coarse.first + k) * fine_size, to = from + fine_size;
        for (long long i = from / coarse_size; i * coarse_size < to; ++i) {
            const long long overlap =
                std::min(to, (i + 1) * coarse_size) - std::max(from, i * coarse_size);
            fine.share[static_cast<size_t>(i - first)] += coarse.share[static_cast<size_t>(k)] *
                                                          static_cast<double>(overlap) /
                                                          static_cast<double>(fine_size);
        }
    }
    return fine;
}

} // namespace

int level_size(int n, int level)
{
    for (; level > 0 && n > 1; --level)
        n /= 2;
    return n;
}

int level_count(int width, int height)
{
    int count = 1;
    for (int n = std::max(width, height); n > 1; n /= 2)
        ++count;
    return count;
}

AxisShares axis_shares(int n, int level, int index)
{
    assert(index >= 0 && index < level_size(n, level));
    AxisShares shares{index, {1.0}};
    for (; level > 0; --level)
        shares = finer(shares, level_size(n, level), level_size(n, level - 1));
    return shares;
}

Footprint footprint_of(int width, int height, int level, int x, int y)
{
    return {axis_shares(width, level, x), axis_shares(height, level, y)};
}

SharePositions::SharePositions(const AxisShares& shares) : first_(shares.first)
{
    edges_.reserve(shares.share.size() + 1);
    edges_.push_back(0);
    for (const double share : shares.share)
        edges_.push_back(edges_.back() + share);
}

double SharePositions::at(double u) const
{
    // The last texel with no more than u before it.
    const auto next = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, u);
    const auto texel = next - edges_.begin() - 1;
    const double inside = (u - *(next - 1)) / (*next - *(next - 1));
    // Rounding must not carry a position into the texel after it.
    return first_ + static_cast<double>(texel) + std::min(inside, 1 - 0x1p-32);
}

} // namespace scree::reference
