#include "tables/linear_light_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/linear_scenes.h"

namespace scree {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// What the table is of, in the source's own words: tan^2 alpha over the light, by brute force.
struct Curve {
    double cos_v, cos_n, phi_n;

    [[nodiscard]] double cosine_sum(double phi) const // l.n + v.n
    {
        const double sin_v = std::sqrt(1 - cos_v * cos_v), sin_n = std::sqrt(1 - cos_n * cos_n);
        return sin_n * std::cos(phi - phi_n) + cos_v * cos_n + sin_v * sin_n * std::cos(phi_n);
    }
    [[nodiscard]] double tan2(double phi) const
    {
        const double sum = cosine_sum(phi);
        return 2 * (1 + std::sqrt(1 - cos_v * cos_v) * std::cos(phi)) / (sum * sum) - 1;
    }
    [[nodiscard]] double lowest(int samples) const
    {
        double least = 1e30;
        for (int i = 0; i < samples; ++i) {
            const double phi = -kPi + 2 * kPi * i / samples;
            if (cosine_sum(phi) > 1e-6)
                least = std::min(least, tan2(phi));
        }
        return least;
    }
};

/// Calls look(texel, curve) for every texel where the surface can be seen.
template <class Look>
int look_at_texels(const LinearLightTable& table, const Look& look)
{
    const auto& [views, normals, azimuths] = table.size;
    int seen = 0;
    for (int p = 0; p < azimuths; ++p)
        for (int n = 0; n < normals; ++n)
            for (int v = 0; v < views; ++v) {
                const Curve curve{v / (views - 1.0), 2 * n / (normals - 1.0) - 1,
                                  kPi * p / (azimuths - 1.0)};
                const double view = curve.cosine_sum(curve.phi_n + kPi / 2); // v.n
                if (view < 0.01)
                    continue;
                ++seen;
                const auto at = 3 * ((static_cast<size_t>(p) * static_cast<size_t>(normals) +
                                      static_cast<size_t>(n)) *
                                         static_cast<size_t>(views) +
                                     static_cast<size_t>(v));
                look({table.values[at], table.values[at + 1], table.values[at + 2]}, curve);
            }
    return seen;
}

// A grid of 4000 angles may miss the lowest one by half a step; where k is large that shows. With
// the viewer in the plane the lowest may be a point that no grid finds (PhiIsWhereThatIs...).
TEST(LinearLightTable, HoldsTheLowestPointOfTheWholeCircle)
{
    const auto table =
        linear_light_table(LinearLightCoordinates::angles, {9, 17, 13}, [](double) {});
    const int seen = look_at_texels(table, [](const std::array<float, 3>& got, const Curve& curve) {
        if (curve.cos_v == 0)
            return;
        const double want = curve.lowest(4000);
        const double k = static_cast<double>(got[1]);
        const double missed = k * k * std::pow(kPi / 4000, 2) * 1.5;
        EXPECT_LE(static_cast<double>(got[2]), want * (1 + 1e-6) + 1e-6)
            << curve.cos_v << ' ' << curve.cos_n << ' ' << curve.phi_n;
        EXPECT_GE(static_cast<double>(got[2]), (want - missed) * (1 - 1e-6) - 1e-6)
            << curve.cos_v << ' ' << curve.cos_n << ' ' << curve.phi_n << " k " << k;
    });
    EXPECT_GT(seen, 700);
}

TEST(LinearLightTable, PhiIsWhereThatIsAndBetween0AndPi)
{
    const auto table =
        linear_light_table(LinearLightCoordinates::angles, {9, 17, 13}, [](double) {});
    look_at_texels(table, [](const std::array<float, 3>& got, const Curve& curve) {
        const auto phi = static_cast<double>(got[0]);
        const auto tan2 = static_cast<double>(got[2]);
        EXPECT_GE(phi, 0);
        EXPECT_LE(phi, kPi + 1e-6);
        if (curve.cos_v > 0) { // in the plane phi = pi is the back of the viewer: 0 / 0
            EXPECT_NEAR(curve.tan2(phi), tan2, 2e-5 * (1 + tan2) * static_cast<double>(got[1]))
                << curve.cos_v << ' ' << curve.cos_n << ' ' << curve.phi_n;
        }
    });
}

Imath::V3f direction(float cosine, float azimuth)
{
    const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0F));
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

