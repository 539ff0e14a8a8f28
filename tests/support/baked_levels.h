#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/files.h"
#include "support/memory_bake.h"

namespace scree::test {

/// A set baked from memory, and all its levels as stored, by the name of the map.
struct BakedLevels {
    TempFolder temp;
    Manifest manifest;
    std::map<std::string, std::vector<Image>> levels;

    BakedLevels(const MemorySource& source, const BakeOptions& options)
        : manifest(bake_memory(folder(), source, options))
    {
        for (const TextureRecord& texture : manifest.textures)
            levels[map_info(texture.map).name] = read_levels(folder() / texture.file);
    }

    [[nodiscard]] std::filesystem::path folder() const { return temp / "set"; }
};

} // namespace scree::test
