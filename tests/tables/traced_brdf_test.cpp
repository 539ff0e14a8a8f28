#include "tables/traced_brdf.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/gathered.h"
#include "reference/reliefs.h"
#include "reference/rough_plane.h"

namespace scree::test {
namespace {

using filter::Directions;

std::vector<Directions<double>> some_pairs()
{
    return {{direction(20, 10), direction(35, 160)},
            {direction(50, 0), direction(50, 180)},
            {direction(70, 40), direction(30, 300)},
            {direction(80, 90), direction(75, 240)}};
}

/// Waves of slopes to 0.63 and 0.31, whose color goes with the height.
reference::Relief waves()
{
    reference::Relief relief = relief_of(32, 32, [](int x, int y) {
        return 1.6 * std::sin(2 * kPi * x / 16) + 1.6 * std::sin(2 * kPi * y / 32);
    });
    for (const double height : relief.heights)
        relief.colors.push_back({0.5 + height / 8, 0.5, 0.5 - height / 8});
    return relief;
}

// Where a plane has one slope every sample says the same: 1e-5 is float and the quadrature.
TEST(TracedBrdf, OfAPlaneIsItsFacets)
{
    reference::Relief relief = relief_of(4, 4, [](int, int) { return 3.0; });
    relief.colors.assign(16, {0.1, 0.2, 0.8});
    const reference::DisplacedSurface surface(std::move(relief));
    const double alpha = 0.4, f0 = 0.1;
    const TracedBrdf brdf(surface, {alpha, f0, 4, 1});
    for (const auto& w : some_pairs()) {
        const double cos_d = (w.wo + w.wi).normalized().dot(w.wi);
        const double fresnel = f0 + (1 - f0) * std::pow(1 - cos_d, 5);
        const double lobe = fresnel * mirrored_by_plane(w.wo, w.wi, {0, 0}, alpha) / w.wi.z;
        const Rgbf got = brdf(w);
        const double colors[] = {0.1, 0.2, 0.8};
        for (size_t c = 0; c < 3; ++c) {
            const double want = colors[c] / kPi + lobe;
            EXPECT_NEAR(static_cast<double>(got[c]), want, 1e-5 * want);
        }
    }
}

// Against the reference's gathering of single views, 64 turns and their mirror images by hand.
TEST(TracedBrdf, OfWavesIsTheMeanOverTurnsOfWhatTheReferenceGathers)
{
    const reference::DisplacedSurface surface(waves());
    const double alpha = 0.4, f0 = 1;
    const TracedBrdf brdf(surface, {alpha, f0, 128, 1});
    for (const auto& w : some_pairs()) {
        constexpr int kTurns = 64;
        std::array<double, 3> want{};
        for (int turn = 0; turn < kTurns; ++turn)
            for (const double side : {-1.0, 1.0}) {
                const double angle = 2 * kPi * turn / kTurns;
                const auto turned = [&](const Vec3& v) {
                    return Vec3(std::cos(angle) * v.x - std::sin(angle) * side * v.y,
                                std::sin(angle) * v.x + std::cos(angle) * side * v.y, v.z);
                };
                const reference::GatherPlan plan{{turned(w.wo)}, {turned(w.wi)}, alpha, 24, 7};
                const auto found =
                    gather(surface, whole(surface.relief()), plan, static_cast<uint64_t>(turn));
                const reference::Rgb radiance = radiance_of(found.all.lit[0], f0);
                for (size_t c = 0; c < 3; ++c)
                    want[c] += radiance[c] / (2 * kTurns * w.wi.z);
            }
        const Rgbf got = brdf(w);
        // 16384 samples, of which a twentieth count at the least, leave 1 % for one deviation.
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(static_cast<double>(got[c]) / want[c], 1, 0.03) << w.wo.z << ' ' << c;
    }
}

TEST(TracedBrdf, IsReciprocalAndAllButIsotropic)
{
    const reference::DisplacedSurface surface(waves());
    const TracedBrdf brdf(surface, {0.4, 0.04, 64, 3});
    for (const auto& w : some_pairs()) {
        const float here = brdf(w)[0];
        EXPECT_NEAR(brdf({w.wi, w.wo})[0], here, 1e-6F * here);
        const auto turned = [](const Vec3& v) { return Vec3(v.y, v.x, v.z); };
        EXPECT_NEAR(brdf({turned(w.wo), turned(w.wi)})[0], here, 0.06F * here);
    }
}

TEST(TracedBrdf, DirectionsAtTheHorizonAreRaised)
{
    const reference::DisplacedSurface surface(waves());
    const TracedBrdf brdf(surface, {0.4, 0.04, 16, 3});
    const double z = 0.02;
    const Vec3 raised(std::sqrt(1 - z * z), 0, z);
    const Rgbf want = brdf({raised, direction(40, 180)});
    for (const Vec3& level : {Vec3(1, 0, 0), direction(89.5, 0)}) {
        const Rgbf got = brdf({level, direction(40, 180)});
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], want[c], 1e-5F * want[c]);
    }
    // Without data there is nothing.
    reference::Relief empty = waves();
    empty.weights.assign(empty.heights.size(), 0.0F);
    const reference::DisplacedSurface none(std::move(empty));
    EXPECT_EQ(TracedBrdf(none, {})({raised, raised})[0], 0);
}

} // namespace
} // namespace scree::test
