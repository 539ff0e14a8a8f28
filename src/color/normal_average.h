#pragma once

#include "color/color_map.h"

namespace scree {

/// E[map(X)], X normal with a mean and a standard deviation: what a footprint whose heights are
/// spread so shows from above.
///
///   map(-inf) + sum of rise_i * mean of P(X > x) over piece i
///
/// Rise is how much the color changes over a piece or at a jump. P(X > x) = Phi((mean - x) /
/// deviation), whose integral is elementary: z Phi(z) + phi(z).
///
/// mean, deviation  in units of the map's x; deviation 0 gives map.at(mean) exactly
/// error   1e-12 of the color span [test: NormalAverage.MatchesQuadratureOnMapsAtRandom]; pieces
///         beyond 9 deviations from the mean are left out, which is below 1e-18 of it
/// source  integration by parts
Rgb normal_average(const ColorMap& map, double mean, double deviation);

} // namespace scree
