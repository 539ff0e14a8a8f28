#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "color/color_map.h"

namespace scree {

/// E[map(X)] for a smooth density, by Gauss and Legendre's rule on every straight piece.
///
/// low, high  where the density is; what lies outside is not looked at
/// step       over which the density is nearly a polynomial: half a deviation of a normal law
/// density    of x, up to a factor, which cancels: the colors are divided by the sum of the
/// weights,
///            so that a constant map stays what it is and no color leaves the map's range
/// error      for a normal law and half a deviation 5e-9 of the color span
///            [test: MagnitudeAverage.MatchesQuadratureOnMapsAtRandom]
template <typename Density>
Rgb density_average(const ColorMap& map, double low, double high, double step,
                    const Density& density)
{
    // Nodes and weights on [0, 1]; two nodes do for pieces far shorter than a step.
    struct Node {
        double at, weight;
    };
    static constexpr std::array<Node, 4> kFour = {
        {{0.069431844202973712388, 0.17392742256872692869},
         {0.33000947820757186760, 0.32607257743127307131},
         {0.66999052179242813240, 0.32607257743127307131},
         {0.93056815579702628761, 0.17392742256872692869}}};
    static constexpr std::array<Node, 2> kTwo = {
        {{0.21132486540518711775, 0.5}, {0.78867513459481288225, 0.5}}};

    Rgb sum{};
    double total = 0;
    const auto add = [&](double x, double weight, const Rgb& a, const Rgb& b, double t) {
        const double mass = weight * density(x);
        total += mass;
        for (size_t c = 0; c < 3; ++c)
            sum[c] += mass * (a[c] + t * (b[c] - a[c]));
    };
    const auto add_piece = [&](double from, double to, const Rgb& a, const Rgb& b) {
        const double width = to - from;
        if (width < step / 16) {
            for (const Node& node : kTwo)
                add(from + node.at * width, node.weight * width, a, b, node.at);
            return;
        }
        const int parts = static_cast<int>(std::ceil(width / step));
        const double part = width / parts;
        for (int i = 0; i < parts; ++i)
            for (const Node& node : kFour)
                add(from + (i + node.at) * part, node.weight * part, a, b, (i + node.at) / parts);
    };

    const auto& knots = map.knots();
    auto knot = std::upper_bound(knots.begin(), knots.end(), low,
                                 [](double x, const Knot& k) { return x < k.x; });
    double from = low;
    Rgb color = map.at(low);
    if ((knot == knots.end() || knot->x > high) && map.at(high) == color)
        return color; // one color all over, as most of a map of few jumps is
    for (; knot != knots.end() && knot->x <= high; ++knot) {
        if (knot->x > from)
            add_piece(from, knot->x, color, knot->color);
        from = knot->x;
        color = knot->color;
    }
    if (from < high)
        add_piece(from, high, color, map.at(high));
    for (double& c : sum)
        c /= total;
    return sum;
}

} // namespace scree
