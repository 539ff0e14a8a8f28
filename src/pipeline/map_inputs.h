#pragma once

#include <filesystem>

#include "pipeline/baked_map.h"
#include "pipeline/baked_mesh.h"
#include "texset/manifest.h"

namespace scree {

/// Opens the files of a bake, those of all tiles where their names have <UDIM>, and tells the
/// manifest of them: its name, inputs, notes.
///
/// mesh  null: a plane
/// Throws Error as FileSource and find_tiles() do, and where tiles on a plane would differ in size.
BakedMaps open_maps(const BakeOptions& options, const BakedMesh* mesh, Manifest& manifest);

/// Lays the maps on the mesh, which must live longer, and leaves out tiles that show nothing of it.
///
/// folder  where what is found takes its room
/// Throws Error where nothing is left.
void lay_on(const BakedMesh& mesh, BakedMaps& maps, const std::filesystem::path& folder,
            Manifest& manifest, const BakeMonitor& monitor);

} // namespace scree
