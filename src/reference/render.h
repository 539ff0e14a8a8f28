#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "reference/camera.h"
#include "reference/displaced_surface.h"

namespace scree::reference {

/// A part of a picture: columns [first_column, first_column + columns), rows [0, rows).
struct PictureArea {
    int first_column = 0;
    int columns = 1, rows = 1;
};

/// How the surface is lit and sampled.
struct RenderPlan {
    Vec3 light{0, 0, 1}; ///< unit, to a directional light; z > 0
    /// Beckmann roughness of the facets, as GatherPlan has it.
    double base_alpha = 0.2;
    int grid = 8; ///< grid x grid jittered rays a pixel
    uint64_t seed = 1;
};

/// Radiance over irradiance, mean over the rays of a pixel that meet data; the sums of a facet
/// that is lit are as in Lit.
struct Radiance {
    double covered = 0;  ///< share of the rays that meet data, by its weight
    Rgb diffuse{};       ///< color max(0, n . wi) / pi
    double specular = 0; ///< the facets' lobe, for a reflectance of 1
};

/// A pixel, and what it is worth: `halves` are of every other ray, as of Estimate.
struct RenderedPixel {
    Radiance all;
    std::array<Radiance, 2> halves;
};

struct Rendering {
    std::vector<RenderedPixel> pixels; ///< area.rows x area.columns
    long long rays = 0;                ///< cast, to the viewer and to the light
};

/// Ray traces a part of a picture of the surface, on all cores: rays through jittered places of
/// every pixel, and from where they meet the surface to the light.
///
/// progress  as of gather_all
Rendering render(const DisplacedSurface& surface, const Camera& camera, const PictureArea& area,
                 const RenderPlan& plan, const std::function<void(double)>& progress = {});

} // namespace scree::reference
