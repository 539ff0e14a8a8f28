// What is seen of surfaces whose shadows can be told in closed form.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "visibility/swept.h"

namespace scree {
namespace {

using test::around;
using test::heights_of;
using test::kPi;
using test::radians;
using test::shape_of;
using test::swept;
using test::whole_block;

const std::vector<double> kThetas = {0.5, 30, 60, 80, 89};

double at(const std::vector<float>& values, int i)
{
    return static_cast<double>(values[static_cast<size_t>(i)]);
}

TEST(Sweep, SeesAllOfALevelPlane)
{
    const Edge edges[] = {Edge::periodic, Edge::extend, Edge::repeat, Edge::zero};
    for (const Edge edge : edges)
        for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {1, 3}, {33, 20}}) {
            HeightGrid::Shape shape = shape_of(width, height, edge, edge);
            shape.texel_height = 0.4;
            shape.ground = -7.5F;
            const MemoryHeights grid = heights_of(shape, [](int, int) { return -7.5; });
            for (const double azimuth : around(24))
                for (const auto& seen : swept(grid, whole_block(grid), azimuth, kThetas))
                    for (const float v : seen) // sums and differences of halves of a drop: exact,
                                               // but where the height is many drops
                        ASSERT_NEAR(static_cast<double>(v), 1, 1e-4)
                            << width << " x " << height << ", azimuth " << azimuth;
        }
}

/// v = 1 - tan theta (slope towards the viewer), up to the border; nothing where that is negative.
TEST(Sweep, SeesATiltedPlaneThatEndsAsOneMinusItsSlope)
{
    HeightGrid::Shape shape = shape_of(40, 27, Edge::extend, Edge::extend);
    shape.texel_width = 0.5;
    const Vec2 slope(0.3, -0.2);
    const MemoryHeights grid = heights_of(
        shape, [&](int x, int y) { return slope.x * x * shape.texel_width + slope.y * y; });
    for (const double azimuth : around(48)) {
        const auto seen = swept(grid, whole_block(grid), azimuth, kThetas);
        for (size_t k = 0; k < kThetas.size(); ++k) {
            const double towards =
                slope.x * std::cos(radians(azimuth)) + slope.y * std::sin(radians(azimuth));
            const double want = std::max(0.0, 1 - towards / test::cotangent(kThetas[k]));
            // Heights to 10 are rounded to 2^-21, four of them a texel, over a drop of 0.35 cot;
            // and what is made of them, about 1.
            const double rounding =
                4 * std::pow(2.0, -21) / (0.35 * test::cotangent(kThetas[k])) + 2e-7;
            for (const float v : seen[k])
                ASSERT_NEAR(static_cast<double>(v), want, rounding)
                    << "azimuth " << azimuth << " theta " << kThetas[k];
        }
    }
}

/// Holes in a plane are filled up to the middle of its texels, and hide nothing.
TEST(Sweep, SeesWhatIsLeftOfAPlaneAsThePlane)
{
    const Edge edges[] = {Edge::extend, Edge::zero};
    for (const Edge edge : edges) {
        HeightGrid::Shape shape = shape_of(60, 60, edge, edge);
        test::Uniform uniform(6);
        std::vector<bool> missing;
        const Vec2 slope(edge == Edge::extend ? Vec2(0.3, -0.2) : Vec2(0, 0));
        const MemoryHeights grid = heights_of(shape, [&](int x, int y) {
            missing.push_back(uniform() < 0.15 || (x > 20 && x < 30 && y > 40));
            return missing.back() ? std::nan("") : slope.x * x + slope.y * y;
        });
        for (const double azimuth : around(24))
            for (const double theta : {30.0, 60.0, 80.0}) {
                const auto seen = swept(grid, whole_block(grid), azimuth, {theta});
                const double towards =
                    slope.x * std::cos(radians(azimuth)) + slope.y * std::sin(radians(azimuth));
                const double want = std::max(0.0, 1 - towards / test::cotangent(theta));
                // Inside the border, where there are two texels in a row to continue. Heights to 18
                // over a drop of 0.18 are rounded as above.
                for (int y = 1; y < 59; ++y)
                    for (int x = 1; x < 59; ++x) {
                        const int i = y * 60 + x;
                        ASSERT_NEAR(at(seen[0], i), missing[static_cast<size_t>(i)] ? 0 : want,
                                    1e-4)
                            << "azimuth " << azimuth << " theta " << theta << " texel " << i;
                    }
            }
    }
}

