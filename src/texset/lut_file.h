#pragma once

#include <filesystem>
#include <string>

#include "texset/color_map_file.h"

namespace scree {

/// Whether OpenColorIO reads LUTs from files that end so: ".spi1d", in lower case.
bool is_lut_ending(const std::string& ending);

/// A color map from a 1-D LUT, read by OpenColorIO: what it makes of the gray (x, x, x).
///
/// x runs over the LUT's own domain ("From" of .spi1d, DOMAIN_MIN and _MAX of .cube); the largest,
/// where those of the channels differ; states_range when that is not [0, 1]. Knots are at the
/// entries of the LUT; where there are several LUTs in a row, or one that is not evenly spaced, at
/// 65537 places. Knots that a straight line replaces to float precision are left out.
/// Colors are the numbers that come out: the scene_linear role.
///
/// Throws Error when OpenColorIO cannot read the file, when it holds no 1-D LUT, mixes channels
/// (a 3-D LUT), or holds or gives numbers that are not finite.
ColorMapFile read_lut(const std::filesystem::path& path);

} // namespace scree
