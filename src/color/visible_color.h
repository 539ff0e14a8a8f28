#pragma once

#include "color/color_map.h"

namespace scree {

/// What a view sees of a map over normal heights, under Smith's masking.
///
/// A point at height quantile q survives with probability q^exponent, so that visible heights have
/// the density (1 + exponent) phi Phi^exponent, in deviations from the mean, and
///
///   visible color = integral of map(mean + deviation z) (1 + exponent) phi(z) Phi(z)^exponent dz
///
/// This is what the table of means and deviations stands in for (shortcut_error.h).
///
/// mean, deviation  of the heights in the footprint, in the map's units; deviation 0: map.at(mean)
/// exponent         Lambda of the view (plus that of the light), in [0, 1e6]
/// error            1e-8 of the color span [test: VisibleColor.MatchesQuadratureOnMapsAtRandom]
/// source           docs/filtering.md, "Visible height and color"
Rgb visible_color(const ColorMap& map, double mean, double deviation, double exponent);

} // namespace scree
