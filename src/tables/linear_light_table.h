#pragma once

#include <array>
#include <functional>
#include <vector>

#include "texset/table_manifest.h"

namespace scree {

/// Number of texels along cos theta_v, cos theta_n and phi_n of a table of linear lights.
struct LinearLightResolution {
    int views = 32, normals = 128, azimuths = 64;
};

/// Where the reflection of a linear light is brightest, tabulated.
///
/// In the frame of the light (kernel/scree_linear_light.h) the normal of the surface is
/// (sin theta_n cos phi_n, sin theta_n sin phi_n, cos theta_n). The first texel of each axis has
/// its first value and the last its last: cos theta_v 0 to 1, cos theta_n -1 to 1, phi_n 0 to pi.
struct LinearLightTable {
    LinearLightResolution size;
    /// Phi, k, tan^2 alpha of each texel; cos theta_v fastest, then cos theta_n
    std::vector<float> values;

    [[nodiscard]] std::array<float, 3> at(int view, int normal, int azimuth) const;
};

/// size      each 2 or more
/// progress  told the share that is done, from one thread; may throw to stop the work
/// accuracy  of each texel, that of float (solved in double) [tests/tables/linear_light_table_test]
/// source    Bruneton, Rama, specular surfaces, section 2.3
LinearLightTable linear_light_table(const LinearLightResolution& size,
                                    const std::function<void(double)>& progress);

/// What the table's manifest says of it.
TableManifest linear_light_manifest(const LinearLightResolution& size);

} // namespace scree
