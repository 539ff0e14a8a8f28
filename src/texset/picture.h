#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace scree {

/// A picture to look at: scene-linear, Rec. 709 primaries, height x width x 3.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

/// The exposure that makes the brightest of some values, but for 2 %, 0.8; 1 where all are 0.
double fitting_exposure(std::vector<float> values);

/// Eight-bit sRGB PNG; values are clamped to [0, 1], NaN shows as magenta.
std::vector<uint8_t> png_bytes(const Picture& picture);

/// Throws Error as write_picture() would for what can be known beforehand: no such folder, a
/// device or a pipe of that name, or an ending that no picture format has.
void check_picture_name(const std::filesystem::path& file);

/// Writes the picture by the ending of its name: 8-bit sRGB for png, jpg and the like, scene-linear
/// for exr and hdr. The file appears whole or not at all. Throws Error, naming the file.
void write_picture(const Picture& picture, const std::filesystem::path& file);

} // namespace scree
