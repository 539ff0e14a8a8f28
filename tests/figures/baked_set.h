#pragma once

#include <string>
#include <vector>

#include "chart/asset.h"
#include "judge/set_texel.h"
#include "reference/footprint.h"
#include "texset/manifest.h"

namespace scree::test {

/// Footprints of one size.
struct FootprintsOfSize {
    std::string name; ///< "16", "map"
    std::vector<reference::Footprint> places;
    int grid = 1; ///< grid x grid samples a footprint
};

/// A size of footprints to judge.
struct SizePlan {
    std::string name;
    int level = 0; ///< of the texels that have it; left out where the map ends before, or there
    int grid = 1;  ///< samples along a side
};

/// The whole map.
SizePlan map_size(int grid);

/// What to bake, and what to read of it.
struct SetPlan {
    std::vector<Map> maps; ///< Map::visible is one: of 8 azimuths
    int nodes = kDefaultNodes;
    PixelTypeChoice type = PixelTypeChoice::automatic;
    std::vector<SizePlan> sizes;
    bool axes = false; ///< tables along axes; else of all harmonics
};

/// Footprints and their texels, as they were baked.
struct PickedSize {
    FootprintsOfSize footprints;
    std::vector<SetTexel> texels;
};

/// What was read of a set: of each size 16 footprints, or as many as it has.
struct BakedSet {
    VisibilityRecord visibility; ///< how the texels' tables are laid out
    std::vector<PickedSize> sizes;
    double mean_color = 0; ///< of the map, rms over R, G, B
};

/// Bakes the asset into a folder that is gone after.
BakedSet bake_and_pick(const Asset& asset, const SetPlan& plan);

} // namespace scree::test
