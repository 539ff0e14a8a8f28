#include "stats/raw_moments.h"

#include "math/storage.h"
#include "stats/merge.h"

namespace scree {

namespace {

/// Stored numbers of a run, as 32-bit words.
using Words = uint32_t[kMergeRun];

template <class Bits>
[[gnu::always_inline]] inline void narrow(const Words& words, int count, Bits* stored)
{
    for (int i = 0; i < count; ++i)
        stored[i] = static_cast<Bits>(words[i]);
}

/// Determinant of the covariance that a reader recovers.
template <class Store>
[[gnu::always_inline]] inline double determinant(double s, double t, uint32_t ss, uint32_t tt,
                                                 uint32_t st)
{
    const double cov_st = Store::value(st) - s * t;
    return (Store::value(ss) - s * s) * (Store::value(tt) - t * t) - cov_st * cov_st;
}

template <class Store>
void make_semi_definite(double s, double t, uint32_t& ss, uint32_t& tt, uint32_t st)
{
    // 3 steps are enough by the bound in the header; numbers beyond the type's range never get
    // there, and are not this function's to mend.
    for (int step = 0; step < 8 && determinant<Store>(s, t, ss, tt, st) < 0; ++step) {
        ss = step_up(ss);
        tt = step_up(tt);
    }
}

template <class Store>
[[gnu::always_inline]] inline void pairs(const double* mean, const double* variance, int count,
                                         Words& x, Words& xx)
{
    for (int i = 0; i < count; ++i) {
        x[i] = Store::nearest(mean[i]);
        const double square = Store::value(x[i]) * Store::value(x[i]); // exact in double
        const uint32_t second = Store::nearest(square + variance[i]);
        // The nearest stored number can be below the square by less than one step.
        xx[i] = Store::value(second) < square ? step_up(second) : second;
    }
}

template <class Store>
[[gnu::always_inline]] inline void
slopes(const SlopeRun& run, int count, typename Store::Bits* out_s, typename Store::Bits* out_t,
       typename Store::Bits* out_ss, typename Store::Bits* out_tt, typename Store::Bits* out_st)
{
    Words s, t, ss, tt, st;
    pairs<Store>(run.s, run.ss, count, s, ss);
    pairs<Store>(run.t, run.tt, count, t, tt);
    for (int i = 0; i < count; ++i)
        st[i] = Store::nearest(Store::value(s[i]) * Store::value(t[i]) + run.st[i]);

    // Hardly any texel needs mending, so look first, in a loop without branches.
    Words negative;
    for (int i = 0; i < count; ++i) {
        const double det =
            determinant<Store>(Store::value(s[i]), Store::value(t[i]), ss[i], tt[i], st[i]);
        negative[i] = det < 0 ? 1 : 0;
    }
    uint32_t indefinite = 0;
    for (int i = 0; i < count; ++i)
        indefinite += negative[i];
    for (int i = 0; indefinite > 0 && i < count; ++i)
        make_semi_definite<Store>(Store::value(s[i]), Store::value(t[i]), ss[i], tt[i], st[i]);

    narrow(s, count, out_s);
    narrow(t, count, out_t);
    narrow(ss, count, out_ss);
    narrow(tt, count, out_tt);
    narrow(st, count, out_st);
}

template <class Store>
[[gnu::always_inline]] inline void stored_pairs(const double* mean, const double* variance,
                                                int count, typename Store::Bits* out_x,
                                                typename Store::Bits* out_xx)
{
    Words x, xx;
    pairs<Store>(mean, variance, count, x, xx);
    narrow(x, count, out_x);
    narrow(xx, count, out_xx);
}

template <class Store>
[[gnu::always_inline]] inline void stored_values(const double* values, int count,
                                                 typename Store::Bits* stored)
{
    Words words;
    for (int i = 0; i < count; ++i)
        words[i] = Store::nearest(values[i]);
    narrow(words, count, stored);
}

} // namespace

// One function a type, not a template, since only functions can be cloned for a processor.

[[gnu::target_clones("avx2", "default")]] void
store_pairs(const double* mean, const double* variance, int count, uint32_t* x, uint32_t* xx)
{
    stored_pairs<StoreFloat>(mean, variance, count, x, xx);
}

[[gnu::target_clones("avx2", "default")]] void
store_pairs(const double* mean, const double* variance, int count, uint16_t* x, uint16_t* xx)
{
    stored_pairs<StoreHalf>(mean, variance, count, x, xx);
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
    stored_values<StoreFloat>(values, count, stored);
}

[[gnu::target_clones("avx2", "default")]] void store_values(const double* values, int count,
                                                            uint16_t* stored)
{
    stored_values<StoreHalf>(values, count, stored);
}

} // namespace scree
