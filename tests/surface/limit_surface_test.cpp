// The limit surface against Far patch tables, the closed forms of uniform B-splines, finite
// differences of its own positions, and refined meshes of OpenSubdiv.

#include "surface/limit_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <utility>

#include "math/error.h"
#include "support/files.h"
#include "surface/far_surface.h"
#include "surface/mesh_file.h"
#include "surface/meshes.h"

namespace scree::test {
namespace {

SurfaceOptions options_of(Scheme scheme, BoundaryRule boundary, UvRule uv)
{
    SurfaceOptions options;
    options.scheme = scheme;
    options.rules.boundary = boundary;
    options.rules.uv = uv;
    return options;
}

Vec3 wavy(double a, double b)
{
    return {a, b + 0.1 * std::sin(5 * a), 0.3 * std::sin(6 * a + 2) * std::cos(4 * b)};
}

Mesh creased_cube()
{
    Mesh mesh = cube_mesh();
    mesh.creases = {{0, 1, 1.5}, {1, 3, 10}, {3, 2, 0.7}};
    mesh.corners = {{7, 2.5}, {4, 10}};
    return mesh;
}

/// Polygons of 3, 4, 5 and 7 corners around each other, with boundaries and texture coordinates
/// that are one chart.
Mesh polygons()
{
    return mesh_from("v 0 0 0\nv 2 0 0.3\nv 2 2 0\nv 0 2 0.5\nv 3 1 1\nv 4 3 0.2\nv 2.5 4 0\n"
                     "v 1 4 0.7\nv -1 3 0.2\nv -1.5 1.5 0\n"
                     "vt 0.3 0.1\nvt 0.6 0.1\nvt 0.6 0.4\nvt 0.3 0.4\nvt 0.8 0.3\nvt 0.9 0.6\n"
                     "vt 0.7 0.8\nvt 0.4 0.8\nvt 0.1 0.6\nvt 0.05 0.3\n"
                     "f 1/1 2/2 3/3 4/4\nf 2/2 5/5 3/3\nf 3/3 5/5 6/6 7/7 8/8 9/9 4/4\n"
                     "f 4/4 9/9 10/10 1/1\n");
}

/// An octahedron with one corner pulled out, each face with texture coordinates of its own.
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

/// Calls visit(face, piece index, piece, place) for places all over the mesh but within 1 % of the
/// corners, where Bfr and Far may stop refining differently.
template <class Visit>
void at_places(const LimitSurface& surface, int places, const Visit& visit)
{
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> law(0.01, 0.99);
    for (int index = 0; index < surface.face_count(); ++index) {
        const FaceSurface face = surface.face(index);
        for (size_t i = 0; i < face.pieces().size(); ++i)
            for (int k = 0; k < places; ++k) {
                Vec2 at(law(engine), law(engine));
                if (face.pieces()[i].triangle && at.x + at.y > 0.99)
                    at = at * 0.5;
                visit(face, index, i, face.pieces()[i],
                      face.pieces()[i].origin + at * face.pieces()[i].size);
            }
    }
}

/// Both are sums of some dozen products in double; second derivatives of small patches are
/// differences of their points times 4^depth.
void expect_as_far(const Mesh& mesh, Scheme scheme, BoundaryRule boundary, UvRule uv)
{
    const LimitSurface surface(mesh, options_of(scheme, boundary, uv));
    const FarSurface far(mesh, scheme, boundary, uv);
    int compared = 0;
    at_places(surface, 20,
              [&](const FaceSurface& face, int index, size_t i, const ParameterPiece& piece,
                  const Vec2& place) {
                  const SurfacePoint got = face.at(place);
                  const SurfacePoint want = far.at(index, i, piece, place);
                  const UvPoint got_uv = face.uv_at(place);
                  const UvPoint want_uv = far.uv_at(index, i, piece, place);
                  const double worst = std::max({(got.position - want.position).length() / 1e-13,
                                                 (got.by_p - want.by_p).length() / 1e-11,
                                                 (got.by_q - want.by_q).length() / 1e-11,
                                                 (got.by_pp - want.by_pp).length() / 1e-9,
                                                 (got.by_pq - want.by_pq).length() / 1e-9,
                                                 (got.by_qq - want.by_qq).length() / 1e-9,
                                                 (got_uv.uv - want_uv.uv).length() / 1e-13,
                                                 (got_uv.by_p - want_uv.by_p).length() / 1e-11,
                                                 (got_uv.by_q - want_uv.by_q).length() / 1e-11});
                  EXPECT_LT(worst, 10)
                      << mesh.name << " face " << index << " piece " << i << " at " << place << ": "
                      << got.position << " for " << want.position << ", by p " << got.by_p
                      << " for " << want.by_p << ", by pp " << got.by_pp << " for " << want.by_pp
                      << ", uv " << got_uv.uv << " for " << want_uv.uv << ", by p " << got_uv.by_p
                      << " for " << want_uv.by_p;
                  ++compared;
              });
    EXPECT_GT(compared, 0);
}

TEST(LimitSurface, AgreesWithFarPatchTables)
{
    const Mesh grid = grid_mesh({4, 3}, wavy, plain_uv);
    for (const UvRule uv : {UvRule::none, UvRule::corners_only, UvRule::corners_plus1,
                            UvRule::corners_plus2, UvRule::boundaries, UvRule::all}) {
        for (const BoundaryRule boundary :
             {BoundaryRule::edge_only, BoundaryRule::edge_and_corner}) {
            expect_as_far(grid, Scheme::catmull_clark, boundary, uv);
            expect_as_far(polygons(), Scheme::catmull_clark, boundary, uv);
        }
        expect_as_far(creased_cube(), Scheme::catmull_clark, BoundaryRule::edge_only, uv);
        expect_as_far(fan_mesh(7, 0.4), Scheme::catmull_clark, BoundaryRule::edge_and_corner, uv);
        expect_as_far(octahedron(), Scheme::loop, BoundaryRule::edge_only, uv);
        expect_as_far(octahedron(), Scheme::catmull_clark, BoundaryRule::edge_only, uv);
    }
}

TEST(LimitSurface, DerivativesAreThoseOfItsPositions)
{
    constexpr double kStep = 1e-4;
    const std::pair<Mesh, SurfaceOptions> cases[] = {
        {creased_cube(), options_of(Scheme::catmull_clark, BoundaryRule::edge_only, UvRule::none)},
        {polygons(), options_of(Scheme::catmull_clark, BoundaryRule::edge_only, UvRule::none)},
        {polygons(), options_of(Scheme::catmull_clark, BoundaryRule::edge_only, UvRule::all)},
        {octahedron(), options_of(Scheme::loop, BoundaryRule::edge_only, UvRule::none)}};
    for (const auto& [mesh, options] : cases) {
        const LimitSurface surface(mesh, options);
        at_places(surface, 10,
                  [&](const FaceSurface& face, int index, size_t, const ParameterPiece& piece,
                      const Vec2& place) {
                      const SurfacePoint got = face.at(place);
                      const UvPoint got_uv = face.uv_at(place);
                      const auto p = [&](double i, double j) {
                          return face.at(place + Vec2(i, j) * kStep).position;
                      };
                      const auto t = [&](double i, double j) {
                          return face.uv_at(place + Vec2(i, j) * kStep).uv;
                      };
                      // Errors: third and fourth derivatives, up to 1e3 at the corners' patches,
                      // times step^2; rounding over step^2.
                      EXPECT_LT(((p(1, 0) - p(-1, 0)) / (2 * kStep) - got.by_p).length(), 1e-4)
                          << index;
                      EXPECT_LT(((p(0, 1) - p(0, -1)) / (2 * kStep) - got.by_q).length(), 1e-4);
                      EXPECT_LT(((t(1, 0) - t(-1, 0)) / (2 * kStep) - got_uv.by_p).length(), 1e-4);
                      EXPECT_LT(((t(0, 1) - t(0, -1)) / (2 * kStep) - got_uv.by_q).length(), 1e-4);
                      const double size = 1 + got.by_pp.length() + got.by_qq.length();
                      // OpenSubdiv turns all three around in the middle one of four triangles.
                      const Vec3 bend = p(1, 0) - p(0, 0) * 2 + p(-1, 0);
                      const double sign = piece.triangle && (bend ^ got.by_pp) < 0 ? -1 : 1;
                      const Vec3 twice = got.position * 2;
                      const double h2 = kStep * kStep;
                      EXPECT_LT(((p(1, 0) - twice + p(-1, 0)) / h2 - got.by_pp * sign).length(),
                                0.05 * size)
                          << place;
                      EXPECT_LT(((p(0, 1) - twice + p(0, -1)) / h2 - got.by_qq * sign).length(),
                                0.05 * size);
                      EXPECT_LT(((p(1, 1) - p(1, -1) - p(-1, 1) + p(-1, -1)) / (4 * h2) -
                                 got.by_pq * sign)
                                    .length(),
                                0.05 * size);
                  });
    }
}

/// Weight of control point k of a uniform cubic B-spline at x, in its definition's pieces.
double b_spline(double x)
{
    const double a = std::abs(x);
    return a >= 2 ? 0 : a >= 1 ? std::pow(2 - a, 3) / 6 : (4 - 6 * a * a + 3 * a * a * a) / 6;
}

TEST(LimitSurface, RegularFacesAreBicubicBSplines)
{
    const GridShape shape{7, 6, true, true};
    const auto control = [](double a, double b) {
        return Vec3(std::cos(6.3 * a) + b * b, std::sin(3 * a + 5 * b), a - a * b);
    };
    const LimitSurface surface(grid_mesh(shape, control, plain_uv), {});
    for (const Vec2& at : {Vec2(0, 0), Vec2(0.25, 0.5), Vec2(1, 0.125), Vec2(0.7, 1)})
        for (int face = 0; face < 42; ++face) {
            const int i = face % 7, j = face / 7;
            Vec3 sum(0, 0, 0);
            for (int n = -1; n <= 2; ++n)
                for (int m = -1; m <= 2; ++m)
                    sum += control((i + m + 7) % 7 / 7.0, (j + n + 6) % 6 / 6.0) *
                           (b_spline(at.x - m) * b_spline(at.y - n));
            EXPECT_LT((surface.face(face).at(at).position - sum).length(), 1e-14) << face << at;
        }
}

TEST(LimitSurface, BoundaryRulesAtASingleFace)
{
    const Mesh mesh = mesh_from("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                "vt 0 1\nf 1/1 2/2 3/3 4/4\n");
    const auto corner = [&](BoundaryRule rule) {
        const LimitSurface surface(mesh, options_of(Scheme::catmull_clark, rule, UvRule::all));
        return surface.face(0);
    };
    EXPECT_TRUE(corner(BoundaryRule::none).pieces().empty());
    EXPECT_LT((corner(BoundaryRule::edge_and_corner).at({0, 0}).position).length(), 1e-15);
    // The boundary is a closed cubic B-spline: a vertex goes to (before + 4 itself + after) / 6.
    const Vec3 rounded(1.0 / 6, 1.0 / 6, 0);
    EXPECT_LT((corner(BoundaryRule::edge_only).at({0, 0}).position - rounded).length(), 1e-15);
}

TEST(LimitSurface, RulesOfTheCallWinOverTheFilesOverTheDefaults)
{
    Mesh mesh = grid_mesh({2, 2}, wavy, plain_uv);
    const auto at_corner = [&](const SurfaceOptions& options) {
        return (LimitSurface(mesh, options).face(0).at({0, 0}).position - mesh.vertices[0])
            .length();
    };
    EXPECT_LT(at_corner({}), 1e-15) << "edge_and_corner";
    mesh.rules.boundary = BoundaryRule::edge_only;
    EXPECT_GT(at_corner({}), 0.01);
    SurfaceOptions options;
    options.rules.boundary = BoundaryRule::edge_and_corner;
    EXPECT_LT(at_corner(options), 1e-15);

    EXPECT_TRUE(LimitSurface(mesh, {}).face(0).has_linear_uvs());
    mesh.rules.uv = UvRule::none;
    EXPECT_FALSE(LimitSurface(mesh, {}).face(0).has_linear_uvs());
}

TEST(LimitSurface, CornersOfOneVertexAndValueAreOne)
{
    const Mesh shared = grid_mesh(
        {3, 3}, wavy, [](double a, double b) { return Vec2(a + 0.1 * b * b, b - 0.1 * a * b); });
    Mesh apart = shared;
    apart.uvs.clear();
    for (size_t i = 0; i < shared.face_uvs.size(); ++i) {
        apart.uvs.push_back(shared.uvs[static_cast<size_t>(shared.face_uvs[i])]);
        apart.face_uvs[i] = static_cast<int>(i);
    }
    const auto options =
        options_of(Scheme::catmull_clark, BoundaryRule::edge_only, UvRule::corners_plus1);
    const LimitSurface one(shared, options), other(apart, options);
    for (int face = 0; face < 9; ++face) {
        const Vec2 place(0.3, 0.8);
        const UvPoint a = one.face(face).uv_at(place), b = other.face(face).uv_at(place);
        EXPECT_EQ(a.uv, b.uv);
        EXPECT_EQ(a.by_p, b.by_p);
    }
    EXPECT_FALSE(other.face(4).has_linear_uvs());
}

TEST(LimitSurface, FiniteAtExtraordinaryVertices)
{
    for (const int valence : {3, 5, 6, 8, 20, 60})
        for (const UvRule uv : {UvRule::all, UvRule::none}) {
            const LimitSurface surface(
                fan_mesh(valence, 0.5),
                options_of(Scheme::catmull_clark, BoundaryRule::edge_and_corner, uv));
            for (const Vec2& at : {Vec2(0, 0), Vec2(1e-9, 0), Vec2(1e-5, 1e-7), Vec2(1, 1)}) {
                const FaceSurface face = surface.face(1);
                const SurfacePoint got = face.at(at);
                const double normal = (got.by_p % got.by_q).length();
                EXPECT_TRUE(std::isfinite(got.by_pp.length() + got.by_pq.length()));
                EXPECT_TRUE(std::isfinite(normal));
                EXPECT_TRUE(normal > 0 || at.x == 1) << valence << at;
            }
        }
}

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

TEST(LimitSurface, WhatCannotBeMadeSaysWhy)
{
    const auto error_of = [](const Mesh& mesh, Scheme scheme) -> std::string {
        SurfaceOptions options;
        options.scheme = scheme;
        try {
            const LimitSurface surface(mesh, options);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(error_of(cube_mesh(), Scheme::loop),
              "cube: 6 of 6 faces are no triangles, which Loop subdivision needs; use "
              "Catmull-Clark or triangulate the mesh");
    Mesh mesh = cube_mesh();
    mesh.creases = {{0, 7, 2}};
    EXPECT_EQ(error_of(mesh, Scheme::catmull_clark),
              "cube: a crease between vertices 0 and 7 (from 0), which no edge connects; remove it "
              "or name both ends of an edge");
    EXPECT_EQ(error_of(octahedron(), Scheme::loop), "");
}

/// Odd meshes have a surface all the same, and it is finite.
TEST(LimitSurface, NonManifoldAndDegenerateMeshes)
{
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nv 2 0 0\n"
                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nvt 0.5 0\n";
    for (const char* faces :
         {"f 1/1 2/2 3/3\nf 1/1 2/2 5/5\n", "f 1/1 2/2 3/3\nf 2/2 1/1 5/5\nf 2/2 1/1 4/4\n",
          "f 1/1 2/2 3/3 2/4\n", "f 1/1 2/2 6/3\n", "f 1/1 2/2 3/3\nf 1/1 5/5 4/4\n",
          "f 1/1 2/2 3/3\nf 1/1 2/2 3/3\n", "f 1/1 1/1 1/1\n", "f 1/1 2/2 3/3 1/1 5/5 4/4\n"}) {
        SCOPED_TRACE(faces);
        for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop}) {
            const Mesh mesh = mesh_from(points + faces);
            if (scheme == Scheme::loop &&
                std::any_of(mesh.face_sizes.begin(), mesh.face_sizes.end(),
                            [](int size) { return size != 3; }))
                continue;
            const LimitSurface surface(
                mesh, options_of(scheme, BoundaryRule::edge_and_corner, UvRule::corners_plus1));
            at_places(
                surface, 5,
                [](const FaceSurface& face, int, size_t, const ParameterPiece&, const Vec2& place) {
                    const SurfacePoint got = face.at(place);
                    EXPECT_TRUE(std::isfinite(got.position.length() + got.by_p.length()));
                    EXPECT_TRUE(std::isfinite(face.uv_at(place).uv.length()));
                });
        }
    }
}

} // namespace
} // namespace scree::test
