#pragma once

#include "texset/manifest.h"

namespace scree::tool {

/// What a set was made of.
void print_head(const Manifest& manifest);
void print_textures(const Manifest& manifest);
/// What was found of the mesh; nothing for a set on a plane.
void print_mesh(const Manifest& manifest);
/// A line a tile; nothing for a set that is one map.
void print_tiles(const Manifest& manifest);
/// Means over the texels of a level; "inside" is what lies within its texels.
void print_levels(const Manifest& manifest);
/// How well each color model fits, where color varies inside texels.
void print_color_fit(const Manifest& manifest);
/// What every model of color leaves, level by level; nothing where it was not measured.
void print_model_errors(const Manifest& manifest);
/// Nothing for a set without a color map.
void print_color_map(const Manifest& manifest);
/// What `--maps auto` kept and dropped; nothing without it.
void print_model_choice(const Manifest& manifest);

} // namespace scree::tool
