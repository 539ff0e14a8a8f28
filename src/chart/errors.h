#pragma once

#include <vector>

#include "chart/methods.h"
#include "chart/views.h"
#include "reference/gather.h"

namespace scree {

/// What is seen of one footprint.
struct Appearance {
    std::vector<Rgb> color;    ///< one a view
    std::vector<Rgb> radiance; ///< views x lights
};

/// How far appearances are from the truth, relative to the rms of the truth.
struct RelativeErrors {
    double color = 0, radiance = 0;
};

/// What the reference saw; radiance is its diffuse part and f0 times its lobe.
Appearance appearance_of(const reference::Gathered& gathered, float f0);

/// What a method shows.
Appearance appearance_of(const Method& method, const FootprintData& data,
                         const MethodSetting& setting, const ChartViews& views);

/// What errors are errors of: the truth of all footprints, and how much each view sees of them.
struct ErrorScale {
    ChartViews views;
    std::vector<Appearance> truth;         ///< one a footprint
    std::vector<std::vector<double>> area; ///< seen by each view, per area; footprints x views
};

/// The rms over footprints, views of a band, lights, R, G and B of a - b over that of the truth,
/// one a band. Footprints count by the area that the view sees of them, as they do in a picture.
///
/// a, b  one a footprint
std::vector<RelativeErrors> rms_differences(const ErrorScale& yardstick,
                                            const std::vector<Appearance>& a,
                                            const std::vector<Appearance>& b);

} // namespace scree
