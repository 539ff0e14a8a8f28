#pragma once

#include <filesystem>
#include <vector>

#include "judge/set_reader.h"
#include "kernel/brdf_coordinates.h"

namespace scree {

/// How what is baked of a level is made one isotropic BRDF.
struct EffectiveBrdfOptions {
    float base_alpha = 0.3F; ///< Beckmann roughness of a facet
    float f0 = 0.04F;        ///< Schlick's Fresnel reflectance at normal incidence
    /// Of the surface about its normal, 1 or more; every second one is the mirror image of the one
    /// before it.
    int turns = 16;
};

/// Throws Error when the set has no such level.
void expect_level(const std::filesystem::path& set, const Manifest& manifest, int level);

/// The BRDF that a level of a baked set has for those who see all of it at once, by the kernel.
///
/// The mean over the level's texels; over turns and mirror images of the surface, which makes it
/// isotropic: what a table without phi_h can hold of an anisotropic one; and over both ways of
/// light, which makes it reciprocal: LEADR's projected areas and the diffuse closed form are not.
class EffectiveBrdf {
public:
    /// set   folder or manifest. Throws Error when it cannot be read or has no such level.
    /// tile  UDIM number of a tile; 0: the set is one map
    EffectiveBrdf(const std::filesystem::path& set, int level, const EffectiveBrdfOptions& options,
                  int tile = 0);

    /// R, G, B in 1 / sr. Below a cosine of 0.02 the cosine that a radiance is divided by counts as
    /// that: a tilted texel is lit with the light at the horizon, so that its BRDF has no bound.
    [[nodiscard]] Rgbf operator()(const filter::Directions<double>& w) const;

private:
    std::vector<SetTexel> texels_;
    SetColors colors_;
    EffectiveBrdfOptions options_;
};

} // namespace scree
