#pragma once

#include <array>
#include <functional>
#include <vector>

#include "figures/baked_set.h"
#include "figures/light_pairs.h"
#include "judge/shading.h"
#include "reference/displaced_surface.h"
#include "reference/gather.h"

namespace scree::test {

/// What the reference renderer says of the diffuse light that a view gets from a footprint.
///
///   color  E[c Vo Vi Wo max(0, n . wi)] / E[Vo Vi Wo max(0, n . wi)],   sent  its denominator / pi
///
/// W = max(0, w.z - w . slope), V is 1 where the view (o) sees the point, the light (i) reaches it.
struct SeenLit {
    reference::Rgb color{};
    double sent = 0; ///< 0: nothing is both seen and lit, and the color is not defined
};

/// All pairs of a footprint.
struct LitFootprint {
    std::vector<SeenLit> all;                   ///< views x lights
    std::array<std::vector<SeenLit>, 2> halves; ///< of either half of the samples
};

/// What the samples miss of the mean color, which they show from straight above, they miss of all
/// pairs: it is made good, which leaves less noise.
std::vector<LitFootprint> light(const reference::DisplacedSurface& surface,
                                const FootprintsOfSize& footprints, const LightPairs& pairs,
                                uint64_t seed);

/// Mean squares of errors of color, angles of views x angles of lights. Over footprints, azimuths,
/// R, G and B, by the light that is sent.
using SquaresOfPairs = std::vector<double>;

/// color       of a footprint, a view and a light
/// mean_color  what errors are relative to
SquaresOfPairs
squares_of(const std::function<Rgbf(size_t footprint, size_t view, size_t light)>& color,
           const std::vector<LitFootprint>& truth, const LightPairs& pairs, double mean_color);

/// Of the truth itself: half the difference of two halves of its samples.
SquaresOfPairs squares_of_noise(const std::vector<LitFootprint>& truth, const LightPairs& pairs,
                                double mean_color);

} // namespace scree::test
