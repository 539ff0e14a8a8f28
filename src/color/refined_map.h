#pragma once

#include <functional>

#include "color/color_map.h"

namespace scree {

/// The map without the knots that a straight line between others replaces.
///
/// tolerance  largest change of any channel anywhere, in units of the colors; at least 0
/// The ends, and both sides of every jump, stay as they are.
ColorMap without_collinear_knots(const ColorMap& map, double tolerance);

/// A map in scene-linear colors from one whose knots are encoded (sRGB, say), with lines straight
/// in that encoding.
///
/// convert    encoded color to scene-linear
/// tolerance  of the result against convert(encoded.at(x)), as a share of the largest converted
///            color of a knot; knots are put between those of `encoded` until it holds
/// returns    no more knots than that needs, within a factor of about two
/// not modelled: a conversion that wiggles between eighths of a piece without showing at them
ColorMap refined(const ColorMap& encoded, const std::function<Rgb(const Rgb&)>& convert,
                 double tolerance = 1e-5);

} // namespace scree
