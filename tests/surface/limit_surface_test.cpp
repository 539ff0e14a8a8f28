// The limit surface against closed forms of uniform B-splines, its rules, and odd meshes.

#include "surface/limit_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/error.h"
#include "surface/meshes.h"
#include "surface/places.h"

namespace scree::test {
namespace {

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

TEST(LimitSurface, BoundsHoldAllTextureCoordinates)
{
    const Mesh bent = grid_mesh({3, 3}, wavy, [](double a, double b) {
        return Vec2(a + 0.4 * std::sin(5 * b), b - 0.4 * std::sin(6 * a));
    });
    const auto edges = BoundaryRule::edge_only;
    int places = 0;
    for (const UvRule uv : {UvRule::none, UvRule::corners_plus1, UvRule::all})
        for (const auto& [mesh, scheme] : {std::pair(bent, Scheme::catmull_clark),
                                           std::pair(fan_mesh(5, 0.3), Scheme::catmull_clark),
                                           std::pair(octahedron(), Scheme::loop)}) {
            const LimitSurface surface(mesh, options_of(scheme, edges, uv));
            at_places(
                surface, 30,
                [&](const FaceSurface& face, int index, size_t, const ParameterPiece&,
                    const Vec2& place) {
                    const auto [low, high] = face.uv_bounds();
                    const Vec2 at = face.uv_at(place).uv;
                    EXPECT_TRUE(at.x >= low.x && at.y >= low.y && at.x <= high.x && at.y <= high.y)
                        << index << " " << at << " in " << low << high;
                    EXPECT_LT((high - low).length(), 3) << "and are not much too large";
                    ++places;
                });
        }
    EXPECT_GT(places, 1000);
}

TEST(LimitSurface, FiniteAtExtraordinaryVertices)
{
    for (const int valence : {3, 5, 6, 8, 20, 60, 70})
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
    mesh = cube_mesh();
    mesh.creases = {{0, 1, 2}};
    EXPECT_EQ(error_of(mesh, Scheme::catmull_clark), "");
    mesh.rules.creases = CreaseRule::chaikin;
    EXPECT_EQ(
        error_of(mesh, Scheme::catmull_clark),
        "cube: creases by Chaikin's method with a sharpness below 10, which is not supported; "
        "use the method normal, or sharpness 10");
    EXPECT_EQ(error_of(fan_mesh(1001), Scheme::catmull_clark),
              "fan: more than 1000 faces at vertex 0 (from 0); split the pole by a ring of faces");
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
