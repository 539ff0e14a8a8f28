#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "judge/preview_pixels.h"
#include "judge/set_lookup.h"
#include "judge/shading.h"
#include "reference/displaced_surface.h"
#include "texset/picture.h"

namespace scree {

/// Ways to show a surface.
enum class PreviewPart {
    plain, ///< a plain MIP chain
    set,   ///< all that the set has
    truth  ///< the surface itself, ray traced
};

std::string preview_part_name(PreviewPart part);

/// The surface, repeated over a plane, under one directional light.
struct PreviewScene {
    std::vector<PreviewPart> parts{PreviewPart::plain, PreviewPart::set, PreviewPart::truth};
    Vec3 light{0, 0, 1}; ///< unit, z > 0
    Material material;
    int grid = 8; ///< of the truth: grid x grid rays a pixel
    uint64_t seed = 1;
    double exposure = 0; ///< multiplies radiance over irradiance; 0: fits the picture
    /// Told the share of a picture done, in [0, 1], from one thread at a time; may throw to stop.
    std::function<void(double)> progress;
};

/// A view of the plane that recedes to the horizon.
struct PlaneShot {
    int width = 960, height = 360;
    double angle_deg = 78;         ///< of the view in the middle of the picture, from the normal
    double azimuth_deg = 90;       ///< to the viewer, from +s towards +t
    double field_of_view_deg = 30; ///< of the picture's height
    double repeats = 20;           ///< of the set, across the middle of the picture
};

/// Distant views side by side, one from each angle.
struct StripShot {
    std::vector<double> angles_deg{0, 30, 50, 65, 75, 80, 85};
    double azimuth_deg = 90;
    int tile = 128;              ///< pixels along a side
    double texels_per_pixel = 8; ///< across; along the view 1 / cos of the angle more
};

/// How far the lookups are from the truth, over the pixels of the truth's part.
struct PreviewErrors {
    double angle_deg = 0; ///< of the view, in the middle
    PixelErrors plain, set;
};

struct Preview {
    Picture picture;
    double exposure = 1;
    std::vector<PreviewErrors> errors; ///< without the truth: empty
    long long samples = 0, rays = 0;   ///< of the truth
    double seconds = 0;                ///< of the truth
};

/// The parts side by side in one picture of the plane, a thin line between them.
///
/// surface  what the set was baked from, repeating; null where no part is the truth
/// Throws Error when the camera would be inside the surface.
Preview draw_plane(const SetLookup& set, const reference::DisplacedSurface* surface,
                   const PreviewScene& scene, const PlaneShot& shot);

/// A row of tiles for each part, a column for each angle.
Preview draw_strip(const SetLookup& set, const reference::DisplacedSurface* surface,
                   const PreviewScene& scene, const StripShot& shot);

} // namespace scree
