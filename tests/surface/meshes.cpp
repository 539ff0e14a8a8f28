#include "surface/meshes.h"

#include <cmath>
#include <fstream>

#include "math/error.h"
#include "support/files.h"
#include "surface/mesh_file.h"

namespace scree::test {

Mesh grid_mesh(const GridShape& shape, const std::function<Vec3(double, double)>& position,
               const std::function<Vec2(double, double)>& uv)
{
    Mesh mesh;
    mesh.name = "grid";
    const int columns = shape.columns + (shape.wraps_u ? 0 : 1);
    const int rows = shape.rows + (shape.wraps_v ? 0 : 1);
    const auto a_of = [&](int i) { return static_cast<double>(i) / shape.columns; };
    const auto b_of = [&](int j) { return static_cast<double>(j) / shape.rows; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            mesh.vertices.push_back(position(a_of(i), b_of(j)));
    for (int j = 0; j <= shape.rows; ++j)
        for (int i = 0; i <= shape.columns; ++i)
            mesh.uvs.push_back(uv(a_of(i), b_of(j)));
    const auto add = [&](int i, int j) {
        mesh.face_vertices.push_back((j % rows) * columns + i % columns);
        mesh.face_uvs.push_back(j * (shape.columns + 1) + i);
    };
    for (int j = 0; j < shape.rows; ++j)
        for (int i = 0; i < shape.columns; ++i) {
            mesh.face_sizes.push_back(4);
            add(i, j);
            add(i + 1, j);
            add(i + 1, j + 1);
            add(i, j + 1);
        }
    return mesh;
}

Mesh cube_mesh()
{
    Mesh mesh;
    mesh.name = "cube";
    for (int k = 0; k < 8; ++k)
        mesh.vertices.emplace_back((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1,
                                   (k & 4) != 0 ? 1 : -1);
    mesh.face_vertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    mesh.face_sizes.assign(6, 4);
    for (int face = 0; face < 6; ++face) {
        const double u = face % 3 / 3.0, v = face / 3 / 2.0;
        for (int k = 0; k < 4; ++k) {
            mesh.face_uvs.push_back(4 * face + k);
            mesh.uvs.emplace_back(u + (k == 1 || k == 2 ? 0.3 : 0.02), v + (k > 1 ? 0.45 : 0.03));
        }
    }
    return mesh;
}

Mesh fan_mesh(int count, double height)
{
    Mesh mesh;
    mesh.name = "fan";
    mesh.vertices.emplace_back(0, 0, height);
    for (int k = 0; k < 2 * count; ++k) {
        const double angle = M_PI * k / count, radius = k % 2 == 0 ? 1 : 1.2;
        mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    for (const Vec3& p : mesh.vertices)
        mesh.uvs.emplace_back(0.5 + 0.4 * p.x, 0.5 + 0.4 * p.y);
    for (int k = 0; k < count; ++k) {
        const int first = 2 * k + 1;
        mesh.face_sizes.push_back(4);
        for (const int v : {0, first, first + 1, first + 2 > 2 * count ? 1 : first + 2})
            mesh.face_vertices.push_back(v);
    }
    mesh.face_uvs = mesh.face_vertices;
    return mesh;
}

Vec3 wavy(double a, double b)
{
    return {a, b + 0.1 * std::sin(5 * a), 0.3 * std::sin(6 * a + 2) * std::cos(4 * b)};
}

Mesh octahedron()
{
    Mesh mesh;
    mesh.name = "octahedron";
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 2}, {0, 0, -1}};
    mesh.face_vertices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    mesh.face_sizes.assign(8, 3);
    for (int face = 0; face < 8; ++face)
        for (const Vec2& at : {Vec2(0, 0), Vec2(0.9, 0.1), Vec2(0.2, 0.8)}) {
            mesh.face_uvs.push_back(static_cast<int>(mesh.uvs.size()));
            mesh.uvs.push_back((at + Vec2(face % 4, face / 4)) / 4);
        }
    return mesh;
}

Mesh mesh_from(const std::string& obj)
{
    const TempFolder folder;
    const auto path = folder / "a.obj";
    std::ofstream(path, std::ios::binary) << obj;
    return read_mesh(path).mesh;
}

std::string mesh_error(const std::string& obj)
{
    try {
        mesh_from(obj);
    } catch (const Error& error) {
        const std::string text = error.what();
        return text.substr(text.find("a.obj"));
    }
    return "";
}

} // namespace scree::test
