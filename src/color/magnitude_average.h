#pragma once

#include "color/color_map.h"

namespace scree {

/// exp(-x) I0(x), the modified Bessel function kept from overflowing.
///
/// x      at least 0
/// error  relative, below 1e-13 [test: MagnitudeAverage.BesselFunctionMatchesItsIntegral]
double scaled_bessel_i0(double x);

/// E[map(|v|)], v a normal vector in the plane, alike in all directions: what a footprint shows
/// whose color goes by the steepness of the slope.
///
/// |v| follows Rice's law: density r / d^2 exp(-(r^2 + mean^2) / 2 d^2) I0(r mean / d^2).
///
/// mean       length of E[v]
/// deviation  d, of v along any direction; 0 gives map.at(mean) exactly
/// error      5e-9 of the color span [test: MagnitudeAverage.MatchesQuadratureOnMapsAtRandom]
/// not modelled: a spread of slopes that differs between directions
Rgb magnitude_average(const ColorMap& map, double mean, double deviation);

} // namespace scree
