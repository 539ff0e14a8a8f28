// Which texels a mesh covers, by polygons of the texture.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "support/files.h"
#include "surface/mesh_file.h"
#include "surface/meshes.h"
#include "surface/texels.h"

namespace scree::test {
namespace {

/// Even and odd crossings to the left, and the nearest distance of an edge in v, for texels that
/// rounding may put on either side.
struct Polygon {
    std::vector<Vec2> corners;

    [[nodiscard]] bool holds(const Vec2& p) const
    {
        bool inside = false;
        for (size_t i = 0; i < corners.size(); ++i) {
            const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x > a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
                inside = !inside;
        }
        return inside;
    }
};

std::vector<Polygon> uv_polygons(const Mesh& mesh)
{
    std::vector<Polygon> polygons;
    size_t first = 0;
    for (const int size : mesh.face_sizes) {
        Polygon& polygon = polygons.emplace_back();
        for (int k = 0; k < size; ++k)
            polygon.corners.push_back(
                mesh.uvs[static_cast<size_t>(mesh.face_uvs[first + static_cast<size_t>(k)])]);
        first += static_cast<size_t>(size);
    }
    return polygons;
}

/// With linear texture coordinates a convex face covers its polygon. Faces that are not convex
/// fold over their own border there, so a few texels may differ.
void expect_covers_polygons(const Mesh& mesh, int size, int folded)
{
    const TexelImage image = texels_of(mesh, {size, size});
    const std::vector<Polygon> polygons = uv_polygons(mesh);
    int different = 0, covered = 0, overlapped = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            int faces = 0, lowest = -1;
            for (size_t i = 0; i < polygons.size(); ++i)
                if (polygons[i].holds(image.uv(x, y))) {
                    lowest = faces == 0 ? static_cast<int>(i) : lowest;
                    ++faces;
                }
            covered += faces > 0 ? 1 : 0;
            overlapped += faces > 1 ? 1 : 0;
            const TexelMetric& texel = image.at(x, y);
            different += texel.face != lowest || texel.overlapped != (faces > 1) ? 1 : 0;
        }
    EXPECT_GT(covered, 0) << mesh.name;
    EXPECT_LE(different, folded) << mesh.name << ": " << image.counts.covered << " covered for "
                                 << covered << ", " << image.counts.overlapped << " overlapped for "
                                 << overlapped;
}

TEST(Coverage, IsThatOfThePolygonsOfTheTexture)
{
    expect_covers_polygons(cube_mesh(), 101, 0);
    expect_covers_polygons(fan_mesh(7), 100, 0);
    // Two charts on each other, the second one as large again.
    expect_covers_polygons(
        mesh_from("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.11 0.13\nvt 0.52 0.12\nvt 0.55 0.57\n"
                  "vt 0.2 0.5\nvt 0.31 0.27\nvt 0.93 0.33\nvt 0.87 0.91\nvt 0.29 0.85\n"
                  "f 1/1 2/2 3/3 4/4\nf 4/5 3/6 2/7 1/8\nf 1/1 2/2 3/8\n"),
        97, 0);
}

/// All vertices are centres of texels, so edges run through centres, exactly or within rounding.
TEST(Coverage, EdgesThroughCentresLeaveNoHoles)
{
    constexpr int kSize = 60;
    std::mt19937 engine(11);
    std::uniform_int_distribution<int> law(8, 52);
    for (int trial = 0; trial < 40; ++trial) {
        const Vec2 middle(law(engine), law(engine));
        const Vec2 corners[] = {{3, 3}, {57, 3}, {57, 57}, {3, 57}};
        Mesh mesh;
        mesh.name = "fan of triangles";
        for (const Vec2& at : {corners[0], corners[1], corners[2], corners[3], middle}) {
            mesh.vertices.emplace_back(at.x, at.y, 0);
            mesh.uvs.push_back((at + Vec2(0.5, 0.5)) / kSize);
        }
        for (int k = 0; k < 4; ++k) {
            mesh.face_sizes.push_back(3);
            for (const int v : {k, (k + 1) % 4, 4})
                mesh.face_vertices.push_back(v);
        }
        mesh.face_uvs = mesh.face_vertices;
        for (const Scheme scheme : {Scheme::catmull_clark, Scheme::loop}) {
            SurfaceOptions options;
            options.scheme = scheme;
            const TexelImage image = texels_of(mesh, {kSize, kSize}, options);
            for (int y = 4; y < kSize - 4; ++y)
                for (int x = 4; x < kSize - 4; ++x)
                    ASSERT_GE(image.at(x, y).face, 0) << middle << ": " << x << " " << y;
            EXPECT_EQ(image.counts.overlapped, 0) << middle;
        }
    }
}

/// Distance from the border, up to 1/2, of the root (p, q) of A + p e + q f + p q g = uv that lies
/// deepest inside the unit square; below 0 for one outside, -1 for none. Quadratic in p, by the
/// cross product with f + p g; e = B - A, f = D - A, g = A - B + C - D.
double bilinear_inside(const std::array<Vec2, 4>& corners, const Vec2& uv)
{
    const auto& [a, b, c, d] = corners;
    const Vec2 e = b - a, f = d - a, g = a - b + c - d, h = uv - a;
    const double second = -(e % g), first = (h % g) - (e % f), zeroth = h % f;
    const double root = first * first - 4 * second * zeroth;
    double inside = -1;
    if (root < 0)
        return inside;
    for (const double sign : {-1.0, 1.0}) {
        const double p = (-first + sign * std::sqrt(root)) / (2 * second);
        const Vec2 across = f + g * p, rest = h - e * p;
        const double q = (rest ^ across) / across.length2();
        inside = std::max(inside, std::min({p, 1 - p, q, 1 - q}));
    }
    return inside;
}

/// Quadrilaterals of any shape, most of them folded or twisted: what any part of the face shows is
/// found, but for one texel in a thousand, along folds, where Newton's method has two ways to go.
TEST(Coverage, FoldedFacesCoverWhatTheyShow)
{
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> law(0.05, 0.95);
    int covered = 0, missed = 0;
    for (int trial = 0; trial < 100; ++trial) {
        Mesh mesh = grid_mesh(
            {1, 1}, [](double a, double b) { return Vec3(a, b, 0); }, plain_uv);
        for (Vec2& uv : mesh.uvs)
            uv = Vec2(law(engine), law(engine));
        const std::array<Vec2, 4> corners = {mesh.uvs[0], mesh.uvs[1], mesh.uvs[3], mesh.uvs[2]};
        const TexelImage image = texels_of(mesh, {40, 40});
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                const double inside = bilinear_inside(corners, image.uv(x, y));
                covered += inside >= 0 ? 1 : 0;
                if (std::abs(inside) > 1e-9)
                    missed += (image.at(x, y).face >= 0) != (inside > 0) ? 1 : 0;
            }
    }
    EXPECT_GT(covered, 10000);
    EXPECT_LT(missed, covered / 1000);
}

