#pragma once

#include "stats/height_rows.h"

namespace scree {

/// Whether rays go on beyond an edge, in the map again or mirrored.
bool goes_on(Edge edge);

/// A height map that sweeps read rectangles of, at any level of its MIP chain.
///
/// Level l has max(1, floor(n / 2)) texels of level l - 1 along an axis. Each stands for what those
/// it covers hide from afar: halfway between their mean, which hides too little, and the highest of
/// them, which hides too much (coarser_heights(); measured in
/// tests/visibility/sweep_far_test.cpp). Heights are those
/// of the texel centres, world units, finite or NaN where there is no data. Sweeps reckon in
/// floats: subtract a large height that all have in common. Thread safe.
class HeightGrid {
public:
    struct Shape {
        int width = 1, height = 1;                ///< texels of level 0; >= 1
        double texel_width = 1, texel_height = 1; ///< world units
        /// What lies beyond; rays go on in a map that repeats or is mirrored (Edge::repeat).
        Edge edge_s = Edge::periodic, edge_t = Edge::periodic;
        double lowest = 0, highest = 0; ///< all heights lie between these
        float ground = 0;               ///< height of Edge::zero
        bool holes = false;             ///< some texels have no data
    };

    explicit HeightGrid(const Shape& shape) : shape_(shape) {}
    virtual ~HeightGrid() = default;

    [[nodiscard]] const Shape& shape() const { return shape_; }
    [[nodiscard]] int width(int level) const;
    [[nodiscard]] int height(int level) const;
    [[nodiscard]] int levels() const;

    /// A rectangle of a level, row by row, that may reach beyond the map.
    ///
    /// Beyond an axis that goes on lies the map again, or mirrored. Beyond the others there is, at
    /// level 0, one more texel, by Edge, so that the surface reaches the border, and then NaN; at
    /// coarser levels NaN at once.
    ///
    /// heights  gets rows x columns numbers
    void read(int level, int x0, int y0, int columns, int rows, float* heights) const;

protected:
    /// `count` heights of a row from column x on, all inside the map.
    virtual void read_row(int level, int x, int y, int count, float* heights) const = 0;

private:
    void read_line(int level, int x0, int y, int columns, float* heights) const;

    Shape shape_;
};

} // namespace scree