/// A row of towers between texels without data: no cell of theirs is whole, so they hide nothing.
TEST(Sweep, SeesThroughCellsThatLackTexels)
{
    for (const bool along_s : {true, false}) {
        const HeightGrid::Shape shape = shape_of(30, 30, Edge::extend, Edge::extend);
        const MemoryHeights grid = heights_of(shape, [&](int x, int y) {
            const int beside = std::abs((along_s ? y : x) - 15);
            return beside == 0 ? 9 : beside == 1 ? std::nan("") : 0;
        });
        for (const double azimuth : around(24)) {
            const auto seen = swept(grid, whole_block(grid), azimuth, {70.0});
            for (int i = 0; i < 900; ++i) {
                const bool is_ground = std::abs((along_s ? i / 30 : i % 30) - 15) > 1;
                if (is_ground) {
                    ASSERT_NEAR(at(seen[0], i), 1, 1e-5) << azimuth << " texel " << i;
                }
            }
        }
    }
}

TEST(Sweep, SeesNothingWhereNothingIs)
{
    const MemoryHeights none = heights_of(shape_of(5, 4), [](int, int) { return std::nan(""); });
    const MemoryHeights one = heights_of(
        shape_of(5, 4), [](int x, int y) { return x == 2 && y == 1 ? 7 : std::nan(""); });
    for (const double azimuth : {0.0, 45.0, 100.0})
        for (const double theta : {10.0, 85.0})
            for (int i = 0; i < 20; ++i) {
                EXPECT_EQ(at(swept(none, whole_block(none), azimuth, {theta})[0], i), 0);
                EXPECT_NEAR(at(swept(one, whole_block(one), azimuth, {theta})[0], i),
                            i == 7 ? 1 : 0, 1e-5);
            }
}

/// A wall across the map, its faces one texel wide, seen across: by hand. From its front edge on
/// behind it, height times tan theta of ground lies in its shadow.
TEST(Sweep, SeesTheShadowOfAWall)
{
    constexpr int kSize = 64, kFirst = 20, kLast = 23; // texels of its top
    const double height = 1.7;
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0})
        for (const double theta : {50.0, 70.0, 84.0}) {
            const bool along_s = azimuth == 0 || azimuth == 180;
            const bool forwards = azimuth >= 180; // places grow away from the viewer
            const MemoryHeights grid = heights_of(shape_of(kSize, kSize), [&](int x, int y) {
                const int place = along_s ? x : y;
                const int step = forwards ? place : kSize - 1 - place;
                return step >= kFirst && step <= kLast ? height : 0;
            });
            const double front = height * std::tan(radians(theta)); // the face shows this in all
            const auto seen = swept(grid, whole_block(grid), azimuth, {theta});
            for (int step = 0; step < kSize; ++step) {
                // Ground is seen but from the top's back edge to where the sight over it ends.
                const double dark_end = kLast + front;
                const double bright = std::min(1.0, std::max(0.0, step + 0.5 - dark_end));
                double want = step < kFirst - 1 || step > kLast ? bright : 1;
                want = step < kFirst - 1 ? 1 : want;
                if (step == kFirst - 1 || step == kFirst)
                    want = 1 + front / 2;
                if (step == kLast) // half of it is top
                    want = 0.5;
                const int place = forwards ? step : kSize - 1 - step;
                for (const int other : {0, 31, 63})
                    ASSERT_NEAR(
                        at(seen[0], along_s ? other * kSize + place : place * kSize + other), want,
                        1e-5)
                        << "azimuth " << azimuth << " theta " << theta << " step " << step;
            }
        }
}

