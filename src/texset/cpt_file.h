#pragma once

#include <filesystem>

#include "texset/color_map_file.h"

namespace scree {

/// A color table of the Generic Mapping Tools.
///
/// Lines `z0 color z1 color [L|U|B] [;label]` are straight pieces that must follow on each other;
/// lines `z color [;label]` are categories, whose colors reach halfway to the next. Colors as in
/// texset/cpt_colors.h, or three numbers with blanks between. In a file of the model HSV the pieces
/// are straight in hue, saturation and value: knots are added so that RGB is right to 1e-5.
///
/// z from 0 to 1 or from -1 to 1 is to be stretched, and with `# HARD_HINGE` its halves
/// separately, z = 0 staying at `# HINGE = v`, or 0. `# RANGE = a/b` does so right away, to a and
/// b, with `# SOFT_HINGE` too. Any other z is in units of its own. B and F lines color what is
/// below and above a map that states its range; nothing is, of a stretched one. N lines, for no
/// data, do not count. Colors are RGB / 255 of a picture: sRGB.
///
/// Throws Error naming the file and the line of what cannot be used: also cyclic tables, CMYK,
/// patterns, skipped pieces, and more than 65536 lines of colors.
ColorMapFile read_cpt(const std::filesystem::path& path);

} // namespace scree
