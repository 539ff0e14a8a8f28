#include "stats/raw_moments.h"

#include "math/storage.h"

namespace scree {

namespace {

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

template <class Store>
[[gnu::always_inline]] inline void pairs(const double* mean, const double* variance, int count,
                                         typename Store::Bits* __restrict x,
                                         typename Store::Bits* __restrict xx)
{
    using Bits = typename Store::Bits;
    for (int i = 0; i < count; ++i) {
        const Bits stored = Store::nearest(mean[i]);
        const double square = Store::value(stored) * Store::value(stored); // exact in double
        const Bits second = Store::nearest(square + variance[i]);
        x[i] = stored;
        // The nearest stored number can be below the square by less than one step.
        xx[i] = static_cast<Bits>(second + (Store::value(second) < square ? 1 : 0));
    }
}

template <class Store>
[[gnu::always_inline]] inline void
slopes(const SlopeRun& run, int count, typename Store::Bits* __restrict s,
       typename Store::Bits* __restrict t, typename Store::Bits* __restrict ss,
       typename Store::Bits* __restrict tt, typename Store::Bits* __restrict st)
{
    pairs<Store>(run.s, run.ss, count, s, ss);
    pairs<Store>(run.t, run.tt, count, t, tt);
    for (int i = 0; i < count; ++i)
        st[i] = Store::nearest(Store::value(s[i]) * Store::value(t[i]) + run.st[i]);

    // Hardly any texel needs mending, so look first, in a loop without branches.
    int indefinite = 0;
    for (int i = 0; i < count; ++i)
        indefinite +=
            determinant<Store>(Store::value(s[i]), Store::value(t[i]), ss[i], tt[i], st[i]) < 0 ? 1
                                                                                                : 0;
    for (int i = 0; indefinite > 0 && i < count; ++i)
        make_semi_definite<Store>(Store::value(s[i]), Store::value(t[i]), ss[i], tt[i], st[i]);
}

} // namespace

// One function a type, not a template, since only functions can be cloned for a processor.

[[gnu::target_clones("avx2", "default")]] void
store_pairs(const double* mean, const double* variance, int count, uint32_t* x, uint32_t* xx)
{
    pairs<StoreFloat>(mean, variance, count, x, xx);
}

[[gnu::target_clones("avx2", "default")]] void
store_pairs(const double* mean, const double* variance, int count, uint16_t* x, uint16_t* xx)
{
    pairs<StoreHalf>(mean, variance, count, x, xx);
}

[[gnu::target_clones("avx2", "default")]] void store_slopes(const SlopeRun& run, int count,
                                                            uint32_t* s, uint32_t* t, uint32_t* ss,
                                                            uint32_t* tt, uint32_t* st)
{
    slopes<StoreFloat>(run, count, s, t, ss, tt, st);
}

[[gnu::target_clones("avx2", "default")]] void store_slopes(const SlopeRun& run, int count,
                                                            uint16_t* s, uint16_t* t, uint16_t* ss,
                                                            uint16_t* tt, uint16_t* st)
{
    slopes<StoreHalf>(run, count, s, t, ss, tt, st);
}

[[gnu::target_clones("avx2", "default")]] void store_values(const double* values, int count,
                                                            uint32_t* stored)
{
    for (int i = 0; i < count; ++i)
        stored[i] = StoreFloat::nearest(values[i]);
}

[[gnu::target_clones("avx2", "default")]] void store_values(const double* values, int count,
                                                            uint16_t* stored)
{
    for (int i = 0; i < count; ++i)
        stored[i] = StoreHalf::nearest(values[i]);
}

} // namespace scree
