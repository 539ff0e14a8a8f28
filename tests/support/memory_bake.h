#pragma once

#include <filesystem>
#include <set>

#include "pipeline/bake.h"
#include "support/memory_source.h"

namespace scree::test {

/// Bakes a surface in memory, its texels of size 1, into a set called "test".
inline Manifest bake_memory(const std::filesystem::path& folder, MemorySource source,
                            BakeOptions options)
{
    options.output = folder;
    options.texel_size = {1, 1};
    Manifest manifest;
    manifest.name = "test";
    return bake(source, options, manifest);
}

inline std::set<Map> maps_of(const Manifest& manifest)
{
    std::set<Map> maps;
    for (const TextureRecord& texture : manifest.textures)
        maps.insert(texture.map);
    return maps;
}

} // namespace scree::test
