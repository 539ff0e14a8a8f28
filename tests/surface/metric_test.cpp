// Frame, Jacobian and the law of slopes, against vector algebra in space and closed forms.

#include "surface/metric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace scree::test {
namespace {

/// The tangent vector w with w . P_s = g_s and w . P_t = g_t: the height's gradient in space. By
/// the Gram matrix; knows nothing of frames.
Vec3 gradient_in_space(const Tangents& p, const Vec2& g)
{
    const double ss = p.by_s ^ p.by_s, st = p.by_s ^ p.by_t, tt = p.by_t ^ p.by_t;
    const double determinant = ss * tt - st * st;
    return p.by_s * ((tt * g.x - st * g.y) / determinant) +
           p.by_t * ((ss * g.y - st * g.x) / determinant);
}

class Random {
public:
    double operator()() { return law_(engine_); }
    Vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }

private:
    std::mt19937 engine_{7};
    std::normal_distribution<double> law_;
};

/// Rounding grows with the shear; the law keeps skewed tangents below 1e4.
constexpr double kRounding = 1e-11;

TEST(Metric, FrameIsOrthonormalInTheTangentPlaneOnTheSideOfDpDt)
{
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Tangents p{random.vector(), random.vector()};
        const TangentFrame frame = tangent_frame(p);
        const Vec3 normal = (p.by_s % p.by_t).normalized();
        EXPECT_NEAR(frame.x.length(), 1, kRounding);
        EXPECT_NEAR(frame.y.length(), 1, kRounding);
        EXPECT_NEAR(frame.x ^ frame.y, 0, kRounding);
        EXPECT_NEAR(frame.y ^ normal, 0, kRounding);
        EXPECT_NEAR(frame.x ^ p.by_s, p.by_s.length(), kRounding);
        EXPECT_GT(frame.y ^ p.by_t, 0);
        // The columns of J are the tangents in the frame.
        const TextureJacobian j = texture_jacobian(p);
        EXPECT_NEAR(j.xs, frame.x ^ p.by_s, kRounding);
        EXPECT_NEAR(j.xt, frame.x ^ p.by_t, kRounding);
        EXPECT_NEAR(j.yt, frame.y ^ p.by_t, kRounding);
        EXPECT_NEAR(area(j), (p.by_s % p.by_t).length(), kRounding * area(j));
    }
}

TEST(Metric, SlopesAreComponentsOfTheGradientInSpace)
{
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Tangents p{random.vector(), random.vector()};
        const Vec2 g(random(), random());
        const Vec3 w = gradient_in_space(p, g);
        const TangentFrame frame = tangent_frame(p);
        const Vec2 slope = surface_slope(texture_jacobian(p), g);
        EXPECT_NEAR(slope.x, w ^ frame.x, kRounding * (1 + w.length()));
        EXPECT_NEAR(slope.y, w ^ frame.y, kRounding * (1 + w.length()));
    }
}

TEST(Metric, CovarianceIsThatOfTheSlopes)
{
    Random random;
    for (int i = 0; i < 200; ++i) {
        const TextureJacobian j = texture_jacobian({random.vector(), random.vector()});
        SlopeCovariance cov, expected;
        for (int sample = 0; sample < 5; ++sample) {
            const Vec2 g(random(), random());
            cov.xx += g.x * g.x;
            cov.xy += g.x * g.y;
            cov.yy += g.y * g.y;
            const Vec2 slope = surface_slope(j, g);
            expected.xx += slope.x * slope.x;
            expected.xy += slope.x * slope.y;
            expected.yy += slope.y * slope.y;
        }
        const SlopeCovariance got = surface_covariance(j, cov);
        const double size = expected.xx + expected.yy;
        EXPECT_NEAR(got.xx, expected.xx, 1e-11 * size);
        EXPECT_NEAR(got.xy, expected.xy, 1e-11 * size);
        EXPECT_NEAR(got.yy, expected.yy, 1e-9 * size) << "differences of products";
    }
}

/// A point of the torus R = 2, r = 1 with exact derivatives; p runs around the axis, q around the
/// tube.
SurfacePoint torus(double p, double q)
{
    const double cp = std::cos(p), sp = std::sin(p), cq = std::cos(q), sq = std::sin(q);
    const double w = 2 + cq;
    return {{w * cp, w * sp, sq},  {-w * sp, w * cp, 0},   {-sq * cp, -sq * sp, cq},
            {-w * cp, -w * sp, 0}, {sq * sp, -sq * cp, 0}, {-cq * cp, -cq * sp, -sq}};
}

TEST(Metric, CurvatureOfTheTorus)
{
    for (double p = 0; p < 6; p += 0.7)
        for (double q = 0; q < 6.3; q += 0.3) {
            const SurfacePoint point = torus(p, q);
            const Vec3 normal = unit_normal(point);
            EXPECT_NEAR(normal ^
                            Vec3(std::cos(p) * std::cos(q), std::sin(p) * std::cos(q), std::sin(q)),
                        1, 1e-12);
            // 1 around the tube; cos q / (2 + cos q) around the axis is never more.
            EXPECT_NEAR(largest_curvature(point, normal), 1, 1e-12);
        }
}

TEST(Metric, CurvatureOfQuadricsInSkewParameters)
{
    // z = (a x^2 + b y^2) / 2 with (x, y) = (p + 0.5 q, 2 q): curvatures a and b at 0.
    for (const double a : {0.0, 1.0, -3.0, 2.0})
        for (const double b : {0.0, 1.0, -3.0, 2.5}) {
            SurfacePoint point;
            point.by_p = Vec3(1, 0, 0);
            point.by_q = Vec3(0.5, 2, 0);
            point.by_pp = Vec3(0, 0, a);
            point.by_pq = Vec3(0, 0, 0.5 * a);
            point.by_qq = Vec3(0, 0, 0.25 * a + 4 * b);
            EXPECT_NEAR(largest_curvature(point, unit_normal(point)),
                        std::max(std::abs(a), std::abs(b)), 1e-7)
                << a << " " << b << ": the root of a rounding error where a = b";
        }
}

TEST(Metric, TangentsUndoTheParameters)
{
    Random random;
    for (int i = 0; i < 1000; ++i) {
        SurfacePoint point;
        point.by_p = random.vector();
        point.by_q = random.vector();
        UvPoint uv;
        uv.by_p = Vec2(random(), random());
        uv.by_q = Vec2(random(), random());
        const Tangents p = tangents(point, uv);
        // The chain rule, P_p = P_s s_p + P_t t_p with t = 1 - v.
        const double size = p.by_s.length() + p.by_t.length();
        const Vec3 by_p = p.by_s * uv.by_p.x - p.by_t * uv.by_p.y;
        const Vec3 by_q = p.by_s * uv.by_q.x - p.by_t * uv.by_q.y;
        EXPECT_NEAR((by_p - point.by_p).length(), 0, 1e-13 * (10 + 10 * size));
        EXPECT_NEAR((by_q - point.by_q).length(), 0, 1e-13 * (10 + 10 * size));
    }
}

/// Slopes of the displaced surface, exactly, on a cylinder of radius r: the displaced section is
/// the plane curve of radius r + h(x), whose slope against the circle is h' r / (r + h).
TEST(Metric, DisplacementErrorIsWhatACylinderShows)
{
    const double radius = 2, height = 0.05, slope = 0.3;
    const double exact = slope * radius / (radius + height);
    const double error = displacement_error(height, 1 / radius);
    EXPECT_NEAR(std::abs(exact / slope - 1), error, error * error);
    EXPECT_EQ(displacement_error(-height, 1 / radius), error);
}

} // namespace
} // namespace scree::test
