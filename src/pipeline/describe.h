#pragma once

#include "pipeline/baked_map.h"
#include "pipeline/surface.h"
#include "pipeline/texture_values.h"
#include "texset/attributes.h"
#include "texset/manifest.h"

namespace scree {

/// Writes into the manifest all that is known before the first texel is made.
void describe(const BakedMaps& maps, Manifest& manifest);

/// Tells what the mesh was found to be: of the set, and of each of its tiles.
void describe_mesh(const BakedMaps& maps, Manifest& manifest);

/// Channels of a map's texture.
std::vector<std::string> channels_of(Map map, const TableSizes& tables);

/// One texture a map, of the type that was given, or float.
///
/// tables  sizes of those of rank and of visibility
std::vector<TextureRecord> textures_for(const std::vector<Map>& maps, const TableSizes& tables,
                                        const BakeOptions& options, const std::string& name);

/// What the header of a texture says, so that a file without its set still explains itself.
Attributes attributes_of(Map map, const Manifest& manifest);

} // namespace scree
