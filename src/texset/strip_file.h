#pragma once

#include <filesystem>

#include "texset/color_map_file.h"

namespace scree {

/// A color map from the first row of an image: its first texel is the low end, its last the high
/// end, straight lines between their centres, x from 0 to 1. One texel is a map of one color.
///
/// Channels named R, G, B; or else the first one, as gray. Alpha does not count, but color that the
/// file multiplied with it is divided by it.
/// Throws Error when the image cannot be read, or a texel of the row is no number or, its color
/// multiplied by alpha, has none.
ColorMapFile read_strip(const std::filesystem::path& path);

} // namespace scree
