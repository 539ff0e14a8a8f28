#pragma once

#include "math/storage.h"

namespace scree {

/// Raw moments E[x], E[xx] from mean and variance, as a file stores them, for a run of texels.
///
/// The second moment is taken about the mean AS STORED (x^2 + variance), so the error of the
/// variance read back is the rounding of one number, not the difference of two; where rounding
/// still puts it below x^2, it is stepped up. So x^2 <= xx holds for the stored numbers exactly
/// and, rounding being monotonic, for a reader that squares in float32.
///
/// mean, variance  `count` numbers, variance >= 0; what exceeds the type becomes infinite (see
///                 pipeline/storage_error.h, which keeps `auto` from choosing such a type)
/// x, xx           the stored numbers
template <class Store>
void store_pairs(const double* mean, const double* variance, int count, typename Store::Bits* x,
                 typename Store::Bits* xx);

/// Central moments of a run of slopes: mean and covariance, each an array.
struct SlopeRun {
    const double *s, *t, *ss, *tt, *st;
};

/// The same for slopes: the 2x2 covariance read back is positive semi-definite.
///
/// Rounding may push its determinant below 0 where |correlation| is nearly 1; then ss and tt are
/// stepped up together, at most a few units in the last place: each step adds
/// Ctt ulp(ss) + Css ulp(tt) >= 2 sqrt(Css Ctt ulp(ss) ulp(tt)) to the determinant, as much as the
/// rounding of st took from it.
template <class Store>
void store_slopes(const SlopeRun& slopes, int count, typename Store::Bits* s,
                  typename Store::Bits* t, typename Store::Bits* ss, typename Store::Bits* tt,
                  typename Store::Bits* st);

/// Numbers that are linear already: means, E[x y] with x and y given by other textures.
template <class Store>
void store_values(const double* values, int count, typename Store::Bits* stored)
{
    for (int i = 0; i < count; ++i)
        stored[i] = Store::nearest(values[i]);
}

} // namespace scree
