#pragma once

#include "surface/mesh.h"

namespace scree {

/// The pieces that a mesh lies in on its texture: faces joined by edges whose ends have the same
/// texture coordinates on both sides.
struct UvCharts {
    int count = 0;
    int mirrored = 0; ///< of those, seen from their back: clockwise by the sum of their areas
};

UvCharts uv_charts(const Mesh& mesh);

} // namespace scree
