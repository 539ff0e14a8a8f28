#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/baked_map.h"
#include "pipeline/set_passes.h"

namespace scree {

/// measure() and write_textures() for all maps of a bake; they fill the levels of the manifest, or
/// of its tiles. A texture gets one pixel type for all tiles: half where it is good enough for
/// each.
///
/// heights  null for tiles: what views see is measured on single maps only
void measure_maps(const BakedMaps& maps, const HeightGrid* heights, SetPlan& plan,
                  Manifest& manifest);
void write_maps(const BakedMaps& maps, const HeightGrid* heights, SetPlan& plan, Manifest& manifest,
                const std::filesystem::path& folder);

/// The finest or the coarsest levels of all maps as one: root mean squares of the slope, and the
/// steepest texel; of the rest what the first map has.
enum class LevelEnd { finest, coarsest };
LevelSummary united_level(const BakedMaps& maps, const Manifest& manifest, LevelEnd end);

} // namespace scree
