#include "chart/truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "chart/asset.h"
#include "reference/footprint.h"

namespace scree {
namespace {

struct Scene {
    reference::DisplacedSurface surface{sample_asset("bricks", 64).relief};
    std::vector<reference::Footprint> places;

    Scene()
    {
        for (int x = 0; x < 4; ++x)
            for (int y = 0; y < 4; ++y)
                places.push_back(reference::footprint_of(64, 64, 4, x, y));
    }
};

// The spread of repetitions. What a footprint's views see goes together, so 16 footprints times 12
// seeds are 192 numbers or more: the roots of their mean squares are right to a twentieth, their
// ratio to less than a tenth. Halves are stratified half as finely as the whole, so they say more.
TEST(ChartTruth, NoiseIsTheSpreadOfRepetitions)
{
    const Scene scene;
    std::vector<double> told(4), spread(4);
    for (uint64_t seed = 1; seed <= 12; ++seed) {
        TruthPlan plan{chart_views(), Material(), 8, seed};
        const ChartTruth one = gather_truth(scene.surface, scene.places, plan, {});
        plan.seed += 100;
        const auto again = supersample(scene.surface, scene.places, plan, {});
        const auto apart = rms_differences(one.yardstick, one.yardstick.truth, again);
        for (size_t band = 0; band < told.size(); ++band) {
            told[band] +=
                std::pow(one.noise[band].radiance, 2) + std::pow(one.noise[band].color, 2);
            spread[band] +=
                (std::pow(apart[band].radiance, 2) + std::pow(apart[band].color, 2)) / 2;
        }
    }
    for (size_t band = 0; band < told.size(); ++band) {
        const double ratio = std::sqrt(told[band] / spread[band]);
        RecordProperty(fmt::format("noise_over_spread_{}", band), fmt::format("{:.2f}", ratio));
        EXPECT_GT(ratio, 0.9) << band;
        EXPECT_LT(ratio, 1.6) << band;
    }
}

TEST(ChartTruth, EqualSeedsAreEqual)
{
    const Scene scene;
    const TruthPlan plan{chart_views(), Material(), 4, 5};
    const ChartTruth truth = gather_truth(scene.surface, scene.places, plan, {});
    const auto again = supersample(scene.surface, scene.places, plan, {});
    for (size_t f = 0; f < again.size(); ++f) {
        EXPECT_EQ(again[f].color, truth.yardstick.truth[f].color);
        EXPECT_EQ(again[f].radiance, truth.yardstick.truth[f].radiance);
    }
    EXPECT_GT(truth.rays, 0);
}

} // namespace
} // namespace scree
