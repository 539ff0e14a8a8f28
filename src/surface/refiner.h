#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <vector>

#include "surface/limit_surface.h"

namespace scree {

/// Texture coordinates with one index for each pair of a vertex and a value.
struct VertexUvs {
    std::vector<Vec2> values;
    std::vector<int> indices; ///< of all corners of all faces, in order
};

VertexUvs uvs_by_vertex(const Mesh& mesh);

/// The cage as OpenSubdiv keeps it, unrefined, with one face-varying channel.
/// throws Error as LimitSurface does
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner>
make_refiner(const Mesh& mesh, const SurfaceOptions& options, const VertexUvs& uvs);

} // namespace scree
