#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "reference/displaced_surface.h"
#include "tables/brdf_table.h"

namespace scree::test {

struct BrdfMaterial {
    std::string name;
    BrdfFunction brdf; ///< isotropic, reciprocal, without mirror images
};

/// A lobe, a varnish, velvet, a retro-reflector.
std::vector<BrdfMaterial> brdf_formulas();

/// A surface, both ways; facets of base_alpha 0.2 and f0 0.04.
struct BrdfSurface {
    std::string name;
    std::shared_ptr<const reference::DisplacedSurface> surface;
    /// Of the texels of a level, by the kernel.
    ///
    /// side  texels along each axis; a power of 2
    std::function<BrdfFunction(int side)> baked;
    /// By rays.
    ///
    /// grid  grid x grid samples of the surface
    std::function<BrdfFunction(int grid, uint64_t seed)> traced;
};

/// Bricks and a rock.
///
/// data  folder of height maps; empty: a fractal instead of the rock
std::vector<BrdfSurface> brdf_surfaces(const std::string& data);

} // namespace scree::test
