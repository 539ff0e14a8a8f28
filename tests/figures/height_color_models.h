#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figures/height_color_footprint.h"

namespace scree::test {

/// Truth: the color seen where a point of height rank u in its footprint is visible with
/// probability u^L.
///
///   sum_g c_g (U_g^(1+L) - U_(g-1)^(1+L)),   U_g the mass up to and with group g
///
/// A second opinion on stats/ranks.h: no line in common.
Color visible_color(const Footprint& footprint, double L);

/// What a file holds for a texel; the mean color comes first.
using Values = std::vector<double>;

/// A way to store color by height. Values are filtered linearly, then shown.
struct Model {
    std::string name;
    size_t channels;                                     // beside the mean color
    std::function<void(const Footprint&, Values&)> bake; // appends to the mean color
    std::function<Color(const Values&, double L)> show;
};

/// The mean color alone, color linear in the height, tables over height rank and bins of height,
/// by number of channels.
///
/// heights  of the whole map: what the models choose their units and bins by
std::vector<Model> height_color_models(std::vector<double> heights);

} // namespace scree::test
