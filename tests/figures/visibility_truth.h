#pragma once

#include <string>
#include <vector>

#include "figures/baked_set.h"
#include "figures/visibility_models.h"
#include "reference/displaced_surface.h"
#include "reference/gather.h"

namespace scree::test {

/// Views from all sides: at every angle from the normal the azimuths (j + 1/4) 360 / 16 degrees,
/// none of which is one that tables are swept at, an axis or a diagonal.
struct AllViews {
    AllViews();

    static constexpr size_t kAzimuths = 16;
    std::vector<double> angles_deg;
    std::vector<Vec3> views; ///< angle by angle
};

/// What the reference renderer saw of them.
struct SeenOfSize {
    std::string name;
    std::vector<reference::Estimate> truth; ///< one a footprint
    std::vector<reference::Rgb> mean_color; ///< of its texels, exact

    /// The color of a view. What the samples miss of the mean color, which they show from straight
    /// above, they miss of other views too: it is made good, which leaves less noise.
    [[nodiscard]] reference::Rgb color(size_t footprint, const reference::Gathered& of_samples,
                                       size_t view) const;
};

/// Of the texels that a footprint takes, exact.
reference::Rgb mean_color_of(const reference::Relief& relief, const reference::Footprint& place);

/// plan  views, the first from straight above, and seed; samples are the footprints'
SeenOfSize see(const reference::DisplacedSurface& surface, const FootprintsOfSize& footprints,
               reference::GatherPlan plan);
SeenOfSize see(const reference::DisplacedSurface& surface, const FootprintsOfSize& footprints,
               const AllViews& views);

/// Mean squares, one an angle: errors of color, relative to a color. Over footprints, azimuths,
/// R, G and B, by visible area.
using SquaresOfAngles = std::vector<double>;

/// texels  one a footprint;  mean_color  what errors are relative to
SquaresOfAngles squares_of(const ColorOfView& model, const std::vector<SetTexel>& texels,
                           const SeenOfSize& seen, const AllViews& views, double mean_color);

/// Of the truth itself: half the difference of two halves of its samples.
SquaresOfAngles squares_of_noise(const SeenOfSize& seen, const AllViews& views, double mean_color);

} // namespace scree::test
