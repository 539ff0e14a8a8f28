#include "reference/displaced_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "reference/ray_oracle.h"
#include "reference/reliefs.h"
#include "reference/statistics.h"

namespace scree::reference {
namespace {

using test::direction;
using test::Uniform;

constexpr Beyond kAllBeyonds[] = {Beyond::repeats, Beyond::mirrors, Beyond::extends, Beyond::ends};

/// Random maps of awkward sizes, each with a pair of ways to go on, texels that are not square and,
/// every other one, holes.
std::vector<Relief> awkward_reliefs()
{
    constexpr int kSizes[][2] = {{1, 1}, {1, 7}, {7, 1}, {2, 2}, {5, 3}, {33, 17}};
    std::vector<Relief> reliefs;
    unsigned seed = 0;
    for (const auto& size : kSizes)
        for (const Beyond beyond_s : kAllBeyonds)
            for (const Beyond beyond_t : kAllBeyonds) {
                Relief relief = test::rough_relief(size[0], size[1], ++seed);
                relief.beyond_s = beyond_s;
                relief.beyond_t = beyond_t;
                relief.texel_width = 0.5;
                relief.texel_height = 0.75;
                if (seed % 2 == 0)
                    test::punch_holes(relief, seed);
                reliefs.push_back(std::move(relief));
            }
    return reliefs;
}

std::string name(const Relief& relief)
{
    return std::to_string(relief.width) + "x" + std::to_string(relief.height) + ", beyond " +
           std::to_string(static_cast<int>(relief.beyond_s)) + " " +
           std::to_string(static_cast<int>(relief.beyond_t));
}

/// A position; every other coordinate lies on a border of a texel or of a cell.
double position(Uniform& uniform, int size)
{
    const double place = uniform() * size;
    const double choice = uniform();
    return choice < 0.5 ? place : std::floor(place) + (choice < 0.75 ? 0.0 : 0.5);
}

// Oracle: every cell under the ray in long double. What is closer than 1e-12 of the relief is
// neither open nor hidden; there are few of those.
TEST(DisplacedSurface, IsOpenWhereNoCellRisesAboveTheRay)
{
    int open = 0, hidden = 0, undecided = 0;
    for (const Relief& relief : awkward_reliefs()) {
        const DisplacedSurface surface(relief);
        const double high = oracle::above_all(relief);
        Uniform uniform(7);
        for (int k = 0; k < 60; ++k) {
            const double s = position(uniform, relief.width);
            const double t = position(uniform, relief.height);
            const SurfacePoint point = surface.at(s, t);
            const double theta = k % 3 == 0 ? 80 + 9.9 * uniform() : 80 * uniform();
            const double azimuth = k % 4 == 0 ? 90.0 * k : 360 * uniform();
            const Vec3 w = direction(theta, azimuth);
            if (!(point.weight > 0)) {
                EXPECT_FALSE(surface.is_open(s, t, w));
                continue;
            }
            const double reach = std::max(0.0, (high - point.height) / w.z);
            const auto clear = oracle::follow(relief, s, t, point.height, w, reach);
            const double slack = 1e-12;
            if (clear.least < -slack || clear.least > -1e-15) {
                EXPECT_EQ(surface.is_open(s, t, w), clear.least > -slack)
                    << name(relief) << " from " << s << " " << t << " theta " << theta
                    << " azimuth " << azimuth << " clearance " << clear.least;
                ++(clear.least > -slack ? open : hidden);
            } else {
                ++undecided;
            }
        }
    }
    EXPECT_GT(open, 500);
    EXPECT_GT(hidden, 500);
    EXPECT_LT(undecided, (open + hidden) / 20);
}

// Oracle: the first change of sign along the ray in long double. Tolerance: where a ray touches the
// surface the crossing moves by the square root of the rounding; 1e-6 texels cover it here.
TEST(DisplacedSurface, RaysMeetTheSurfaceWhereTheyFirstCrossIt)
{
    int met = 0, missed = 0;
    for (const Relief& relief : awkward_reliefs()) {
        const DisplacedSurface surface(relief);
        Uniform uniform(8);
        for (int k = 0; k < 40; ++k) {
            const double theta = k % 3 == 0 ? 80 + 9 * uniform() : 80 * uniform();
            const Vec3 up = direction(theta, k % 4 == 0 ? 90.0 * k : 360 * uniform());
            const bool from_above = k % 5 != 0;
            const Vec3 d = from_above ? -up : up;
            // Inside, where the relief ends at its edges; anywhere, where it goes on.
            const bool ends_s =
                relief.beyond_s == Beyond::extends || relief.beyond_s == Beyond::ends;
            const bool ends_t =
                relief.beyond_t == Beyond::extends || relief.beyond_t == Beyond::ends;
            const double s = uniform() * relief.width + (ends_s ? 0 : 100 * (uniform() - 0.5));
            const double t = uniform() * relief.height + (ends_t ? 0 : 100 * (uniform() - 0.5));
            const double z = from_above ? surface.highest() + 0.01 : surface.lowest() - 0.01;
            const double reach = (surface.highest() - surface.lowest() + 0.02) / std::abs(d.z);
            const auto clear = oracle::follow(relief, s, t, z, d, reach);
            const auto hit = surface.hit({s * relief.texel_width, t * relief.texel_height, z}, d);
            const std::string which = name(relief) + " from " + std::to_string(s) + " " +
                                      std::to_string(t) + " theta " + std::to_string(theta);
            ASSERT_EQ(hit.has_value(), clear.crossing.has_value()) << which;
            ++(hit ? met : missed);
            if (!hit)
                continue;
            EXPECT_NEAR(hit->distance, static_cast<double>(*clear.crossing), 1e-6) << which;
            const SurfacePoint point = surface.at(hit->s, hit->t);
            if (point.weight > 0) {
                EXPECT_NEAR(point.height, z + hit->distance * d.z, 1e-9) << which;
            }
        }
    }
    EXPECT_GT(met, 1000);
    EXPECT_GT(missed, 300);
}

TEST(DisplacedSurface, RaysComeInFromFarAway)
{
    Relief relief = test::relief_of(8, 4, [](int x, int) { return 0.1 * x; });
    relief.beyond_s = Beyond::repeats;
    relief.beyond_t = Beyond::extends;
    const DisplacedSurface surface(relief);
    // Comes down to z = 0.35, the height of texel 3 and a half, at s = 4 of an image far away and
    // t = 2, having entered the relief at t = 0 just before.
    const Vec3 target(4 - 8 * 1000.0, 2, 0.35);
    const Vec3 d = Vec3(0.5, 1, -0.01).normalized();
    const auto hit = surface.hit(target - d * 300.0, d);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 2, 1e-9);
    EXPECT_NEAR(hit->s, 4, 1e-9);
    EXPECT_NEAR(hit->distance, 300, 1e-9);
    EXPECT_FALSE(surface.hit({4, -1, 0.35}, {1, 0, 0})); // beside it, and never enters
    EXPECT_FALSE(surface.hit({4, 2, 8}, {0, 0, 1}));     // above, and goes up
}

// Oracle: the statistics' own, by Gauss quadrature of the slopes at(s, t) gives; the slope is
// linear in each quarter of a texel, so 3 x 3 points in each are exact for the covariance.
TEST(DisplacedSurface, SlopesAreThoseOfTheStatistics)
{
    const double nodes[] = {(1 - std::sqrt(0.6)) / 2, 0.5, (1 + std::sqrt(0.6)) / 2};
    const double weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    for (const Relief& relief : awkward_reliefs()) {
        StatisticsInput input;
        input.relief = relief;
        const Statistics truth(input);

        const DisplacedSurface surface(relief);
        for (int y = 0; y < relief.height; ++y)
            for (int x = 0; x < relief.width; ++x) {
                Vec2 mean(0, 0);
                double ss = 0, st = 0, tt = 0, weight = 0;
                for (int k = 0; k < 36; ++k) {
                    const int i = k % 6, j = k / 6;
                    const int right = i / 3, below = j / 3;
                    const SurfacePoint p =
                        surface.at(x + (right + nodes[i % 3]) / 2, y + (below + nodes[j % 3]) / 2);
                    const double share = weights[i % 3] * weights[j % 3] / 4;
                    weight = p.weight;
                    mean += p.slope * share;
                    ss += p.slope.x * p.slope.x * share;
                    st += p.slope.x * p.slope.y * share;
                    tt += p.slope.y * p.slope.y * share;
                }
                const Texel texel = truth.at(0, x, y);
                const std::string which =
                    name(relief) + " texel " + std::to_string(x) + " " + std::to_string(y);
                ASSERT_NEAR(weight, texel.coverage, 1e-7) << which;
                if (!(weight > 0))
                    continue;
                EXPECT_NEAR(mean.x, texel.mean_slope[0], 1e-13) << which;
                EXPECT_NEAR(mean.y, texel.mean_slope[1], 1e-13) << which;
                EXPECT_NEAR(ss - mean.x * mean.x, texel.cov_slope[0], 1e-12) << which;
                EXPECT_NEAR(tt - mean.y * mean.y, texel.cov_slope[1], 1e-12) << which;
                EXPECT_NEAR(st - mean.x * mean.y, texel.cov_slope[2], 1e-12) << which;
            }
    }
}

// Slopes stay below cot(89.9 degrees), so nothing hides anything: no acne, on borders either.
TEST(DisplacedSurface, GentleSlopesAreOpenAtGrazingAngles)
{
    const double steepest = 0.99 / std::tan(test::radians(89.9));
    const double amplitude = steepest / (2 * test::kPi / 32) / std::sqrt(2.0);
    const Relief relief = test::relief_of(32, 32, [&](int x, int y) {
        return amplitude * (std::sin(2 * test::kPi * x / 32) + std::cos(2 * test::kPi * y / 32));
    });
    const DisplacedSurface surface(relief);
    Uniform uniform(9);
    for (int k = 0; k < 20000; ++k) {
        const double s = position(uniform, 32), t = position(uniform, 32);
        const double azimuth = k % 2 == 0 ? 45.0 * k : 360 * uniform();
        ASSERT_TRUE(surface.is_open(s, t, direction(89.9, azimuth)))
            << s << " " << t << " azimuth " << azimuth;
    }
}

// A low wall seen at 89.9 degrees from behind: no light leaks through it, be it the highest there
// is or 1e-8 of the relief, at its foot or at its top. The grid's tolerance, 6e-8 then, takes 4e-5
// texels off its shadow.
TEST(DisplacedSurface, LowWallsHideWhatLiesBehindThem)
{
    const double wall = 0.01;
    const double shadow = wall * std::tan(test::radians(89.9)); // texels, from the wall's top
    EXPECT_GT(shadow, 5);
    for (const double elsewhere : {0.0, 1e6, -1e6}) {
        Relief relief = test::relief_of(64, 8, [&](int x, int) { return x == 32 ? wall : 0.0; });
        relief.heights[size_t{7} * 64] = elsewhere; // far from the rays
        relief.beyond_s = relief.beyond_t = Beyond::extends;
        const DisplacedSurface surface(relief);
        for (int k = 101; k < 2000; ++k) {
            const double away = 0.01 * k;
            EXPECT_EQ(surface.is_open(32.5 - away, 3.5, direction(89.9, 0)), away > shadow)
                << away << " " << elsewhere;
        }
    }
}

// Most of it lies as low as can be: the ray ends there, to rounding.
TEST(DisplacedSurface, FlatFloorsAreMet)
{
    const Relief relief =
        test::relief_of(16, 16, [](int x, int y) { return x == 5 && y == 5 ? 0.1 : -0.7; });
    const DisplacedSurface surface(relief);
    Uniform uniform(12);
    for (int k = 0; k < 5000; ++k) {
        const Vec3 d = -direction(85 * uniform(), 360 * uniform());
        const Vec3 origin(100 * uniform(), 100 * uniform(), 3);
        const auto hit = surface.hit(origin, d);
        ASSERT_TRUE(hit) << d;
        EXPECT_LE(hit->distance, -3.7 / d.z * (1 + 1e-15));
    }
}

// A power of two scales every number exactly, and so does an offset that all heights can carry.
TEST(DisplacedSurface, UnitsAndOffsetsChangeNothing)
{
    Relief relief = test::rough_relief(33, 17, 10);
    for (double& h : relief.heights)
        h = std::round(h * 0x1p20) * 0x1p-20;
    const DisplacedSurface surface(relief);
    for (const double unit : {0x1p-60, 0x1p60})
        for (const double offset : {0.0, 1e6}) {
            Relief scaled = relief;
            for (double& h : scaled.heights)
                h = (h + offset) * unit;
            scaled.texel_width = scaled.texel_height = unit;
            const DisplacedSurface same(scaled);
            Uniform uniform(11);
            for (int k = 0; k < 2000; ++k) {
                const double s = position(uniform, 33), t = position(uniform, 17);
                const Vec3 w = direction(50 + 39.9 * uniform(), 360 * uniform());
                ASSERT_EQ(same.is_open(s, t, w), surface.is_open(s, t, w)) << unit << " " << offset;
                ASSERT_EQ(same.at(s, t).slope, surface.at(s, t).slope) << unit << " " << offset;
            }
        }
}

} // namespace
} // namespace scree::reference
