#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surface/mesh.h"

namespace scree {

/// A mesh and what its file asks for that is not known here.
struct MeshFile {
    Mesh mesh;
    std::vector<std::string> unknown_tags;
};

/// Reads a Wavefront OBJ file: all polygons of all groups, untriangulated, with creases, corners,
/// holes and rules as OpenSubdiv's own meshes state them (obj_tags.h). Materials are not read.
///
/// throws Error, naming the file and, where it can, the line: missing, unreadable, cut short, not
///        text, no faces, a face without texture coordinates, of fewer than 3 corners, an index out
///        of range, numbers that are not finite, texture coordinates beyond 1000, tags that make no
///        sense
MeshFile read_mesh(const std::filesystem::path& path);

} // namespace scree