/// Grooves with sides of one slope, seen across: the side that faces the viewer shows 1 + slope tan
/// theta of itself from the top down, until all of the width is made up for; the other side what is
/// left of 1, or nothing.
TEST(Sweep, SeesTheUpperPartOfGrooves)
{
    constexpr int kHalf = 16; // texels from top to bottom
    for (const double slope : {0.05, 0.5, 2.0})
        for (const double theta : {40.0, 65.0, 85.0}) {
            // A zigzag with its tops at texels 0, 32, ...
            const MemoryHeights grid = heights_of(shape_of(6 * kHalf, 4), [&](int x, int) {
                return slope * std::abs(x % (2 * kHalf) - kHalf);
            });
            const auto seen = swept(grid, whole_block(grid), 180, {theta}); // away is +s
            const double tan = slope * std::tan(radians(theta));
            // Texels of the facing side that are seen, from its top: they hold all of the width.
            const double length = std::min<double>(kHalf, 2 * kHalf / (1 + tan));
            for (int x = 0; x < 2 * kHalf; ++x) {
                // The texel's two halves; texel 0 and kHalf lie on both sides.
                double want = 0;
                for (const double from : {x - 0.5, x + 0.0}) {
                    const double middle = from < 0 ? from + 2 * kHalf : from;
                    const bool down = middle < kHalf; // away from the viewer
                    const double low = middle, high = middle + 0.5;
                    want +=
                        down ? 0.5 * std::max(0.0, 1 - tan)
                             : (1 + tan) * std::max(0.0, high - std::max(low, 2 * kHalf - length));
                }
                ASSERT_NEAR(at(seen[0], 2 * kHalf + x), want, 2e-5)
                    << "slope " << slope << " theta " << theta << " texel " << x;
            }
        }
}

/// h = a cos(k x), seen along x: bright is from where the sight over a crest meets the next one to
/// that crest's own tangent point. Both are roots, found by halving.
TEST(Sweep, SeesWavesFromSightToTangent)
{
    constexpr int kWave = 256; // texels
    const double k = 2 * kPi / kWave;
    const double a = 30;
    const auto halved = [](double low, double high, const auto& rises) {
        for (int i = 0; i < 100; ++i)
            (rises((low + high) / 2) ? low : high) = (low + high) / 2;
        return low;
    };
    const MemoryHeights grid =
        heights_of(shape_of(kWave, 2), [&](int x, int) { return a * std::cos(k * x); });
    for (const double theta : {50.0, 70.0, 80.0, 86.0}) {
        const double cot = test::cotangent(theta);
        const auto g = [&](double x) { return a * std::cos(k * x) + x * cot; }; // away is +x
        double bright = 0, tangent = kWave;                                     // without shadows
        if (a * k > cot) {
            // Where the surface turns away: g' = 0 behind the crest at 0, that is before kWave / 4.
            const double behind =
                halved(0, kWave / 4.0, [&](double x) { return cot - a * k * std::sin(k * x) > 0; });
            // Up the next wave's front to the height of the sight.
            bright = halved(kWave / 2.0, kWave, [&](double x) { return g(x) < g(behind); });
            tangent = kWave + behind;
        }
        const auto seen = swept(grid, whole_block(grid), 180, {theta});
        for (int x = 0; x < kWave; ++x) {
            double want = 0;
            for (const int period : {-kWave, 0, kWave}) {
                const double low = std::max(x + period - 0.5, bright);
                const double high = std::min(x + period + 0.5, tangent);
                want += high > low ? (g(high) - g(low)) / cot : 0;
            }
            // Straight pieces between texels miss a k^2 / 8 of the height at most, twice a texel.
            ASSERT_NEAR(at(seen[0], x), want, a * k * k / 4 / cot) << "theta " << theta << " " << x;
        }
    }
}

} // namespace
} // namespace scree
