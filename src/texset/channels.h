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
    exponent,
    colorslope,
    rank,
    visible,
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
                                       ///< tables of rank and visibility with the default sizes
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

constexpr int kDefaultNodes = 4;
constexpr int kMostVisibleChannels = 4 * 6 * (1 + 2 * 2);

/// The first level of a table of visibility that holds anything. A texel of level 0 has one color,
/// which is seen as it is whatever hides it: zeros tell that, and are three quarters of the file
/// that compress to nothing.
constexpr int kFirstSeenLevel = 1;

/// Channels of a table of visibility, node by node, as they sort: 1A 1B 1G 1R of the mean over the
/// azimuth, then, as far as there are harmonics, 1c1A ... of cos phi, 1c2A ... of cos 2 phi,
/// 1s1A ... of sin phi, 1s2A ... of sin 2 phi; then 2A ...
///
/// nodes      1 to 6
/// harmonics  0 to 2
std::vector<std::string> visible_channels(int nodes, int harmonics);

/// The same of one along two axes: 1A 1B 1G 1R of what is alike from all sides, 1xnA ... against
/// the first axis, 1xpA ... along it, 1ynA ... and 1ypA ... of the second; then 2A ...
std::vector<std::string> visible_channels_along_axes(int nodes);

/// The texture of that name.
/// Throws Error naming the known ones when there is none. `bumpslopes` and `coverage` are not
/// names a user gives: a layout and the inputs decide on them.
Map map_named(const std::string& name);

/// Names a user may give, comma separated.
std::string map_names();

} // namespace scree