// At texels nothing is interpolated; in float the coordinates are 1e-6 of the table's width off.
TEST(LinearLightTable, ALookupAtATexelIsTheTexel)
{
    const auto table =
        linear_light_table(LinearLightCoordinates::angles, {9, 17, 13}, [](double) {});
    for (const float sign : {1.0F, -1.0F})
        for (int v = 1; v < 8; ++v)
            for (int n = 1; n < 16; ++n) {
                const auto viewer = direction(static_cast<float>(v) / 8, 0);
                const auto normal = direction(static_cast<float>(n) / 8 - 1, sign * 0.2617994F);
                if (viewer.dot(normal) < 0.1F)
                    continue;
                const auto want = filter::linear_peak(viewer, normal, 8);
                const auto got = table.peak(viewer, normal);
                EXPECT_NEAR(got.phi, want.phi, 1e-4F);
                EXPECT_NEAR(got.k, want.k, 1e-4F * want.k);
                EXPECT_NEAR(got.tan2, want.tan2, 1e-4F * (1 + want.tan2));
            }
}

LinearLightTable usual_table(LinearLightCoordinates coordinates)
{
    return linear_light_table(coordinates, usual_resolution(coordinates), [](double) {});
}

/// Largest error of tan^2 alpha where it matters, below 0.1, of views from above 17 degrees.
float worst_tan2(const LinearLightTable& table)
{
    float worst = 0;
    for (int v = 1; v < 32; ++v)
        for (int n = 0; n < 54; ++n)
            for (int p = 0; p < 75; ++p) {
                const auto viewer = direction(0.031F * static_cast<float>(v), 0);
                const auto normal = direction(0.037F * static_cast<float>(n) - 0.98F,
                                              0.083F * static_cast<float>(p) - 3.1F);
                const auto want = filter::linear_peak(viewer, normal, 8);
                if (viewer.dot(normal) > 0.3F && want.tan2 < 0.1F)
                    worst = std::max(worst, std::abs(table.peak(viewer, normal).tan2 - want.tan2));
            }
    return worst;
}

// Over angles the parabola of tan^2 about the cone is chopped into chords: (1 / 128)^2 or so, with
// peaks near the edges; over the cone tan^2 is at a minimum in what is interpolated.
TEST(LinearLightTable, OverTheConeInterpolationCostsHundredsOfTimesLess)
{
    const float angles = worst_tan2(usual_table(LinearLightCoordinates::angles));
    const float cone = worst_tan2(usual_table(LinearLightCoordinates::cone));
    RecordProperty("angles", std::to_string(angles));
    RecordProperty("cone", std::to_string(cone));
    EXPECT_LT(cone, 1e-4F);
    EXPECT_GT(angles, 100 * cone);
}

// What looking up changes in the Gaussian of W, against what that Gaussian is off from W by
// quadrature; each rms.
TEST(LinearLightTable, OverTheConeALookupAddsLessThanATenthOfTheGaussiansError)
{
    const auto table = usual_table(LinearLightCoordinates::cone);
    for (const double sigma2 : {0.002, 0.02, 0.3}) {
        test::RelativeRms added, gaussian;
        test::look_at_scenes(
            2000, sigma2, [&](const test::LinearScene& scene, const test::LinearAngles& angles) {
                const auto view = test::view_of<float>(scene);
                const auto solved = filter::linear_peak(view.viewer, view.normal, 8);
                const auto found = table.peak(view.viewer, view.normal);
                const double lobe = test::lobe_of(view, solved, solved.k, sigma2);
                added.add(test::lobe_of(view, found, found.k, sigma2), lobe);
                gaussian.add(lobe, test::lobe_integral(scene, angles));
            });
        EXPECT_LT(added.value(), gaussian.value() / 10) << sigma2;
    }
}

TEST(LinearLightTable, TellsItsProgressAndStopsWhenThatThrows)
{
    double last = 0;
    linear_light_table(LinearLightCoordinates::angles, {2, 2, 5}, [&last](double done) {
        EXPECT_GT(done, last);
        last = done;
    });
    EXPECT_EQ(last, 1);
    EXPECT_THROW(linear_light_table(LinearLightCoordinates::angles, {2, 2, 5},
                                    [](double) { throw std::runtime_error("stop"); }),
                 std::runtime_error);
}

TEST(LinearLightTable, ManifestHasTheSizesAndRangesOfTheTable)
{
    const TableManifest manifest =
        linear_light_manifest(LinearLightCoordinates::angles, {32, 128, 64});
    EXPECT_EQ(manifest.width(), 32);
    EXPECT_EQ(manifest.height(), 128 * 64);
    EXPECT_EQ(manifest.axes[0].coordinates.back(), 1);
    EXPECT_EQ(manifest.axes[1].coordinates.front(), -1);
    EXPECT_NEAR(manifest.axes[2].coordinates.back(), kPi, 1e-15);
}

} // namespace
} // namespace scree
