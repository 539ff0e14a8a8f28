// The limit surface against Far patch tables, and finite differences of its own positions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/far_surface.h"
#include "surface/meshes.h"
#include "surface/places.h"

namespace scree::test {
namespace {

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

/// Both are sums of some dozen products in double; second derivatives of small patches are
/// differences of their points times 4^depth.
void expect_as_far(const Mesh& mesh, const SurfaceOptions& options)
{
    const LimitSurface surface(mesh, options);
    const FarSurface far(mesh, options);
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

/// A grid whose first face has a chart of its own, so that a vertex has a corner of 90 degrees and
/// one of 270.
Mesh notched_grid()
{
    Mesh mesh = grid_mesh({3, 3}, wavy, plain_uv);
    for (size_t k = 0; k < 4; ++k) {
        mesh.uvs.push_back(mesh.uvs[static_cast<size_t>(mesh.face_uvs[k])] +
                           Vec2(1.1, k == 2 ? 0.3 : 0));
        mesh.face_uvs[k] = static_cast<int>(mesh.uvs.size()) - 1;
    }
    return mesh;
}

TEST(LimitSurface, AgreesWithFarPatchTables)
{
    const Mesh grid = grid_mesh({4, 3}, wavy, plain_uv);
    const auto smooth = Scheme::catmull_clark;
    for (const UvRule uv : {UvRule::none, UvRule::corners_only, UvRule::corners_plus1,
                            UvRule::corners_plus2, UvRule::boundaries, UvRule::all}) {
        for (const BoundaryRule boundary :
             {BoundaryRule::edge_only, BoundaryRule::edge_and_corner}) {
            expect_as_far(grid, options_of(smooth, boundary, uv));
            expect_as_far(notched_grid(), options_of(smooth, boundary, uv));
            expect_as_far(polygons(), options_of(smooth, boundary, uv));
        }
        expect_as_far(creased_cube(), options_of(smooth, BoundaryRule::edge_only, uv));
        expect_as_far(fan_mesh(7, 0.4), options_of(smooth, BoundaryRule::edge_and_corner, uv));
        expect_as_far(octahedron(), options_of(Scheme::loop, BoundaryRule::edge_only, uv));
        expect_as_far(octahedron(), options_of(smooth, BoundaryRule::edge_only, uv));
    }
}

TEST(LimitSurface, AgreesWithFarOnSmoothTrianglesAndInfiniteChaikinCreases)
{
    SurfaceOptions options =
        options_of(Scheme::catmull_clark, BoundaryRule::edge_only, UvRule::corners_plus1);
    options.rules.triangles = TriangleRule::smooth;
    expect_as_far(octahedron(), options);
    Mesh mesh = cube_mesh();
    mesh.creases = {{0, 1, 10}, {1, 3, 12}};
    options.rules.creases = CreaseRule::chaikin;
    expect_as_far(mesh, options);
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

} // namespace
} // namespace scree::test
