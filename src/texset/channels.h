#pragma once

#include <string>
#include <vector>

namespace scree {

/// The textures of a set.
enum class Map {
    slope,
    height,
    color,
    colorheight,
    colorslope,
    rank,
    map,
    tail,
    coverage,
    bumpslopes
};

/// One texture of a set: what its file is called and what its channels hold.
struct MapInfo {
    Map map;
    std::string name;                  ///< file is NAME.<name>.exr
    std::vector<std::string> channels; ///< in the order an OpenImageIO reader sees them; of the
                                       ///< rank table with the default number of terms
    std::string meaning;               ///< one line, written into the file and the manifest
};

/// The one table of texture and channel names; writer, manifest, shaders and README follow it.
///
/// OpenEXR sorts channels by name and OpenImageIO moves R, G, B to the front, so the slope reads
/// s ss st t tt and color-slope Bs Bt Gs Gt Rs Rt.
const std::vector<MapInfo>& map_table();

const MapInfo& map_info(Map map);

/// Channels of a rank table: B1 B2 ... BK G1 ... GK R1 ... RK, as they sort.
///
/// terms  1 to 8
std::vector<std::string> rank_channels(int terms);

constexpr int kDefaultRankTerms = 4;

/// The texture of that name.
/// Throws Error naming the known ones when there is none. `bumpslopes` and `coverage` are not
/// names a user gives: a layout and the inputs decide on them.
Map map_named(const std::string& name);

/// Names a user may give, comma separated.
std::string map_names();

} // namespace scree
