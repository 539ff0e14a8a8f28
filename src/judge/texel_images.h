#pragma once

#include <functional>

#include "judge/set_reader.h"
#include "judge/shading.h"
#include "math/vec.h"
#include "reference/displaced_surface.h"
#include "texset/picture.h"

namespace scree {

/// A level seen from far away under one light, a pixel a texel: what a plain MIP chain shows, the
/// set, the reference, and how far the set is off. Texels of which nothing is seen are gray in the
/// reference, and count as no difference.
struct TexelImages {
    int level = 0;
    double angle_deg = 0;      ///< of the view, from the normal
    Picture plain, set, truth; ///< radiance times `exposure`
    Picture difference;        ///< |set - truth|, kDifferenceGain times brighter
    double exposure = 1;       ///< makes the brightest of the reference, but for 2 %, 0.8
};

constexpr double kDifferenceGain = 4;

/// The level whose longer side has at most `most` texels.
int level_to_draw(const Manifest& manifest, int most);

/// grid      grid x grid samples a texel
/// progress  as of reference::gather_all
TexelImages draw_texels(SetReader& set, const reference::DisplacedSurface& surface, int level,
                        const Vec3& wo, const Vec3& wi, const Material& material, int grid,
                        const std::function<void(double)>& progress);

} // namespace scree
