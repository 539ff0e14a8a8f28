#include "pipeline/texture_values.h"

#include <algorithm>
#include <cassert>

#include "stats/kurtosis.h"
#include "stats/raw_moments.h"
#include "texset/mip_file.h"

namespace scree {

namespace {

/// E[x y] = cov(x, y) + E[x] E[y].
template <class Store>
void store_products(const double* covariance, const double* x, const double* y, int count,
                    typename Store::Bits* stored)
{
    double product[kTileSize];
    for (int i = 0; i < count; ++i)
        product[i] = covariance[i] + x[i] * y[i];
    store_values(product, count, stored);
}

SlopeRun slope_run(const MomentLayout& layout, MomentRow row)
{
    return {row.plane(layout.slope_s), row.plane(layout.slope_t), row.plane(layout.slope_ss),
            row.plane(layout.slope_tt), row.plane(layout.slope_st)};
}

} // namespace

template <class Store>
void texture_values(Map map, const MomentLayout& layout, int level, MomentRow row, int count,
                    const ValueScale& scale, typename Store::Bits* const* stored)
{
    assert(count <= kTileSize);
    double scratch[kTileSize];
    switch (map) {
    case Map::slope: // s ss st t tt
        store_slopes(slope_run(layout, row), count, stored[0], stored[3], stored[1], stored[4],
                     stored[2]);
        break;
    case Map::height:
        store_pairs(row.plane(layout.height), row.plane(layout.height_var), count, stored[0],
                    stored[1]);
        break;
    case Map::color:
        for (int c = 0; c < 3; ++c)
            store_values(row.plane(layout.color + c), count, stored[c]);
        break;
    case Map::colorheight:
        for (int c = 0; c < 3; ++c)
            store_products<Store>(row.plane(layout.color_height + c), row.plane(layout.color + c),
                                  row.plane(layout.height), count, stored[c]);
        break;
    case Map::exponent: { // the same all over a level
        const ExponentFit& fit = scale.exponents[static_cast<size_t>(level)];
        const double numbers[] = {fit.gain, fit.power, fit.threshold};
        for (int c = 0; c < 3; ++c) {
            std::fill_n(scratch, count, numbers[c]);
            store_values(scratch, count, stored[c]);
        }
        break;
    }
    case Map::colorslope: // Bs Bt Gs Gt Rs Rt
        for (int c = 0; c < 3; ++c) {
            const double* color = row.plane(layout.color + c);
            store_products<Store>(row.plane(layout.color_slope_s + c), color,
                                  row.plane(layout.slope_s), count, stored[4 - 2 * c]);
            store_products<Store>(row.plane(layout.color_slope_t + c), color,
                                  row.plane(layout.slope_t), count, stored[5 - 2 * c]);
        }
        break;
    case Map::rank: // B1 ... BK G1 ... GK R1 ... RK
        for (int n = 0; n < layout.rank_terms; ++n)
            for (int c = 0; c < 3; ++c)
                store_values(row.plane(layout.rank + 3 * n + c), count,
                             stored[(2 - c) * layout.rank_terms + n]);
        break;
    case Map::visible: // A B G R of every component; see kFirstSeenLevel
        std::fill_n(scratch, count, 0.0);
        for (int i = 0; i < MomentLayout::kVisiblePlanes * layout.visible_components; ++i)
            store_values(level < kFirstSeenLevel ? scratch : row.plane(layout.visible + i), count,
                         stored[i]);
        break;
    case Map::tail:
        for (int i = 0; i < count; ++i)
            scratch[i] = tail_of(layout, row, i).tau;
        store_values(scratch, count, stored[0]);
        break;
    case Map::coverage:
        store_values(row.plane(MomentLayout::weight), count, stored[0]);
        break;
    case Map::map:
        assert(false && "a table of its own, see pipeline/color_table.h");
        break;
    case Map::bumpslopes: // h s t ss tt st
        for (int i = 0; i < count; ++i)
            scratch[i] = scale.has_height ? row.plane(layout.height)[i] * scale.h1 + scale.h0 : -1;
        store_values(scratch, count, stored[0]);
        store_slopes(slope_run(layout, row), count, stored[1], stored[2], stored[3], stored[4],
                     stored[5]);
        break;
    }
}

template void texture_values<StoreFloat>(Map, const MomentLayout&, int, MomentRow, int,
                                         const ValueScale&, StoreFloat::Bits* const*);
template void texture_values<StoreHalf>(Map, const MomentLayout&, int, MomentRow, int,
                                        const ValueScale&, StoreHalf::Bits* const*);

void require_moments(Map map, const TableSizes& tables, MomentSet& set)
{
    switch (map) {
    case Map::slope:
        set.slope = true;
        break;
    case Map::height:
        set.height = true;
        break;
    case Map::color:
        set.color = true;
        break;
    case Map::colorheight:
        set.color = set.height = set.color_height = true;
        break;
    case Map::colorslope:
        set.color = set.slope = set.color_slope = true;
        break;
    case Map::rank: // with the variance of color, which its fit is held against
        set.color = set.height = set.color_height = true;
        set.rank_terms = tables.rank_terms;
        break;
    case Map::visible:
        set.color = true;
        set.visible_nodes = static_cast<int>(tables.visibility.node_angles_deg.size());
        set.visible_terms = tables.visibility.terms();
        set.tried = tables.tried.components();
        break;
    case Map::tail:
        set.slope = set.tail = true;
        break;
    case Map::exponent: // read with colorheight
        set.color = set.height = set.color_height = true;
        break;
    case Map::map: // looked up with moments that other maps hold
    case Map::coverage:
        break;
    case Map::bumpslopes: // its height is dropped again for a normal map, see bake.cpp
        set.slope = set.height = true;
        break;
    }
}

} // namespace scree
