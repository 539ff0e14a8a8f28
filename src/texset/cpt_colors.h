#pragma once

#include <optional>
#include <string>

#include "color/color_map.h"

namespace scree {

/// A color as a .cpt writes it.
struct CptColor {
    Rgb value{};      ///< RGB in [0, 1]; or hue in degrees, saturation and value in [0, 1]
    bool hsv = false; ///< which of the two
};

/// Hue (degrees, of any number of turns), saturation, value to RGB; all RGB as encoded as it comes.
Rgb rgb_of_hsv(const Rgb& hsv);

/// RGB in [0, 1] to hue in [0, 360), saturation, value; hue 0 for grays.
Rgb hsv_of_rgb(const Rgb& rgb);

/// Three numbers as a color, by the file's color model.
/// Empty when one is out of range: 0..255 for RGB; 0..360, 0..1, 0..1 for HSV.
std::optional<CptColor> cpt_color(const Rgb& numbers, bool hsv_model);

/// One word as a color: r/g/b (h/s/v in a file of that model), h-s-v, a gray number, #rrggbb, or a
/// name; with @transparency, which does not count.
/// Empty when it is none of these or out of range.
std::optional<CptColor> cpt_color(const std::string& word, bool hsv_model);

/// A finite decimal number, the whole of the text; empty otherwise. Whatever the locale.
std::optional<double> decimal_number(const std::string& text);

} // namespace scree
