#pragma once

#include <filesystem>

#include "color/map_table.h"
#include "pipeline/mapped_color.h"
#include "texset/attributes.h"

namespace scree {

/// The table of a color map, for the means and deviations its set will be asked for.
struct ColorTable {
    MapTable table;
    MapTableRecord record;
};

/// By height: means from the lowest to the highest there is, deviations to half of that, the most
/// there can be.
ColorTable color_table_by_height(const MappedColor& mapped, const Survey& survey, double tolerance);

/// By slope: means from the map's ends outwards by its width or three times the rms slope,
/// whichever is more, but no further than the steepest; deviations to the steepest, which is twice
/// the steepest texel's mean slope or four times the rms slope.
///
/// finest  level 0, for its steepest and rms slope
ColorTable color_table_by_slope(const MappedColor& mapped, const LevelSummary& finest,
                                double tolerance);

/// What the manifest says of a color map.
ColorMapRecord color_map_record(const MappedColor& mapped, const BakeOptions& options);

/// Writes a table as a float image, columns x rows. Throws Error when the disk refuses.
void write_color_table(const MapTable& table, const std::filesystem::path& file,
                       const Attributes& attributes);

} // namespace scree
