#pragma once

#include <array>
#include <vector>

namespace scree::reference {

using Rgb = std::array<double, 3>;

/// What lies beyond the edge of a relief, and how it goes on for rays that leave it.
enum class Beyond {
    repeats, ///< the relief again; rays go on in it
    mirrors, ///< the relief mirrored; rays go on in it
    extends, ///< the last bilinear cell, half a texel of it; rays that leave are free
    ends,    ///< height 0, half a texel of a bilinear cell towards it; rays that leave are free
};

/// Heights and colors of a surface, texel by texel: the inputs themselves, nothing filtered.
///
/// All grids are height x width, row 0 at t = 0, s to the right, t down, texel centres at +0.5.
struct Relief {
    int width = 0, height = 0;
    std::vector<double> heights;              ///< world units; NaN: no data
    std::vector<Rgb> colors;                  ///< scene-linear; empty: white
    std::vector<float> weights;               ///< empty: 1; 0: no data
    double texel_width = 1, texel_height = 1; ///< world units
    Beyond beyond_s = Beyond::repeats, beyond_t = Beyond::repeats;
};

} // namespace scree::reference
