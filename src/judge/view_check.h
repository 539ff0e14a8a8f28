#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "judge/set_reader.h"
#include "judge/shading.h"
#include "math/vec.h"
#include "reference/displaced_surface.h"
#include "reference/gather.h"

namespace scree {

/// Which views, lights and footprints a set is tried with.
struct ViewPlan {
    std::vector<double> angles_deg = {0, 30, 60, 75, 85}; ///< of the view, from the normal
    int azimuths = 4;                                     ///< of each angle but 0, evenly
    /// From the normal, and from +s towards +t.
    std::vector<std::array<double, 2>> lights_deg = {{20, 30}, {50, 150}, {70, 260}};
    int footprints = 48; ///< a level, or as many as it has
    int grid = 32;       ///< grid x grid samples a footprint
    uint64_t seed = 1;
    Material material;
};

/// Unit vector at an angle from the normal, its azimuth from +s towards +t.
Vec3 direction(double angle_deg, double azimuth_deg);

/// All views of a plan: angle by angle, azimuth by azimuth.
struct PlannedView {
    Vec3 wo;
    size_t angle = 0; ///< index into angles_deg
};
std::vector<PlannedView> views_of(const ViewPlan& plan);
std::vector<Vec3> lights_of(const ViewPlan& plan);

/// A root of mean squares of what the set, and what a plain MIP chain, shows otherwise than the
/// reference, and what of it is the reference's own noise.
struct ViewError {
    double set = 0, plain = 0, noise = 0;
};

/// Errors at one level under one view angle (`angle_deg` < 0: all; `level` < 0: all).
///
/// Every footprint counts by the area of it that is seen: what is hidden shows nowhere.
struct ViewErrors {
    int level = -1;
    double angle_deg = -1;
    int footprints = 0;
    ViewError color;    ///< relative to the rms of the visible color
    ViewError radiance; ///< relative to the rms of the radiance
    ViewError masking;  ///< of G1, absolute; plain: 1
    ViewError slope;    ///< of the mean visible slope, over the map's rms slope; plain: as baked
    /// Of the visible slopes' covariance (ss, st, ts, tt), over the square of that; plain: as
    /// baked.
    ViewError covariance;
    std::vector<double> models; ///< like color.set, of every model in ViewCheck::models
};

struct ViewCheck {
    std::vector<std::string> models; ///< color models of the set
    std::vector<ViewErrors> all;     ///< per angle, all levels together; the last of all angles
    std::vector<ViewErrors> levels;  ///< per level and angle
    double rms_slope = 0;            ///< of the map: the yardstick of slopes
    long long samples = 0, rays = 0; ///< taken of the surface, and cast from them
    double seconds = 0;              ///< that they took
};

/// Compares what a set shows with the reference.
///
/// surface   that the set was baked from
/// progress  as of reference::gather_all
/// Throws Error where the set cannot be read.
ViewCheck check_views(SetReader& set, const reference::DisplacedSurface& surface,
                      const ViewPlan& plan, const std::function<void(double)>& progress);

} // namespace scree
