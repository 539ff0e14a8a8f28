#pragma once

#include <array>
#include <string>
#include <vector>

#include "kernel/brdf_coordinates.h"
#include "texset/table_manifest.h"

namespace scree {

enum class BrdfParametrization { half_difference, orthographic, hybrid };

/// Where the nodes of the first two axes lie.
enum class BrdfSpacing {
    even,  ///< at even steps of theta_h, theta_d, or of lengths
    root,  ///< of the first axis at squares of even steps, dense where lobes are
    angle, ///< as root, but of angles whose sines the lengths are: half/difference is as root
};

/// Where an isotropic BRDF is tabulated: over (theta_h, theta_d, phi_d), (|h_bar|, |k_bar|,
/// azimuth) or (|h_bar|, |k|, azimuth), azimuth = phi_k - phi_h. Reciprocity and mirror images
/// leave [0, pi/2] of the azimuth; the others reach to pi/2 or 1. The first node of an axis has its
/// first value and the last its last.
struct BrdfGrid {
    BrdfParametrization parametrization = BrdfParametrization::hybrid;
    std::array<int, 3> size = {32, 32, 16}; ///< each 2 or more
    BrdfSpacing spacing = BrdfSpacing::angle;
    /// The second axis is a share of what two directions above the surface have of it
    /// (scree_*_reach): no node is wasted. Else absolute, and nodes beyond are those of the end.
    bool fitted = true;

    [[nodiscard]] size_t nodes() const;
    /// Directions of a node, the half vector's azimuth 0.
    [[nodiscard]] filter::Directions<double> directions(int first, int second, int azimuth) const;
    /// Where directions lie between the nodes: 0 to size - 1 along each axis.
    [[nodiscard]] std::array<double, 3> place(const filter::Directions<double>& w) const;
    /// The axes as a manifest has them.
    [[nodiscard]] std::vector<TableAxis> axes() const;
};

/// "half-difference", "orthographic", "hybrid".
std::string name_of(BrdfParametrization parametrization);

/// What stands in a table, linear between nodes.
///
/// values  nodes x channels, first axis fastest, then the second
std::vector<double> look_up(const BrdfGrid& grid, const std::vector<float>& values, int channels,
                            const filter::Directions<double>& w);

} // namespace scree
