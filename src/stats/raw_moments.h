#pragma once

#include <cstdint>

namespace scree {

/// Raw moments E[x], E[xx] from mean and variance, as a file stores them, for a run of texels.
///
/// The second moment is taken about the mean AS STORED (x^2 + variance), so the error of the
/// variance read back is the rounding of one number, not the difference of two; where rounding
/// still puts it below x^2, it is stepped up. So x^2 <= xx holds for the stored numbers exactly
/// and, rounding being monotonic, for a reader that squares in float32.
///
/// mean, variance  `count` numbers, at most kMergeRun, variance >= 0; what exceeds the type becomes
/// infinite (see
///                 pipeline/storage_error.h, which keeps `auto` from choosing such a type)
/// x, xx           the stored numbers, 32 bits for float and 16 for half (math/storage.h)
void store_pairs(const double* mean, const double* variance, int count, uint32_t* x, uint32_t* xx);
void store_pairs(const double* mean, const double* variance, int count, uint16_t* x, uint16_t* xx);

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
void store_slopes(const SlopeRun& run, int count, uint32_t* s, uint32_t* t, uint32_t* ss,
                  uint32_t* tt, uint32_t* st);
void store_slopes(const SlopeRun& run, int count, uint16_t* s, uint16_t* t, uint16_t* ss,
                  uint16_t* tt, uint16_t* st);

/// Numbers that are linear already: means, E[x y] with x and y given by other textures.
void store_values(const double* values, int count, uint32_t* stored);
void store_values(const double* values, int count, uint16_t* stored);

} // namespace scree
