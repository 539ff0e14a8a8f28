#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "color/map_table.h"
#include "pipeline/model_errors.h"
#include "pipeline/surface.h"
#include "pipeline/texture_values.h"
#include "texset/manifest.h"
#include "visibility/height_grid.h"

namespace scree {

/// What a set is made of, as far as it is decided.
struct SetPlan {
    std::vector<Map> maps;
    TableSizes tables;
    const MapTable* map_table = nullptr; ///< of a color map by height
    std::optional<MeasuredModels> models;
};

/// Goes over the surface to measure what must be known before anything is written: what storage
/// costs, for the pixel types, and what every color model costs, for the choice of maps and for
/// what is fitted. The levels reported then know of maps that are dropped.
///
/// heights   what views see is swept over; null where none is asked for
/// manifest  with its textures; gets their pixel types, and levels for the choice of maps
void measure(const Surface& surface, const HeightGrid* heights, SetPlan& plan, Manifest& manifest);

/// Writes all textures but the table of a color map, and measures the models of color on the way
/// where that was not done before; returns the summaries of their levels, those of the measuring
/// pass where there are any: they know of more maps.
///
/// heights   as of measure()
/// manifest  what the files' headers say
/// Throws Error where numbers do not fit a given pixel type or there is no room, and Cancelled.
std::vector<LevelSummary> write_textures(const Surface& surface, SetPlan& plan,
                                         const HeightGrid* heights, const Manifest& manifest,
                                         const std::filesystem::path& folder);

} // namespace scree
