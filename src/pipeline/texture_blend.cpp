#include "pipeline/texture_blend.h"

#include <algorithm>
#include <optional>

#include "math/storage.h"
#include "stats/raw_moments.h"
#include "texset/mip_file.h"

namespace scree {

namespace {

/// Which channels are raw moments of slopes.
struct SlopeChannels {
    int s, t, ss, tt, st;

    [[nodiscard]] bool has(int channel) const
    {
        return channel == s || channel == t || channel == ss || channel == tt || channel == st;
    }
};

std::optional<SlopeChannels> slope_channels(Map map)
{
    switch (map) {
    case Map::slope: // s ss st t tt
        return SlopeChannels{0, 3, 1, 4, 2};
    case Map::bumpslopes: // h s t ss tt st
        return SlopeChannels{1, 2, 3, 4, 5};
    default:
        return std::nullopt;
    }
}

/// E[x y] - E[x] E[y]; in double, of means of stored floats: good to 1e-16 of the square, a
/// billionth of the last digit that a file holds of it.
void covariance(const double* xy, const double* x, const double* y, int count, double* out)
{
    for (int i = 0; i < count; ++i)
        out[i] = xy[i] - x[i] * y[i];
}

void variance(const double* xx, const double* x, int count, double* out)
{
    covariance(xx, x, x, count, out);
    for (int i = 0; i < count; ++i)
        out[i] = std::max(out[i], 0.0);
}

template <class Store>
void store_slope_blend(const SlopeChannels& at, const double* const* means, int count,
                       typename Store::Bits* const* stored)
{
    double ss[kTileSize], tt[kTileSize], st[kTileSize];
    variance(means[at.ss], means[at.s], count, ss);
    variance(means[at.tt], means[at.t], count, tt);
    covariance(means[at.st], means[at.s], means[at.t], count, st);
    store_slopes({means[at.s], means[at.t], ss, tt, st}, count, stored[at.s], stored[at.t],
                 stored[at.ss], stored[at.tt], stored[at.st]);
}

} // namespace

template <class Store>
void store_blend(Map map, int channels, const double* const* means, int count,
                 typename Store::Bits* const* stored)
{
    if (map == Map::height) { // h hh
        double hh[kTileSize];
        variance(means[1], means[0], count, hh);
        store_pairs(means[0], hh, count, stored[0], stored[1]);
        return;
    }
    const auto slope = slope_channels(map);
    if (slope)
        store_slope_blend<Store>(*slope, means, count, stored);
    for (int c = 0; c < channels; ++c)
        if (!slope || !slope->has(c))
            store_values(means[c], count, stored[c]);
}

template void store_blend<StoreFloat>(Map, int, const double* const*, int,
                                      StoreFloat::Bits* const*);
template void store_blend<StoreHalf>(Map, int, const double* const*, int, StoreHalf::Bits* const*);

} // namespace scree
