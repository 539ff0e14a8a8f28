#pragma once

#include <filesystem>

#include "color/map_table.h"
#include "pipeline/mapped_color.h"
#include "texset/attributes.h"

namespace scree {

/// The table of a color map for the means and deviations its set will be asked for.
///
/// By height: means from the lowest to the highest, deviations to half of that, the most there can
/// be. By slope: the map's ends and half its width beyond, deviations to its width.
struct ColorTable {
    MapTable table;
    MapTableRecord record;
};
ColorTable color_table(const MappedColor& mapped, const Survey& survey, double tolerance);

/// What the manifest says of a color map.
ColorMapRecord color_map_record(const MappedColor& mapped, const BakeOptions& options);

/// Writes a table as a float image, columns x rows. Throws Error when the disk refuses.
void write_color_table(const MapTable& table, const std::filesystem::path& file,
                       const Attributes& attributes);

} // namespace scree
