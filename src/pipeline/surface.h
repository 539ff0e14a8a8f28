#pragma once

#include <array>
#include <optional>

#include "pipeline/mapped_color.h"
#include "pipeline/options.h"
#include "pipeline/source.h"
#include "pipeline/survey.h"
#include "pipeline/texture_values.h"

namespace scree {

/// What is baked, once it was looked over: the passes of a bake share it.
struct Surface {
    /// All but the survey must live longer. color_map is null where the source has its own colors,
    /// or none.
    Surface(Source& from, const BakeOptions& given, const BakeMonitor& watch, Survey survey,
            const ColorMapInput* color_map);

    [[nodiscard]] int width() const { return source.width(); }
    [[nodiscard]] int height() const { return source.height(); }
    [[nodiscard]] bool has_color() const { return mapped || source.has_color(); }
    [[nodiscard]] ValueScale scale() const { return {found.h0, found.h1, source.has_heights()}; }

    Source& source;
    const BakeOptions& options;
    const BakeMonitor& monitor;
    Survey found;
    std::array<double, 2> texel; ///< size, world units
    std::optional<MappedColor> mapped;
};

} // namespace scree
