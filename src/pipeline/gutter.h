#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scree {

/// The gutter of a map: texels without data that filters reach from texels with data.
///
/// It grows in rings. The first are the texels without data that have one with data among their 8
/// neighbours, the second those that have one of the first ring among theirs. A texel of a ring
/// holds the mean of its neighbours of the ring before, each counted alike, as a lookup between
/// texels does not ask for their coverage either. Means of raw moments are the raw moments of the
/// neighbours side by side, so what is recovered of them is some surface's.
constexpr int kGutterRings = 2;

/// Number of the ring of a texel: 0 has data, 1 to kGutterRings are in the gutter.
using Ring = uint8_t;
constexpr Ring kBeyondGutter = 255; ///< no data, and not in a ring (yet)

/// A texel of the gutter.
struct GutterTexel {
    int x;
    uint8_t sources; ///< bit i: neighbour kNeighbours[i] is one of the ring before
};

struct Neighbour {
    int dx, dy;
};
constexpr std::array<Neighbour, 8> kNeighbours{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// Rings of three rows of texels, one upon the other.
struct RingRows {
    const Ring* above; ///< null: the map ends
    Ring* row;
    const Ring* below; ///< null: the map ends
};

/// Adds the texels of a row that belong to a ring, and marks them.
///
/// rows      complete up to the ring before
/// periodic  the first column is a neighbour of the last
/// ring      1 to kGutterRings
/// grown     gets them from left to right
void grow_ring(const RingRows& rows, int width, bool periodic, Ring ring,
               std::vector<GutterTexel>& grown);

} // namespace scree
