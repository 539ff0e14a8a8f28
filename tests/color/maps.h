#pragma once

#include <functional>
#include <string>
#include <vector>

#include "color/color_map.h"

namespace scree::test {

/// A map with a name for messages.
struct NamedMap {
    std::string name;
    ColorMap map;
};

/// 0 below x, (1, 0.5, -2) above.
ColorMap step_map(double x);
/// 0 up to a, (1, 0.5, -2) from b.
ColorMap ramp_map(double a, double b);
/// 0 outside (a, c), (1, 0.5, -2) at b.
ColorMap hat_map(double a, double b, double c);
/// 24 knots from 0 to 1 at random: jumps, flat pieces, pieces 1e-9 wide.
ColorMap random_map(unsigned seed);

/// Every color map of the folder of real data, as its file has it; empty where that is absent.
std::vector<NamedMap> real_maps();

/// Oracle: the map by its definition, knot after knot.
Rgb color_by_definition(const std::vector<Knot>& knots, double x);

/// Oracle: the integral of map times density from low to high, by Gauss and Kronrod's rule on
/// pieces between knots and of at most `step`.
Rgb average_by_quadrature(const ColorMap& map, double low, double high, double step,
                          const std::function<double(double)>& density);

/// Oracle: E[map(X)], X normal.
Rgb normal_by_quadrature(const ColorMap& map, double mean, double deviation);

/// Oracle: E[map(|v|)], v a normal vector in the plane; its density around the circle is summed.
/// mean / deviation up to 20
Rgb magnitude_by_quadrature(const ColorMap& map, double mean, double deviation);

/// Oracle: E[map(X)], X with the distribution function Phi^(1 + exponent), from that function and
/// the map's rises: the density does not come into it.
Rgb visible_by_quadrature(const ColorMap& map, double mean, double deviation, double exponent);

double largest_difference(const Rgb& a, const Rgb& b);

} // namespace scree::test
