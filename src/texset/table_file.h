#pragma once

#include <filesystem>
#include <vector>

#include "texset/table_manifest.h"

namespace scree {

/// Writes a table into a folder that is there: texture (OpenEXR, float, scan lines) and manifest.
///
/// values  height x width x channels, laid out as TableManifest says, channels interleaved
/// Throws Error when a file cannot be written whole.
void write_table(const TableManifest& manifest, const std::vector<float>& values,
                 const std::filesystem::path& folder);

} // namespace scree
