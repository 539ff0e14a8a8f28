#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "color/color_map.h"

namespace scree {

/// A color map as its file states it: colors in the file's encoding, x in the file's units.
struct ColorMapFile {
    ColorMap map;
    /// x is in units of its own (meters, say); otherwise it runs from 0 to 1, or from -1 to 1, and
    /// is to be stretched over the range of what is mapped.
    bool states_range = false;
    /// Of a map whose halves are to be stretched separately, wherever it is stretched to: its place
    /// in the map, and the height it belongs to (sea level).
    std::optional<ColorMap::Hinge> hinge;
    /// What ColorConversion takes as `file_metadata`: a role or color space, empty when unknown.
    std::string color_space;
    std::string kind; ///< "cpt", "lut" or "image"
    /// Space to go by where the config does not know color_space, as of ImageInfo; may be empty.
    std::string color_fallback = {};
};

/// Reads a color map. The ending of its name decides how:
///
///   .cpt                    a color table of GMT, texset/cpt_file.h
///   what OpenColorIO knows  a 1-D LUT, texset/lut_file.h
///   anything else           an image whose first row is the map, texset/strip_file.h
///
/// Throws Error naming the file (and the line, of a text) and what was expected.
ColorMapFile read_color_map(const std::filesystem::path& path);

} // namespace scree
