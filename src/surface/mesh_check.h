#pragma once

#include "surface/mesh.h"

namespace scree {

/// What is odd about a mesh, though a surface can be made of it.
struct MeshWarnings {
    int polygons = 0;           ///< faces of more than four corners
    int degenerate_faces = 0;   ///< a vertex twice, or no area in space
    int nonmanifold_edges = 0;  ///< of three faces or more, or run through twice in one direction;
                                ///< the surface is creased there, so that each side stands alone
    int unused_vertices = 0;    ///< of no face
    int zero_area_uv_faces = 0; ///< no area in texture space: covers no texel
    int mirrored_uv_faces = 0;  ///< clockwise in texture space (v up)
};

/// A face counts as without area below 1e-12 times the square of its longest extent.
///
/// mesh  with indices in range
MeshWarnings check_mesh(const Mesh& mesh);

} // namespace scree
