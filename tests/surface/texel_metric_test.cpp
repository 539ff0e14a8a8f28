// The metric of texels where it is known exactly, on planes; tiles, bands and threads.

#include "surface/texel_metric.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "surface/meshes.h"
#include "surface/texels.h"

namespace scree::test {
namespace {

/// Texture coordinates as an affine map of the unit square.
struct Affine {
    const char* name;
    double ua, ub, va, vb;

    [[nodiscard]] Vec2 at(double a, double b) const
    {
        return Vec2(0.5, 0.5) +
               Vec2(ua * (a - 0.5) + ub * (b - 0.5), va * (a - 0.5) + vb * (b - 0.5));
    }
    [[nodiscard]] double determinant() const { return ua * vb - ub * va; }
};

constexpr Affine kMaps[] = {{"plain", 1, 0, 0, 1},         {"scaled", 0.25, 0, 0, 0.75},
                            {"sheared", 0.5, 0.3, 0, 0.6}, {"rotated", 0.4, -0.5, 0.5, 0.4},
                            {"mirrored", -0.8, 0, 0, 0.8}, {"all of it", -0.3, 0.2, 0.45, 0.4}};

/// A rectangle of sides 3 and 2 in a slanted plane.
const Vec3 kSideA = Vec3(2, 1, 2), kSideB = Vec3(-4, 4, 2) / 3;

Mesh plane(const Affine& map)
{
    return grid_mesh(
        {5, 3}, [](double a, double b) { return Vec3(1, 2, 3) + kSideA * a + kSideB * b; },
        [&](double a, double b) { return map.at(a, b); });
}

/// dP/ds and dP/dt by the inverse of the map, t = 1 - v.
Tangents tangents_of(const Affine& map)
{
    const double d = map.determinant();
    return {(kSideA * map.vb - kSideB * map.va) / d, (kSideA * map.ub - kSideB * map.ua) / d};
}

TEST(TexelMetric, PlanesHaveOneExactMetric)
{
    for (const Affine& map : kMaps) {
        SCOPED_TRACE(map.name);
        const TexelImage image = texels_of(plane(map), {61, 47});
        const Tangents exact = tangents_of(map);
        const double area = (exact.by_s % exact.by_t).length();
        int covered = 0;
        for (int y = 0; y < 47; ++y)
            for (int x = 0; x < 61; ++x) {
                const Vec2 from = image.uv(x, y) - Vec2(0.5, 0.5);
                const double a = 0.5 + (map.vb * from.x - map.ub * from.y) / map.determinant();
                const double b = 0.5 + (map.ua * from.y - map.va * from.x) / map.determinant();
                const double inside = std::min({a, 1 - a, b, 1 - b});
                const TexelMetric& texel = image.at(x, y);
                ASSERT_TRUE((texel.face >= 0) == (inside > 0) || std::abs(inside) < 1e-8)
                    << x << " " << y;
                if (texel.face < 0)
                    continue;
                ++covered;
                EXPECT_EQ(texel.face % 5, std::min(4, static_cast<int>(5 * a))) << a;
                EXPECT_EQ(texel.face / 5, std::min(2, static_cast<int>(3 * b))) << b;
                // Rounding, by the derivatives of faces 1/5 as large.
                EXPECT_LT((texel.tangents.by_s - exact.by_s).length(), 1e-12 * area);
                EXPECT_LT((texel.tangents.by_t - exact.by_t).length(), 1e-12 * area);
                EXPECT_NEAR(texel.area, area, 1e-12 * area * area);
                EXPECT_LT((texel.normal - (kSideA % kSideB).normalized()).length(), 1e-12);
                EXPECT_LT(texel.curvature, 1e-12F);
                EXPECT_EQ(texel.mirrored, map.determinant() < 0);
                EXPECT_FALSE(texel.overlapped);
            }
        EXPECT_GT(covered, 0);
        EXPECT_EQ(image.counts.covered, covered);
        EXPECT_EQ(image.counts.mirrored, map.determinant() < 0 ? covered : 0);
        EXPECT_EQ(image.counts.overlapped, 0);
        EXPECT_EQ(image.counts.singular, 0);
    }
}

/// The covariance w w' of a gradient in space comes back whatever the texture coordinates.
TEST(TexelMetric, SurfaceCovarianceDoesNotDependOnTextureCoordinates)
{
    const Vec3 x = kSideA.normalized(), y = kSideB.normalized();
    const Vec3 gradients[] = {x * 0.3 + y * 0.1, y * -0.5, x * 0.2 - y * 0.25};
    double expected[3][3] = {};
    for (const Vec3& w : gradients)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                expected[i][j] += w[i] * w[j];
    for (const Affine& map : kMaps) {
        SCOPED_TRACE(map.name);
        // What a bake sees: slopes by texture coordinates.
        const Tangents exact = tangents_of(map);
        SlopeCovariance cov;
        for (const Vec3& w : gradients) {
            const Vec2 g(w ^ exact.by_s, w ^ exact.by_t);
            cov.xx += g.x * g.x;
            cov.xy += g.x * g.y;
            cov.yy += g.y * g.y;
        }
        const TexelImage image = texels_of(plane(map), {40, 40});
        const TexelMetric& texel = image.at(19, 20);
        ASSERT_GE(texel.face, 0);
        const TangentFrame frame = tangent_frame(texel.tangents);
        const SlopeCovariance got = surface_covariance(texture_jacobian(texel.tangents), cov);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                EXPECT_NEAR(frame.x[i] * frame.x[j] * got.xx +
                                (frame.x[i] * frame.y[j] + frame.y[i] * frame.x[j]) * got.xy +
                                frame.y[i] * frame.y[j] * got.yy,
                            expected[i][j], 1e-12);
    }
}

/// Where texture coordinates are x and y of the cage, subdivided by the same rules as positions,
/// they are x and y of the surface: dP/du = (1, 0, z_x), exactly, at extraordinary vertices too.
TEST(TexelMetric, SmoothTextureCoordinatesUndoTheSurface)
{
    SurfaceOptions options;
    options.rules.uv = UvRule::none;
    options.rules.boundary = BoundaryRule::edge_only;
    for (const int valence : {3, 4, 5, 9}) {
        Mesh mesh = fan_mesh(valence);
        for (Vec3& p : mesh.vertices) {
            p += Vec3(0.06, 0.02, 0) * p.x * p.y; // not symmetric
            p.z = 0.5 * p.x - 0.25 * p.y;
        }
        mesh.uvs.clear();
        for (const Vec3& p : mesh.vertices)
            mesh.uvs.emplace_back(0.5 + 0.4 * p.x, 0.5 + 0.4 * p.y);
        const TexelImage image = texels_of(mesh, {101, 101}, options);
        EXPECT_GT(image.counts.covered, 2000);
        EXPECT_EQ(image.counts.overlapped, 0);
        EXPECT_EQ(image.counts.mirrored, 0);
        for (const TexelMetric& texel : image.texels) {
            if (texel.face < 0)
                continue;
            // Parameters within 1e-9 of the texture, whose derivatives cancel down to 1e-4 near
            // the middle.
            EXPECT_LT((texel.tangents.by_s - Vec3(2.5, 0, 1.25)).length(), 1e-9) << valence;
            EXPECT_LT((texel.tangents.by_t - Vec3(0, -2.5, 0.625)).length(), 1e-9) << valence;
        }
        // No holes: every texel well inside is covered.
        for (int y = 30; y <= 70; ++y)
            for (int x = 30; x <= 70; ++x)
                EXPECT_GE(image.at(x, y).face, 0) << valence << ": " << x << " " << y;
    }
}

/// The same on a grid that is stirred: faces bend by more than a right angle, so one start a face
/// would not do, and its corners do not bound it.
TEST(TexelMetric, FindsAllTexelsOfBentTextureCoordinates)
{
    SurfaceOptions options;
    options.rules.uv = UvRule::corners_plus1;
    options.rules.boundary = BoundaryRule::edge_and_corner;
    const auto stirred = [](double a, double b) {
        const Vec2 from(a - 0.5, b - 0.5);
        const double angle = 3.2 * std::max(0.0, 1 - 2 * from.length());
        return Vec2(0.5 + from.x * std::cos(angle) - from.y * std::sin(angle),
                    0.5 + from.x * std::sin(angle) + from.y * std::cos(angle));
    };
    for (const int faces : {3, 4, 5, 8}) {
        const Mesh mesh = grid_mesh(
            {faces, faces},
            [&](double a, double b) { return Vec3(2 * stirred(a, b).x, 3 * stirred(a, b).y, 0); },
            stirred);
        const TexelImage image = texels_of(mesh, {83, 83}, options);
        EXPECT_EQ(image.counts.covered, 83 * 83) << faces;
        EXPECT_EQ(image.counts.overlapped, 0) << faces;
        EXPECT_EQ(image.counts.mirrored, 0) << faces;
        for (const TexelMetric& texel : image.texels) {
            EXPECT_LT((texel.tangents.by_s - Vec3(2, 0, 0)).length(), 1e-9);
            EXPECT_LT((texel.tangents.by_t - Vec3(0, -3, 0)).length(), 1e-9);
        }
    }
}

TEST(TexelMetric, FiniteWhereATexelIsAnExtraordinaryVertex)
{
    for (const int valence : {3, 5, 8, 30})
        for (const UvRule uv : {UvRule::all, UvRule::corners_plus1}) {
            SurfaceOptions options;
            options.rules.uv = uv;
            const TexelImage image = texels_of(fan_mesh(valence, 0.4), {33, 33}, options);
            const TexelMetric& middle = image.at(16, 16);
            ASSERT_GE(middle.face, 0) << valence;
            EXPECT_TRUE(std::isfinite(middle.area + static_cast<double>(middle.curvature)));
            EXPECT_GT(middle.area, 0);
            EXPECT_NEAR(middle.normal.z, 1, 1e-9) << "by symmetry";
            EXPECT_FALSE(middle.overlapped) << "all faces meet there";
            EXPECT_EQ(image.counts.overlapped, 0);
            EXPECT_EQ(image.counts.singular, 0);
        }
}

TEST(TexelMetric, TriangulatedPlaneUnderLoop)
{
    // The four corners have two faces each, and would be rounded.
    const Mesh mesh = mesh_from("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0.9 1.2 0\n"
                                "vt 0.1 0.1\nvt 0.9 0.1\nvt 0.9 0.9\nvt 0.1 0.9\nvt 0.46 0.58\n"
                                "f 1/1 2/2 5/5\nf 2/2 3/3 5/5\nf 3/3 4/4 5/5\nf 4/4 1/1 5/5\n"
                                "t corner 4/1/0 0 1 2 3 10\n");
    SurfaceOptions options;
    options.scheme = Scheme::loop;
    options.rules.uv = UvRule::boundaries;
    const TexelImage image = texels_of(mesh, {50, 50}, options);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 50; ++x) {
            const TexelMetric& texel = image.at(x, y);
            const bool inside = x >= 5 && x < 45 && y >= 5 && y < 45;
            ASSERT_EQ(texel.face >= 0, inside) << x << " " << y;
            if (inside) {
                EXPECT_LT((texel.tangents.by_s - Vec3(2.5, 0, 0)).length(), 1e-9);
                EXPECT_LT((texel.tangents.by_t - Vec3(0, -2.5, 0)).length(), 1e-9);
            }
        }
    EXPECT_EQ(image.counts.overlapped, 0);
}

TEST(TexelMetric, ATileIsEvaluatedByItself)
{
    const auto shifted = [](double u, double v) {
        Mesh mesh = cube_mesh();
        for (Vec2& uv : mesh.uvs)
            uv += Vec2(u, v);
        return mesh;
    };
    const TexelImage here = texels_of(cube_mesh(), {64, 64});
    const TexelImage there = texels_of(shifted(3, 2), {64, 64, 3, 2});
    EXPECT_EQ(here.counts.covered, there.counts.covered);
    EXPECT_GT(here.counts.covered, 1000);
    for (size_t i = 0; i < here.texels.size(); ++i) {
        EXPECT_EQ(here.texels[i].face, there.texels[i].face);
        EXPECT_LT((here.texels[i].tangents.by_s - there.texels[i].tangents.by_s).length(), 1e-8)
            << "rounding of texture coordinates in sum";
    }
    EXPECT_EQ(texels_of(shifted(3, 2), {64, 64, 2, 2}).counts.covered, 0);

    const Mesh over_four = shifted(0.5, -0.5);
    const LimitSurface surface(over_four, {});
    const std::vector<std::pair<int, int>> tiles = {{0, -1}, {1, -1}, {0, 0}, {1, 0}};
    EXPECT_EQ(TexelMetrics(surface).tiles(), tiles);
    Mesh none = over_four;
    none.holes = {0, 1, 2, 3, 4, 5};
    const LimitSurface nothing(none, {});
    EXPECT_TRUE(TexelMetrics(nothing).tiles().empty());
    EXPECT_EQ(TexelMetrics(nothing).faces_without_surface(), 6);
    EXPECT_EQ(TexelMetrics(surface).faces_without_surface(), 0);
    int64_t covered = 0;
    for (const auto& [u, v] : tiles)
        covered += texels_of(over_four, {64, 64, u, v}).counts.covered;
    EXPECT_EQ(covered, here.counts.covered);
}

void expect_same(const TexelImage& a, const TexelImage& b)
{
    ASSERT_EQ(a.texels.size(), b.texels.size());
    for (size_t i = 0; i < a.texels.size(); ++i) {
        const TexelMetric &p = a.texels[i], &q = b.texels[i];
        ASSERT_TRUE(p.face == q.face && p.mirrored == q.mirrored && p.overlapped == q.overlapped &&
                    p.tangents.by_s == q.tangents.by_s && p.tangents.by_t == q.tangents.by_t &&
                    p.normal == q.normal && p.area == q.area)
            << "texel " << i;
    }
    EXPECT_EQ(a.counts.covered, b.counts.covered);
    EXPECT_EQ(a.counts.overlapped, b.counts.overlapped);
    EXPECT_EQ(a.counts.mirrored, b.counts.mirrored);
    EXPECT_EQ(a.counts.singular, b.counts.singular);
}

TEST(TexelMetric, SameInAnyBandsAndWithAnyThreads)
{
    SurfaceOptions options;
    options.rules.uv = UvRule::corners_plus1;
    const Mesh mesh = grid_mesh(
        {31, 29}, [](double a, double b) { return Vec3(a, b, std::sin(9 * a * b)); },
        [](double a, double b) { return Vec2(a * (0.7 + 0.3 * b), b * (1.2 - 0.5 * a)); });
    const TexelImage whole = texels_of(mesh, {67, 65}, options, 65);
    EXPECT_GT(whole.counts.covered, 1000);
    for (const int band : {1, 7, 64})
        expect_same(whole, texels_of(mesh, {67, 65}, options, band));
    for (const int threads : {1, 2, 5}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<size_t>(threads));
        expect_same(whole, texels_of(mesh, {67, 65}, options, 65));
    }
}

TEST(TexelMetric, OddSizes)
{
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 255), std::pair(257, 1),
                                        std::pair(3, 64), std::pair(128, 127)}) {
        const TexelImage image = texels_of(plane(kMaps[0]), {width, height});
        EXPECT_EQ(image.counts.covered, width * height);
    }
}

} // namespace
} // namespace scree::test
