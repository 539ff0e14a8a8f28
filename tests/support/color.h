#pragma once

#include <OpenImageIO/imageio.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "support/files.h"

namespace scree::test {

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>; ///< rows

Rgb times(const Matrix& m, const Rgb& v);

/// CIE x, y of red, green, blue and white.
using Primaries = std::array<double, 8>;

constexpr Primaries kRec709 = {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
constexpr Primaries kRec2020 = {0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290};
constexpr Primaries kP3D65 = {0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290};
constexpr Primaries kAp0 = {0.7347, 0.2653, 0, 1, 0.0001, -0.0770, 0.32168, 0.33767};
constexpr Primaries kAp1 = {0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767};

/// Linear light of one set of primaries to another: through XYZ, white to white by Bradford's
/// adaptation. From the definitions (SMPTE RP 177, Lam 1985), no matrix of a config in it.
Matrix rgb_to_rgb(const Primaries& from, const Primaries& to);

/// IEC 61966-2-1, the piecewise curve.
double linear_of_srgb(double v);
double srgb_of_linear(double v);

/// An ICC profile of which there is nothing but a header and a description (version 2, 'desc').
std::vector<uint8_t> icc_profile(const std::string& description);

/// Writes an image with what `describe` adds to its header. Pixels are written as they are: alpha
/// is neither multiplied in nor divided out.
void write_image_with(const std::filesystem::path& file, const Image& image,
                      const std::string& type,
                      const std::function<void(OIIO::ImageSpec&)>& describe);

void set_icc_profile(OIIO::ImageSpec& spec, const std::string& description);
void set_chromaticities(OIIO::ImageSpec& spec, const Primaries& primaries);

} // namespace scree::test
