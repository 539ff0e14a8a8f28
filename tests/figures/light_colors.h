#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/light_truth.h"
#include "figures/visibility_models.h"

namespace scree::test {

/// Where the colors that view and light have each alone are from.
struct LightSource {
    std::string name;
    std::optional<size_t> numbers;    ///< a texel; absent: nothing that a set could hold
    std::optional<ColorOfView> table; ///< absent: from the reference, of the samples of the truth
};

/// Tables of 0, 1, ... harmonics, as many as there are, the one along axes, and the reference.
///
/// harmonics, axes  how the tables of the two sets are laid out
std::vector<LightSource> light_sources(const VisibilityRecord& harmonics,
                                       const VisibilityRecord& axes);

/// Of them: the table of most harmonics, that along axes, the reference.
size_t most_harmonics(const std::vector<LightSource>& sources);
size_t along_axes(const std::vector<LightSource>& sources);
size_t exact(const std::vector<LightSource>& sources);

/// The colors of a footprint that every view and every light has alone.
struct DirectionColors {
    std::vector<Rgbf> seen, lit;
};

/// What a way may know of a footprint, a view and a light.
struct PairColors {
    const SetTexel& texel;
    Vec3f wo, wi;
    Rgbf seen, lit; ///< of the view, of the light, each alone
};

/// colors  by the source that is asked
PairColors pair_colors(const SetTexel& texel, const DirectionColors& colors,
                       const LightPairs& pairs, size_t view, size_t light);

/// By a table.
DirectionColors table_colors(const ColorOfView& table, const SetTexel& texel,
                             const LightPairs& pairs);

/// By the reference, one a footprint.
std::vector<DirectionColors> exact_colors(const reference::DisplacedSurface& surface,
                                          const FootprintsOfSize& footprints,
                                          const LightPairs& pairs, uint64_t seed);

} // namespace scree::test
