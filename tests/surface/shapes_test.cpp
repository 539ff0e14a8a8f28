// Cylinder, torus and sphere: the metric of a cage's surface against that of the shape.
//
// A cubic B-spline whose control points lie on a circle, h apart, is a curve of (2 + cos h) / 3 the
// radius to fourth order; with control points scaled up by as much it is the circle, to fourth
// order. So shapes are compared as they are, at 1e-3 or better with few faces, and dense meshes
// with vertices on the shape, which is what a modeller makes, must come nearer by 4 a halving.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "surface/meshes.h"
#include "surface/texels.h"

namespace scree::test {
namespace {

constexpr double kTurn = 2 * M_PI;

/// The shape at angles a, b and its derivatives by them.
struct ShapePoint {
    Vec3 position, by_a, by_b;
    double curvature;
};

/// How much a control polygon must be larger for its curve to lie on the circle.
double swell(int faces) { return faces > 0 ? 3 / (2 + std::cos(kTurn / faces)) : 1; }

/// Radius `far` of the middle of a tube of radius `tube`, around z; a sphere for far = 0.
struct Torus {
    double far, tube;

    [[nodiscard]] ShapePoint at(double a, double b) const
    {
        const Vec3 out(std::cos(a), std::sin(a), 0), along(-std::sin(a), std::cos(a), 0);
        const double w = far + tube * std::cos(b);
        const Vec3 up(0, 0, 1);
        const double around_axis = std::abs(std::cos(b) / w);
        return {out * w + up * (tube * std::sin(b)), along * w,
                out * (-tube * std::sin(b)) + up * (tube * std::cos(b)),
                std::max(1 / tube, around_axis)};
    }
    [[nodiscard]] Vec3 control(double a, double b, double swell_a, double swell_b) const
    {
        const double w = far + tube * swell_b * std::cos(b);
        return {w * swell_a * std::cos(a), w * swell_a * std::sin(a), tube * swell_b * std::sin(b)};
    }
};

/// Largest errors over texels, relative but that of normals.
struct Errors {
    double by_s = 0, by_t = 0, area = 0, normal = 0, curvature = 0;
    int texels = 0;

    /// s_a, t_b  dP/ds and dP/dt in parts of the derivatives by a and b
    void add(const TexelMetric& got, const ShapePoint& want, double s_a, double t_b)
    {
        take(got.tangents.by_s, want.by_a * s_a, by_s);
        take(got.tangents.by_t, want.by_b * t_b, by_t);
        const Vec3 across = want.by_a % want.by_b;
        area = std::max(area, std::abs(got.area / std::abs(across.length() * s_a * t_b) - 1));
        normal = std::max(normal, (got.normal - across.normalized()).length());
        curvature =
            std::max(curvature, std::abs(static_cast<double>(got.curvature) / want.curvature - 1));
        ++texels;
    }

private:
    static void take(const Vec3& got, const Vec3& want, double& worst)
    {
        worst = std::max(worst, (got - want).length() / want.length());
    }
};

/// counted  whether a texel at angle b is
Errors torus_errors(const Torus& torus, int faces_a, int faces_b, bool swollen,
                    const std::function<bool(double)>& counted, UvRule uv = UvRule::all)
{
    const double swell_a = swollen ? swell(faces_a) : 1, swell_b = swollen ? swell(faces_b) : 1;
    const Mesh mesh = grid_mesh(
        {faces_a, faces_b, true, true},
        [&](double a, double b) { return torus.control(kTurn * a, kTurn * b, swell_a, swell_b); },
        plain_uv);
    SurfaceOptions options;
    options.rules.uv = uv;
    const TexelImage image = texels_of(mesh, {96, 80}, options);
    Errors errors;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 96; ++x) {
            const Vec2 at = image.uv(x, y) * kTurn;
            EXPECT_GE(image.at(x, y).face, 0);
            if (counted(at.y))
                errors.add(image.at(x, y), torus.at(at.x, at.y), kTurn, -kTurn);
        }
    EXPECT_GT(errors.texels, 0);
    return errors;
}

bool everywhere(double /*b*/) { return true; }
/// Away from the poles, where longitude has no direction; the grid runs over the poles and covers
/// the sphere a second time, inside out.
bool off_the_poles(double b) { return std::cos(b) > 0.2; }

TEST(Shapes, TorusAndSphereWithinOneInAThousand)
{
    const Errors errors[] = {torus_errors({2, 1}, 48, 40, true, everywhere),
                             torus_errors({2, 1}, 48, 40, true, everywhere, UvRule::corners_plus1),
                             torus_errors({0, 3}, 48, 48, true, off_the_poles)};
    for (const Errors& e : errors) {
        EXPECT_LT(e.by_s, 1e-4);
        EXPECT_LT(e.by_t, 1e-4);
        EXPECT_LT(e.area, 1e-4);
        EXPECT_LT(e.normal, 1e-4);
        EXPECT_LT(e.curvature, 5e-3) << "of second derivatives, second order";
    }
}

TEST(Shapes, DenseMeshesConvergeWithTheSquareOfTheirFaces)
{
    const Torus shapes[] = {{2, 1}, {0, 3}};
    for (const Torus& torus : shapes) {
        const auto counted = torus.far > 0 ? everywhere : off_the_poles;
        const Errors coarse = torus_errors(torus, 64, 64, false, counted);
        const Errors fine = torus_errors(torus, 128, 128, false, counted);
        // The fourth-order terms are (2 pi / 64)^2 of the second-order ones.
        EXPECT_NEAR(coarse.by_s / fine.by_s, 4, 0.1);
        EXPECT_NEAR(coarse.by_t / fine.by_t, 4, 0.1);
        EXPECT_NEAR(coarse.area / fine.area, 4, 0.1);
        EXPECT_LT(fine.by_s, 1e-3);
        EXPECT_LT(fine.by_t, 1e-3);
        EXPECT_LT(fine.area, 2e-3) << "a product of two errors";
    }
}

/// Open at both ends, and half the texture.
TEST(Shapes, Cylinder)
{
    constexpr double kRadius = 0.7, kHeight = 5;
    constexpr int kFaces = 32;
    const double radius = kRadius * swell(kFaces);
    const Mesh mesh = grid_mesh(
        {kFaces, 3, true, false},
        [&](double a, double b) {
            return Vec3(radius * std::cos(kTurn * a), radius * std::sin(kTurn * a), kHeight * b);
        },
        [](double a, double b) { return Vec2(a, 0.25 + 0.5 * b); });
    const TexelImage image = texels_of(mesh, {64, 64});
    Errors errors;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            ASSERT_EQ(image.at(x, y).face >= 0, y >= 16 && y < 48);
            if (y < 16 || y >= 48)
                continue;
            const double a = kTurn * image.uv(x, y).x;
            const ShapePoint point{
                {}, Vec3(-std::sin(a), std::cos(a), 0) * kRadius, Vec3(0, 0, kHeight), 1 / kRadius};
            errors.add(image.at(x, y), point, kTurn, -2);
        }
    EXPECT_EQ(errors.texels, 64 * 32);
    EXPECT_LT(errors.by_s, 1e-4);
    EXPECT_LT(errors.by_t, 1e-12) << "straight";
    EXPECT_LT(errors.area, 1e-4);
    EXPECT_LT(errors.normal, 1e-4);
    EXPECT_LT(errors.curvature, 5e-3) << "of second derivatives, second order";
}

