#pragma once

#include <utility>
#include <vector>

#include "figures/height_color_surface.h"

namespace scree::test {

/// Texels of one height: they hide one another in no order.
struct Group {
    double height = 0;
    double mass = 0; // part of the footprint's area
    Color color{};   // times mass
};

/// All level-0 texels under a filter, by rising height; the masses sum to 1.
using Footprint = std::vector<Group>;

/// Footprints side by side, each with its share of the whole.
Footprint mix(const std::vector<std::pair<const Footprint*, double>>& parts);

Color mean_color(const Footprint& footprint);

/// The footprints of one MIP level.
struct FootprintLevel {
    int size = 0; // texels along a side
    std::vector<Footprint> texels;

    /// x, y  in [-size, 2 size), brought inside periodically
    size_t index(int x, int y) const
    {
        return static_cast<size_t>((y + size) % size * size + (x + size) % size);
    }
};

FootprintLevel finest(const Surface& surface);
FootprintLevel coarser(const FootprintLevel& fine);

} // namespace scree::test
