#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace scree::test {

using Color = std::array<double, 3>; // scene-linear

/// A color over a height, texel by texel; square, continued periodically.
struct Surface {
    std::string name;
    int size = 0;                // texels along a side
    std::vector<double> heights; // size x size, in the units of the file
    std::vector<Color> colors;   // size x size
};

/// Scanned and built materials, terrain with snow, samples and a Gaussian field: 128 texels along a
/// side or more, for lookups down to level 7.
///
/// data  the folder of real data beside the project
/// Throws Error when a file of it is missing: a median over fewer surfaces is another figure.
std::vector<Surface> height_color_surfaces(const std::filesystem::path& data);

} // namespace scree::test
