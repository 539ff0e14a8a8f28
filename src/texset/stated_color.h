#pragma once

#include <array>
#include <optional>
#include <string>

namespace scree {

/// What a file's header holds about its colors, as OpenImageIO 2.4 hands it on.
struct ColorHeader {
    std::string
        space; ///< "sRGB", "Linear", "Gamma2.2", ...; often the format's habit, no statement
    std::optional<std::string> icc_profile; ///< description of an embedded profile, may be empty
    std::optional<std::array<float, 8>> chromaticities; ///< CIE x, y of red, green, blue, white
    bool aces_container = false;                        ///< SMPTE ST 2065-4 says it is ACES2065-1
};

/// Names of a color space, to be looked up in an OpenColorIO config.
struct StatedColor {
    std::string space;    ///< what the header says; empty: nothing
    std::string fallback; ///< to go by where the config does not know `space`; may be empty
};

/// What a header says of its colors.
///
/// Primaries of a known space (each coordinate within 1e-3) name that space, in linear light; other
/// primaries are spelled out, which no config knows. An ICC profile goes before the rest, as the
/// PNG standard wants it: one whose description contains "sRGB" is sRGB, unless it also says that
/// it is linear; another gives its description. A plain gamma of 2.2 may be read as sRGB: it is the
/// approximation of sRGB that the PNG standard has writers put beside it.
///
/// Names are printable ASCII of at most 80 characters, whatever the file holds.
StatedColor stated_color(const ColorHeader& header);

} // namespace scree
