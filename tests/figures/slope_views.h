#pragma once

#include <array>
#include <vector>

#include "math/vec.h"

namespace scree::test {

/// Beckmann roughness of the facets that specular shading is tried with.
constexpr std::array<double, 2> kBaseAlphas = {0.3, 0.1};

/// Views and lights that visible slopes are tried with.
///
/// None of the azimuths is an axis or a diagonal of the map. Tables and gains are made of other
/// views than those they are judged by.
struct SlopeViews {
    SlopeViews();

    static constexpr size_t kNodes = 4;    ///< of a table: the first angles
    static constexpr size_t kAzimuths = 8; ///< of each angle, of those judged and of those fitted

    std::vector<double> angles_deg; ///< from the normal: the nodes, then two between them
    std::vector<Vec3> fitted;       ///< straight above, then node by node
    std::vector<Vec3> judged;       ///< angle by angle
    std::vector<Vec3> lights;
};

} // namespace scree::test
