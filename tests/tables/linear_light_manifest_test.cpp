// What the manifest of a linear-light table says of a texel, against what the texel holds.

#include <gtest/gtest.h>

#include <cmath>

#include "tables/linear_light_table.h"

namespace scree::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr LinearLightResolution kSize = {6, 9, 7};

void no_progress(double /*share*/) {}

double value_at(const LinearLightTable& table, size_t x, size_t y, size_t z, size_t channel)
{
    const size_t texel =
        (z * static_cast<size_t>(kSize.normals) + y) * static_cast<size_t>(kSize.views) + x;
    return static_cast<double>(table.values[texel * table.channels() + channel]);
}

// tan^2 alpha at the Phi that stands there, from the vectors that the axes' coordinates are of.
TEST(LinearLightManifest, AnglesAreThoseOfTheTexels)
{
    const auto table = linear_light_table(LinearLightCoordinates::angles, kSize, no_progress);
    const auto manifest = linear_light_manifest(LinearLightCoordinates::angles, kSize);
    ASSERT_EQ(manifest.axes.size(), 3U);
    EXPECT_EQ(manifest.axes[0].name + ", " + manifest.axes[1].name + ", " + manifest.axes[2].name,
              "cos theta_v, cos theta_n, phi_n");
    EXPECT_EQ(manifest.axes[0].unit + manifest.axes[1].unit + manifest.axes[2].unit, "11radians");
    ASSERT_EQ(manifest.channels.size(), 3U);
    EXPECT_EQ(manifest.channels[0].quantity + ", " + manifest.channels[0].unit, "Phi, radians");
    EXPECT_EQ(manifest.channels[1].quantity + ", " + manifest.channels[1].unit, "k, 1 / radians");
    EXPECT_EQ(manifest.channels[2].quantity + ", " + manifest.channels[2].unit, "tan2, 1");
    const auto& q = manifest.axes[0].coordinates;
    const auto& cos_n = manifest.axes[1].coordinates;
    const auto& phi_n = manifest.axes[2].coordinates;
    EXPECT_EQ(q.front(), 0);
    EXPECT_EQ(q.back(), 1);
    EXPECT_EQ(cos_n.front(), -1);
    EXPECT_EQ(cos_n.back(), 1);
    EXPECT_EQ(phi_n.front(), 0);
    EXPECT_NEAR(phi_n.back(), kPi, 1e-15);
    int seen = 0;
    for (size_t x = 1; x < q.size(); ++x) // cos theta_v = 0: half vectors of l = -v are 0 / 0
        for (size_t y = 0; y < cos_n.size(); ++y)
            for (size_t z = 0; z < phi_n.size(); ++z) {
                const double phi = value_at(table, x, y, z, 0), tan2 = value_at(table, x, y, z, 2);
                if (tan2 > 100)
                    continue; // seen from behind, or nearly
                ++seen;
                const double sin_n = std::sqrt(1 - cos_n[y] * cos_n[y]);
                const Imath::V3d n(sin_n * std::cos(phi_n[z]), sin_n * std::sin(phi_n[z]),
                                   cos_n[y]);
                const Imath::V3d v(std::sqrt(1 - q[x] * q[x]), 0, q[x]);
                const Imath::V3d h = (v + Imath::V3d(std::cos(phi), std::sin(phi), 0)).normalized();
                const double want = 1 / std::pow(h.dot(n), 2) - 1;
                EXPECT_NEAR(tan2, want, 1e-5 * (1 + want) * (1 + want)) // Phi in float
                    << q[x] << ' ' << cos_n[y] << ' ' << phi_n[z];
            }
    EXPECT_GT(seen, 200);
}

// The equation that the stretch solves (docs/linear-lights.md), in the scale where the root is 1.
TEST(LinearLightManifest, ConeCoordinatesAreThoseOfTheTexels)
{
    const auto table = linear_light_table(LinearLightCoordinates::cone, kSize, no_progress);
    const auto manifest = linear_light_manifest(LinearLightCoordinates::cone, kSize);
    ASSERT_EQ(manifest.axes.size(), 3U);
    EXPECT_EQ(manifest.axes[0].name + ", " + manifest.axes[1].name + ", " + manifest.axes[2].name,
              "cos theta_v, (r + 1) / (r + 3), side");
    ASSERT_EQ(manifest.channels.size(), 1U);
    EXPECT_EQ(manifest.channels[0].quantity, "stretch");
    const auto& q = manifest.axes[0].coordinates;
    const auto& ratio = manifest.axes[1].coordinates;
    const auto& side = manifest.axes[2].coordinates;
    for (const auto& axis : manifest.axes) {
        EXPECT_EQ(axis.unit, "1");
        EXPECT_EQ(axis.coordinates.front(), 0);
        EXPECT_EQ(axis.coordinates.back(), 1);
    }
    // The ends apart: no ratio is infinite, no half vector is at 0 / 0.
    for (size_t x = 1; x + 1 < q.size(); ++x)
        for (size_t y = 1; y + 1 < ratio.size(); ++y)
            for (size_t z = 1; z < side.size(); ++z) {
                const double r = (3 * ratio[y] - 1) / (1 - ratio[y]);
                const double c = value_at(table, x, y, z, 0);
                const double t = (2 / c - (1 + q[x])) / (1 - q[x]);
                const double bb = side[z] * side[z];
                if (t > -0.97) { // else all half vectors face away
                    EXPECT_NEAR(t * std::sqrt(bb + (1 - bb) * c * c), r, 2e-6 * (2 + std::abs(r)))
                        << q[x] << ' ' << r << ' ' << side[z];
                }
            }
    for (size_t y = 1; y + 1 < ratio.size(); ++y)
        EXPECT_NEAR(value_at(table, q.size() - 1, y, 3, 0), 1, 1e-6); // q = 1: a circular cone
}

} // namespace
} // namespace scree::test
