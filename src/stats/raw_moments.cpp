#include "stats/raw_moments.h"

namespace scree {

namespace {

/// Steps `second` up until it is not below `square`, the exact square of a stored number: the
/// nearest stored number can be below it by less than one step.
template <class Store>
void keep_above(double square, typename Store::Bits& second)
{
    if (Store::value(second) < square)
        second = step_up<Store>(second);
}

/// Determinant of the covariance that a reader recovers.
template <class Store>
double determinant(double s, double t, typename Store::Bits ss, typename Store::Bits tt,
                   typename Store::Bits st)
{
    const double cov_st = Store::value(st) - s * t;
    return (Store::value(ss) - s * s) * (Store::value(tt) - t * t) - cov_st * cov_st;
}

template <class Store>
void make_semi_definite(double s, double t, typename Store::Bits& ss, typename Store::Bits& tt,
                        typename Store::Bits st)
{
    // 3 steps are enough by the bound in the header; numbers beyond the type's range never get
    // there, and are not this function's to mend.
    for (int step = 0; step < 8 && determinant<Store>(s, t, ss, tt, st) < 0; ++step) {
        ss = step_up<Store>(ss);
        tt = step_up<Store>(tt);
    }
}

} // namespace

template <class Store>
void store_pairs(const double* mean, const double* variance, int count, typename Store::Bits* x,
                 typename Store::Bits* xx)
{
    for (int i = 0; i < count; ++i) {
        x[i] = Store::nearest(mean[i]);
        const double square = Store::value(x[i]) * Store::value(x[i]); // exact in double
        xx[i] = Store::nearest(square + variance[i]);
        keep_above<Store>(square, xx[i]);
    }
}

template <class Store>
void store_slopes(const SlopeRun& slopes, int count, typename Store::Bits* s,
                  typename Store::Bits* t, typename Store::Bits* ss, typename Store::Bits* tt,
                  typename Store::Bits* st)
{
    store_pairs<Store>(slopes.s, slopes.ss, count, s, ss);
    store_pairs<Store>(slopes.t, slopes.tt, count, t, tt);
    for (int i = 0; i < count; ++i)
        st[i] = Store::nearest(Store::value(s[i]) * Store::value(t[i]) + slopes.st[i]);

    // Hardly any texel needs mending, so look first, in a loop without branches.
    int indefinite = 0;
    for (int i = 0; i < count; ++i)
        indefinite += determinant<Store>(Store::value(s[i]), Store::value(t[i]), ss[i], tt[i],
                                         st[i]) < 0;
    for (int i = 0; indefinite > 0 && i < count; ++i)
        make_semi_definite<Store>(Store::value(s[i]), Store::value(t[i]), ss[i], tt[i], st[i]);
}

template void store_pairs<StoreFloat>(const double*, const double*, int, uint32_t*, uint32_t*);
template void store_pairs<StoreHalf>(const double*, const double*, int, uint16_t*, uint16_t*);
template void store_slopes<StoreFloat>(const SlopeRun&, int, uint32_t*, uint32_t*, uint32_t*,
                                       uint32_t*, uint32_t*);
template void store_slopes<StoreHalf>(const SlopeRun&, int, uint16_t*, uint16_t*, uint16_t*,
                                      uint16_t*, uint16_t*);

} // namespace scree