/// Six square charts of a cube blown up to a sphere: eight vertices of valence 3, and a fold in the
/// parameters along every edge of the cube. Its normals and its area have closed forms all the
/// same.
Errors ball_errors(int faces, double& area)
{
    const auto on_sphere = [](const Vec3& p) { return p.normalized(); };
    const double mean_swell = swell(4 * faces);
    Mesh mesh;
    mesh.name = "ball";
    // The vertices of the six grids are joined by their place.
    std::vector<Vec3> known;
    const auto vertex = [&](const Vec3& cube) {
        for (size_t i = 0; i < known.size(); ++i)
            if ((known[i] - cube).length2() < 1e-12)
                return static_cast<int>(i);
        known.push_back(cube);
        mesh.vertices.push_back(on_sphere(cube) * mean_swell);
        return static_cast<int>(known.size()) - 1;
    };
    for (int side = 0; side < 6; ++side) {
        const int axis = side % 3;
        const double sign = side < 3 ? 1 : -1;
        for (int j = 0; j < faces; ++j)
            for (int i = 0; i < faces; ++i) {
                mesh.face_sizes.push_back(4);
                for (const auto& [x, y] : {std::pair(i, j), std::pair(i + 1, j),
                                           std::pair(i + 1, j + 1), std::pair(i, j + 1)}) {
                    // Equal angles; mirrored on three sides, so that all faces look out.
                    const double a = std::tan(M_PI / 4 * (2.0 * x / faces - 1));
                    const double b = std::tan(M_PI / 4 * (2.0 * y / faces - 1));
                    Vec3 cube;
                    cube[axis] = sign;
                    cube[(axis + 1) % 3] = a;
                    cube[(axis + 2) % 3] = sign * b;
                    mesh.face_vertices.push_back(vertex(cube));
                    mesh.face_uvs.push_back(static_cast<int>(mesh.uvs.size()));
                    mesh.uvs.emplace_back((side % 3 + 1.0 * x / faces) / 3,
                                          (side / 3 + 1.0 * y / faces) / 2);
                }
            }
    }
    const TexelGrid grid{150, 100};
    const LimitSurface surface(mesh, {});
    const TexelImage image = texels_of(mesh, grid);
    Errors errors;
    area = 0;
    for (const TexelMetric& texel : image.texels) {
        EXPECT_GE(texel.face, 0);
        EXPECT_FALSE(texel.mirrored);
        EXPECT_TRUE(std::isfinite(texel.curvature));
        area += texel.area / (grid.width * grid.height);
        // The radial direction at the middle of the face is all that is known here.
        const size_t first = 4 * static_cast<size_t>(texel.face);
        Vec3 out(0, 0, 0);
        for (size_t k = 0; k < 4; ++k)
            out += mesh.vertices[static_cast<size_t>(mesh.face_vertices[first + k])];
        errors.normal = std::max(errors.normal, (texel.normal - out.normalized()).length());
        ++errors.texels;
    }
    return errors;
}

TEST(Shapes, BallWithExtraordinaryVertices)
{
    double coarse = 0, fine = 0;
    ball_errors(16, coarse);
    const Errors errors = ball_errors(32, fine);
    EXPECT_EQ(errors.texels, 15000);
    // Half a diagonal of a face, and what the surface misses of the sphere.
    EXPECT_LT(errors.normal, 1.1 * M_PI / 4 / 32 * std::sqrt(2.0));
    EXPECT_NEAR(fine / (4 * M_PI), 1, 1e-3);
    EXPECT_NEAR((4 * M_PI - coarse) / (4 * M_PI - fine), 4, 0.4) << "second order";
}

} // namespace
} // namespace scree::test
