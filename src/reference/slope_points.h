#pragma once

#include <array>
#include <vector>

#include "reference/relief.h"

namespace scree::reference {

/// How heights become slopes.
enum class Reconstruction {
    bilinear, ///< surface bilinear between texel centres; the slope varies inside a texel
    central,  ///< central difference, constant inside a texel
    sobel,    ///< 3x3 Sobel, constant inside a texel; with Beyond::extends it repeats the border
              ///< texel, for parity with maketx, so there a plane does not stay a plane
};

/// The slopes inside one texel, as points of equal cells: in a cell all pairs of an s slope and a
/// t slope, since ds h depends on the place along t alone and dt h on that along s.
///
/// The points of an axis are those of Gauss and Legendre, weights 5, 8, 5 of 18, exact to degree 5
/// (fourth moments need 4). A constant slope is one cell whose points are equal.
struct SlopePoints {
    int cells = 0; ///< 1 or 4
    std::array<std::array<double, 3>, 4> s{}, t{};
};

/// The heights of a relief as its slopes see them: continued beyond the edge, holes marked.
class HeightGrid {
public:
    /// weights  of the texels, height x width; 0: no data
    HeightGrid(const Relief& relief, const std::vector<double>& weights,
               Reconstruction reconstruction);

    /// Slopes of a texel with data. Neighbours without data are completed so that a plane stays a
    /// plane: an edge neighbour is mirrored through the centre from its opposite, or is the centre
    /// where that is missing too; a corner closes the parallelogram.
    [[nodiscard]] SlopePoints slopes(int x, int y) const;

private:
    /// [1 + j][1 + i]: height at offset (i, j) from the centre.
    using Neighbours = std::array<std::array<double, 3>, 3>;
    [[nodiscard]] Neighbours neighbours(int x, int y) const;

    Reconstruction reconstruction_;
    double texel_width_, texel_height_;
    int width_;                   ///< with the columns beyond both edges
    std::vector<double> heights_; ///< rows and columns -1 to n; NaN: no data
};

/// A slope that does not vary inside the texel.
SlopePoints constant_slope(double s, double t);

} // namespace scree::reference
