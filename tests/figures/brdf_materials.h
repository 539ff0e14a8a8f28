#pragma once

#include <string>
#include <vector>

#include "tables/brdf_table.h"

namespace scree::test {

struct BrdfMaterial {
    std::string name;
    BrdfFunction brdf; ///< isotropic, reciprocal, without mirror images
};

/// A lobe, a varnish, velvet, a retro-reflector; bricks and a rock, baked, of their 4x4 texels.
///
/// data  folder of height maps; empty: a fractal instead of the rock
std::vector<BrdfMaterial> brdf_materials(const std::string& data);

} // namespace scree::test
