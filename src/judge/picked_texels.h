#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "judge/set_reader.h"
#include "reference/gather.h"

namespace scree {

/// A texel of a set with the footprint it stands for.
struct PickedTexel {
    int level = 0, x = 0, y = 0;
    SetTexel texel;
    reference::Footprint footprint;
};

/// About evenly spread texels with data, `count` of every level or as many as it has, by a hash of
/// the seed: the same on every machine. Sorted by level and row. Of maps with little data fewer may
/// be found: places are drawn, 64 times `count` of a level at most.
///
/// first_level  the finest to pick from
std::vector<PickedTexel> pick_texels(SetReader& set, int first_level, int count, uint64_t seed);

/// What the reference sees of picked texels.
struct GatheredTexels {
    std::vector<reference::Estimate> truths; ///< one a texel
    long long samples = 0, rays = 0;         ///< taken of the surface, and cast from them
    double seconds = 0;                      ///< that they took
};

/// progress  as of reference::gather_all
GatheredTexels gather_texels(const reference::DisplacedSurface& surface,
                             const std::vector<PickedTexel>& texels,
                             const reference::GatherPlan& plan,
                             const std::function<void(double)>& progress);

} // namespace scree
