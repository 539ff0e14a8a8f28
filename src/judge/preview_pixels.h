#pragma once

#include <array>
#include <functional>
#include <vector>

#include "judge/set_lookup.h"
#include "judge/shading.h"
#include "reference/render.h"

namespace scree {

/// Radiance over irradiance of a pixel, and how much of it shows the surface.
struct ShadedPixel {
    Rgbf radiance{};
    float covered = 0;
};

/// A rectangle of pixels, row by row.
using ShadedPixels = std::vector<ShadedPixel>;

/// What the plane at the mean height shows, by lookups as a renderer makes them: one a pixel, in
/// its middle, over its footprint.
struct LookedUp {
    ShadedPixels plain; ///< mean color on the mean normal: no spread, no masking
    ShadedPixels set;   ///< the color and the slopes that are seen, masking
};

/// set       its textures repeat over the plane
/// progress  as of reference::render
LookedUp look_up(const SetLookup& set, const Material& material, const Vec3& light,
                 const reference::Camera& camera, const reference::PictureArea& area,
                 const std::function<void(double)>& progress = {});

/// What the surface itself shows, ray traced.
struct TruePixels {
    ShadedPixels all;
    std::array<ShadedPixels, 2> halves; ///< of every other ray
    long long rays = 0;
};

/// grid      grid x grid rays a pixel
/// progress  as of reference::render
TruePixels trace(const reference::DisplacedSurface& surface, const Material& material,
                 const Vec3& light, const reference::Camera& camera,
                 const reference::PictureArea& area, int grid, uint64_t seed,
                 const std::function<void(double)>& progress);

/// How far pixels are from the truth, over those of both that show nothing but surface.
struct PixelErrors {
    double brightness = 1; ///< mean radiance over that of the truth
    double rms = 0;        ///< of radiance, over the root mean square of the truth
    double noise = 0;      ///< rms of what the truth itself is off, relative likewise
};

/// All 0 where nothing can be compared, or the truth is black.
PixelErrors compare(const ShadedPixels& pixels, const TruePixels& truth);

} // namespace scree
