#pragma once

#include <cstdint>
#include <vector>

#include "judge/set_reader.h"
#include "reference/footprint.h"

namespace scree {

/// A texel of a set with the footprint it stands for.
struct PickedTexel {
    int level = 0, x = 0, y = 0;
    SetTexel texel;
    reference::Footprint footprint;
};

/// About evenly spread texels with data, `count` of every level or as many as it has, by a hash of
/// the seed: the same on every machine. Sorted by level and row. Of maps
/// with little data fewer may be found: places are drawn, 64 times `count` of a level at most.
///
/// first_level  the finest to pick from
std::vector<PickedTexel> pick_texels(SetReader& set, int first_level, int count, uint64_t seed);

} // namespace scree