TEST(Coverage, IsThatOfThePolygonsOfRealMeshes)
{
    const auto folder = data_folder();
    if (folder.empty())
        GTEST_SKIP() << "no data folder";
    const auto mesh = [&](const char* name) { return read_mesh(folder / "meshes" / name).mesh; };
    // 8 of the faces are concave and fold over their border.
    expect_covers_polygons(mesh("spot/spot_control_mesh.obj"), 64, 4);
    expect_covers_polygons(mesh("assimp/spider.obj"), 64, 0);
    expect_covers_polygons(mesh("materialx/plane.obj"), 64, 0);
    expect_covers_polygons(mesh("materialx/cube.obj"), 64, 0);
}

TEST(Coverage, MirroredChartsAreFlagged)
{
    const TexelImage image =
        texels_of(mesh_from("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.5 0\nvt 0.5 1\n"
                            "vt 0 1\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3 4/4\nf 2/2 1/5 4/6 3/3\n"),
                  {8, 8});
    EXPECT_EQ(image.counts.covered, 64);
    EXPECT_EQ(image.counts.mirrored, 0) << "the second face looks the other way";
    const TexelImage flipped =
        texels_of(mesh_from("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\n"
                            "vt 0.5 0\nvt 0.5 1\nvt 0 1\nvt 1 0\nvt 1 1\n"
                            "f 1/1 2/2 3/3 4/4\nf 2/5 5/2 6/3 3/6\n"),
                  {8, 8});
    EXPECT_EQ(flipped.counts.covered, 64);
    EXPECT_EQ(flipped.counts.mirrored, 32);
    EXPECT_FALSE(flipped.at(3, 4).mirrored);
    EXPECT_TRUE(flipped.at(4, 4).mirrored);
}

TEST(Coverage, WhatHasNoSurfaceHasNoTexels)
{
    Mesh mesh = grid_mesh(
        {2, 1}, [](double a, double b) { return Vec3(a, b, 0); }, plain_uv);
    mesh.holes = {1};
    EXPECT_EQ(texels_of(mesh, {10, 10}).counts.covered, 50);
    mesh.holes.clear();
    SurfaceOptions options;
    options.rules.boundary = BoundaryRule::none;
    EXPECT_EQ(texels_of(mesh, {10, 10}, options).counts.covered, 0);

    for (Vec2& uv : mesh.uvs)
        uv.y = uv.x;
    EXPECT_EQ(texels_of(mesh, {10, 10}).counts.covered, 0) << "no area in the texture";

    const Mesh point = grid_mesh(
        {2, 1}, [](double, double) { return Vec3(1, 2, 3); }, plain_uv);
    const TexelImage image = texels_of(point, {10, 10});
    EXPECT_EQ(image.counts.covered, 0);
    EXPECT_EQ(image.counts.singular, 100) << "no area in space";
}

} // namespace
} // namespace scree::test
