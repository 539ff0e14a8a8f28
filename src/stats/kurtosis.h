#pragma once

#include "stats/moment_layout.h"

namespace scree {

/// How heavy the tails of a footprint's slopes are.
struct Tail {
    double
        kurtosis; ///< Mardia's, 8 for a Gaussian, 16 for K0; 0 where nothing varies beyond rounding
    double tau;   ///< weight of K0 in the mixture (1 - tau) Gaussian + tau K0, in [0, 1]
};

/// Mardia's bivariate kurtosis of the slope and the mixture weight that matches it.
///
///   kurtosis = E[(d' C^-1 d)^2],  d = slope - mean
///   tau = (kurtosis - 8) / 8, clamped to [0, 1]
///
/// Where the slope varies along one line only (det C <= 1e-6 trace(C)^2: grooves) C has no
/// inverse; the kurtosis k1 = E[x^4] / E[x^2]^2 along that line, 3 for a Gaussian and 6 for K0,
/// takes its place: kurtosis = 8 k1 / 3, tau = (k1 - 3) / 3.
///
/// row, x  a row that carries the tail moments, and a texel of it
/// source  Mardia 1970; design.md section 5 for the mixture
Tail tail_of(const MomentLayout& layout, MomentRow row, int x);

} // namespace scree
