#pragma once

#include <string>
#include <vector>

#include "color/color_map.h"
#include "pipeline/options.h"
#include "pipeline/survey.h"
#include "texset/color_map_file.h"
#include "texset/manifest.h"

namespace scree {

/// A color map read from its file, its colors scene-linear, not yet where it belongs.
struct ColorMapInput {
    ColorMapFile file;
    std::string path;
    InputRecord record;
    std::string working_space;
    std::vector<std::string> notes; ///< what a user should know of its colors
};

/// Throws Error as read_color_map() and ColorConversion do.
ColorMapInput read_color_map_input(const BakeOptions& options);

/// A color map that colors texels.
struct MappedColor {
    ColorMap map; ///< by world height, or by slope
    MapBy by = MapBy::height;
    double azimuth_s = 1, azimuth_t = 0; ///< direction of MapBy::slope

    /// Color of a texel.
    ///
    /// height  world units;  s, t  its mean slope; of these only what `by` names
    [[nodiscard]] Rgb at(double height, double s, double t) const;

    /// For texels without data: the map averaged over a normal law of the heights' mean and
    /// deviation; of a slope map the color of a level surface.
    [[nodiscard]] Rgb without_data(const Survey& survey) const;
};

/// Puts a map where it belongs: its ends at options.map_range; or where its file says; or, where
/// the file knows only 0 to 1, at the lowest and highest height there is.
///
/// Throws Error for a map by slope whose range nobody states.
MappedColor placed(const ColorMapInput& input, const BakeOptions& options, const Survey& survey);

} // namespace scree
