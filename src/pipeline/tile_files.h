#pragma once

#include <string>
#include <vector>

#include "pipeline/options.h"

namespace scree {

class BakedMesh;

/// The tiles of inputs with <UDIM> in their names.
struct TileFiles {
    std::vector<int> numbers; ///< rising, of tiles that have all their files
    /// Tiles that are missing: of which one file is there and another is not, gaps in a row of
    /// tiles, and what a mesh has charts in.
    std::vector<std::string> warnings;
};

/// mesh  null: a plane
/// Throws Error when no tile has all its files, or some names have <UDIM> and others have not.
TileFiles find_tiles(const BakeOptions& options, const BakedMesh* mesh);

} // namespace scree
