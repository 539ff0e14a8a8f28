#pragma once

#include <functional>
#include <string>
#include <vector>

#include "surface/mesh.h"

namespace scree::test {

/// How a grid of quadrilaterals closes on itself.
struct GridShape {
    int columns = 1, rows = 1; ///< faces
    bool wraps_u = false, wraps_v = false;
};

/// A grid over the unit square of (a, b): vertices and texture coordinates as the functions have
/// them at a = i / columns, b = j / rows. Faces run counterclockwise in (a, b).
Mesh grid_mesh(const GridShape& shape, const std::function<Vec3(double, double)>& position,
               const std::function<Vec2(double, double)>& uv);

/// Texture coordinates (a, b) themselves.
inline Vec2 plain_uv(double a, double b) { return {a, b}; }

/// A cube of half side 1, every face over its own cell of a 3 x 2 atlas; 8 vertices of valence 3.
Mesh cube_mesh();

/// A fan of `count` quadrilaterals around one vertex, flat, radius about 1; texture coordinates
/// are x and y over [0, 1].
Mesh fan_mesh(int count, double height = 0);

/// A curved patch over the unit square.
Vec3 wavy(double a, double b);

/// An octahedron with one corner pulled out, each face with texture coordinates of its own.
Mesh octahedron();

/// From the text of an OBJ file.
Mesh mesh_from(const std::string& obj);
/// What reading such a file complains of; empty when it does not.
std::string mesh_error(const std::string& obj);

} // namespace scree::test
