// The limit surface of meshes that OpenSubdiv refined.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "support/files.h"
#include "surface/meshes.h"
#include "surface/places.h"

namespace scree::test {
namespace {

/// Vertices and faces alone; the baselines have no texture coordinates.
Mesh bare_mesh(const std::filesystem::path& path)
{
    Mesh mesh;
    mesh.name = path.string();
    std::ifstream in(path);
    for (std::string word; in >> word;) {
        if (word == "v") {
            Vec3 p;
            in >> p.x >> p.y >> p.z;
            mesh.vertices.push_back(p);
        } else if (word == "f") {
            mesh.face_sizes.push_back(4);
            for (int k = 0; k < 4; ++k) {
                std::string corner;
                in >> corner;
                mesh.face_vertices.push_back(std::stoi(corner) - 1);
            }
        } else {
            std::getline(in, word);
        }
    }
    mesh.uvs.emplace_back(0, 0);
    mesh.face_uvs.assign(mesh.face_vertices.size(), 0);
    return mesh;
}

/// Where the vertices go: the surface at the corners of its faces.
std::vector<Vec3> limits_of_vertices(const Mesh& mesh, BoundaryRule boundary)
{
    const LimitSurface surface(mesh, options_of(Scheme::catmull_clark, boundary, UvRule::all));
    std::vector<Vec3> limits(mesh.vertices.size());
    const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int face = 0; face < surface.face_count(); ++face) {
        const FaceSurface of_face = surface.face(face);
        for (size_t k = 0; k < 4; ++k)
            limits[static_cast<size_t>(mesh.face_vertices[4 * static_cast<size_t>(face) + k])] =
                of_face.at(corners[k]).position;
    }
    return limits;
}

/// Subdividing moves vertices but not the surface: what a vertex of the coarse mesh goes to is what
/// one of the fine mesh goes to. Files have 6 digits.
TEST(LimitSurface, RefinedMeshesOfOpenSubdivHaveOneLimit)
{
    const auto folder = data_folder();
    if (folder.empty())
        GTEST_SKIP() << "no data folder";
    const struct {
        const char* name;
        BoundaryRule boundary;
        int first; ///< level from which on no crease is left
    } cases[] = {{"cube", BoundaryRule::edge_only, 0},
                 {"pyramid", BoundaryRule::edge_only, 0},
                 {"edgecorner", BoundaryRule::edge_and_corner, 0},
                 {"tent_creases0", BoundaryRule::edge_and_corner, 1}};
    for (const auto& [name, boundary, first] : cases)
        for (int level = first; level < 3; ++level) {
            const auto mesh_at = [&](int l) {
                return bare_mesh(
                    folder / "meshes/opensubdiv_baseline" /
                    ("catmark_" + std::string(name) + "_level" + std::to_string(l) + ".obj"));
            };
            const std::vector<Vec3> coarse = limits_of_vertices(mesh_at(level), boundary);
            const std::vector<Vec3> fine = limits_of_vertices(mesh_at(3), boundary);
            ASSERT_GT(coarse.size(), 0U) << name;
            ASSERT_GT(fine.size(), coarse.size()) << name;
            for (const Vec3& at : coarse) {
                double nearest = 1e9;
                for (const Vec3& p : fine)
                    nearest = std::min(nearest, (p - at).length2());
                EXPECT_LT(std::sqrt(nearest), 2e-6) << name << " level " << level << " " << at;
            }
        }
}

} // namespace
} // namespace scree::test
