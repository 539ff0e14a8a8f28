#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "math/vec.h"
#include "reference/displaced_surface.h"
#include "reference/footprint.h"

namespace scree::reference {

/// What one view sees of a footprint; W = max(0, wo.z - wo . slope), V is 1 where nothing hides
/// the point, E[.] the mean over the footprint by area and weight.
struct Seen {
    double facing = 0;                  ///< E[W], projected area of what faces the view
    double area = 0;                    ///< E[V W], projected area that is seen
    Rgb color{};                        ///< E[V W c] / E[V W]
    Vec2 slope{0, 0};                   ///< E[V W slope] / E[V W]
    std::array<double, 3> covariance{}; ///< of the slopes seen: ss, st, tt

    /// Share of the facing area that is seen; 0 where none faces.
    [[nodiscard]] double g1() const { return facing > 0 ? area / facing : 0; }
};

/// The same under one directional light.
struct Lit {
    double share = 0; ///< E[Vo Vi W] / E[Vo W], of what is seen, whether it faces the light or not
    Rgb color{};      ///< E[Vo Vi W c] / E[Vo Vi W]: of what is seen and open to the light
    Rgb diffuse{};    ///< E[Vo Vi W c max(0, n . wi)] / (pi E[Vo W]): radiance over irradiance
    double white = 0; ///< that of a white surface: diffuse / white is the color that is seen lit
    double specular = 0; ///< E[Vo Vi G2 p(slope of h - slope)] / (4 h.z^4 E[Vo W]), likewise
};

/// Radiance over irradiance of facets that mirror the share f0 of the light.
Rgb radiance_of(const Lit& lit, double f0);

struct Gathered {
    std::vector<Seen> seen; ///< one a view
    std::vector<Lit> lit;   ///< views x lights
};

/// What to gather.
struct GatherPlan {
    std::vector<Vec3> views, lights; ///< unit, away from the surface, z > 0
    /// Beckmann roughness of the facets: each has Gaussian slopes of variance base_alpha^2 / 2
    /// about its own, which hide the share 1 - G2 of each other (facet.h). > 0
    double base_alpha = 0.2;
    int grid = 32;     ///< grid x grid jittered samples a footprint
    uint64_t seed = 1; ///< equal seeds, equal numbers, whatever the threads
};

/// A footprint as it is gathered, and what that is worth.
///
/// What nothing was seen of, or no sample lay on, is 0: area, slope, color and the rest.
struct Estimate {
    Gathered all;
    /// Of every other sample: of each 2x2 block of the grid one diagonal each, by chance which.
    /// Half their difference has about the standard deviation of `all`, one draw of it: take its
    /// mean square over many values. It says too much, not too little, where the grid is finer than
    /// the texels. With grid = 1 one of them is of no sample.
    std::array<Gathered, 2> halves;
    int samples = 0;    ///< that lay on data
    long long rays = 0; ///< cast
};

/// Gathers a footprint: casts a ray for each sample and view that its face is turned to, and, where
/// any view sees it, for each light it is turned to.
///
/// index  of the footprint, so that no two share their jitter
Estimate gather(const DisplacedSurface& surface, const Footprint& footprint, const GatherPlan& plan,
                uint64_t index);

/// The same for many footprints, on all cores; the index of each is its place in the list.
///
/// progress  is told the share done, in [0, 1], from one thread at a time; it may throw to stop
std::vector<Estimate> gather_all(const DisplacedSurface& surface,
                                 const std::vector<Footprint>& footprints, const GatherPlan& plan,
                                 const std::function<void(double)>& progress = {});

} // namespace scree::reference
