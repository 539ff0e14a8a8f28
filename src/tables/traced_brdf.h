#pragma once

#include <cstdint>
#include <vector>

#include "kernel/brdf_coordinates.h"
#include "reference/displaced_surface.h"
#include "tables/brdf_table.h"

namespace scree {

/// How the BRDF of a surface is measured by rays.
struct TracedBrdfOptions {
    double base_alpha = 0.3; ///< Beckmann roughness of a facet, > 0
    double f0 = 0.04;        ///< Schlick's Fresnel reflectance at normal incidence
    int grid = 64;           ///< grid x grid jittered samples of the surface, > 0
    uint64_t seed = 1;
};

/// The BRDF that a displaced surface has for those who see all of it at once, by the reference's
/// rays: the truth that EffectiveBrdf stands for.
///
///   f = E[Vo Vi (Wo Wi c / (pi sqrt(1 + |slope|^2)) + F lobe)] / (cos theta_o cos theta_i)
///
/// E the mean over the surface by area and weight, over turns and mirror images of it; W, V of
/// reference/gather.h, lobe of MirrorLobe in reference/facet.h, F Schlick's. One bounce. Reciprocal
/// as it stands, isotropic and without mirror images to the noise.
///
/// Every pair of directions takes the same samples, each with a turn of its own: tables are as
/// smooth as that allows, and what interpolation leaves can be told from noise, which another seed
/// shows.
class TracedBrdf {
public:
    /// surface  is kept and must outlive this; rays must reach its end (judge/ray_reach.h)
    TracedBrdf(const reference::DisplacedSurface& surface, const TracedBrdfOptions& options);

    /// R, G, B in 1 / sr. A direction below a cosine of 0.02 is raised to it: level rays end
    /// nowhere.
    [[nodiscard]] Rgbf operator()(const filter::Directions<double>& w) const;

private:
    struct Sample {
        double s, t; ///< texels
        reference::SurfacePoint point;
        double cosine, sine; ///< of the turn
        bool mirrored;
    };

    const reference::DisplacedSurface& surface_;
    TracedBrdfOptions options_;
    std::vector<Sample> samples_; ///< with data
    double weight_ = 0;           ///< of all
};

} // namespace scree
