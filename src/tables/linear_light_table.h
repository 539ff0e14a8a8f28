#pragma once

#include <functional>
#include <vector>

#include "kernel/linear_light.h"
#include "texset/table_manifest.h"

namespace scree {

/// What a table of linear lights is laid out over, and holds.
enum class LinearLightCoordinates {
    /// cos theta_v 0 to 1, cos theta_n -1 to 1, phi_n 0 to pi, in the frame of the light
    /// (kernel/scree_linear_light.h) with the normal (sin theta_n cos phi_n, sin theta_n sin phi_n,
    /// cos theta_n): Phi, k, tan^2 alpha
    angles,
    /// cos theta_v 0 to 1, the normal by scree_linear_cone_coordinates: its stretch, from which the
    /// rest follows in closed form
    cone
};

/// Texels along the three axes, each 2 or more.
struct LinearLightResolution {
    int views = 0, normals = 0, azimuths = 0;
};

/// Over angles the source's, 32x128x64. Over the cone 32x64x32: what a lookup adds stays below a
/// tenth of the Gaussian's own error [tests/tables/linear_light_table_test.cpp]; over angles no
/// useful size does that (docs/tables.md).
LinearLightResolution usual_resolution(LinearLightCoordinates coordinates);

/// Where the reflection of a linear light is brightest, tabulated. The first texel of each axis
/// holds its first value and the last its last.
struct LinearLightTable {
    LinearLightCoordinates coordinates = LinearLightCoordinates::cone;
    LinearLightResolution size;
    std::vector<float> values; ///< of each texel; first axis fastest, then the second

    [[nodiscard]] size_t channels() const
    {
        return coordinates == LinearLightCoordinates::angles ? 3 : 1;
    }

    /// As a shader looks it up: linear in all three coordinates.
    [[nodiscard]] filter::LinearPeak<float> peak(const Imath::V3f& viewer,
                                                 const Imath::V3f& normal) const;
};

/// progress  told the share that is done, from one thread; may throw to stop the work
/// error     of each texel that of float: solved in double
///           [tests/tables/linear_light_table_test.cpp]
/// source    Bruneton, Rama, specular surfaces, section 2.3; cone: docs/linear-lights.md
LinearLightTable linear_light_table(LinearLightCoordinates coordinates,
                                    const LinearLightResolution& size,
                                    const std::function<void(double)>& progress);

/// What the table's manifest says of it.
TableManifest linear_light_manifest(LinearLightCoordinates coordinates,
                                    const LinearLightResolution& size);

} // namespace scree
