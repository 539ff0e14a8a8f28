#pragma once

#include "color/map_table.h"
#include "reference/relief.h"

namespace scree {

/// E[c | h] over a whole relief: the color map by height that explains most of its colors.
///
/// 256 bins between the lowest and the highest height; a knot at the mean height and color of each
/// that is not empty, straight lines between. Where color is not a function of height this is the
/// best that a model which takes it for one can have.
///
/// relief  with colors, and data somewhere
/// h0, h1  normalised height is (h - h0) / h1; so is the map's x
ColorMap color_by_height(const reference::Relief& relief, double h0, double h1);

/// The map averaged over normal laws of any mean within it, and deviations to half its width, the
/// most there can be.
MapTable filtered_by_height(const ColorMap& map);

} // namespace scree
