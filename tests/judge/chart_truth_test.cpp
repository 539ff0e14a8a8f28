#include "judge/chart_truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "judge/asset.h"
#include "reference/footprint.h"

namespace scree {
namespace {

struct Scene {
    reference::DisplacedSurface surface{sample_asset("bricks", 32).relief};
    std::vector<reference::Footprint> places;

    Scene()
    {
        for (int x = 0; x < 4; ++x)
            for (int y = 0; y < 4; ++y)
                places.push_back(reference::footprint_of(32, 32, 3, x, y));
    }
};

// The spread of repetitions, over 16 footprints and 16 to 48 numbers each: their rms differs from
// the mean by a tenth or so. Halves are stratified half as finely, so they say more, but no more
// than twice.
TEST(ChartTruth, NoiseIsTheSpreadOfRepetitions)
{
    const Scene scene;
    TruthPlan plan{chart_views(), Material(), 16, 1};
    const ChartTruth one = gather_truth(scene.surface, scene.places, plan, {});
    plan.seed = 2;
    const auto again = supersample(scene.surface, scene.places, plan, {});
    const auto apart = rms_differences(one.yardstick, one.yardstick.truth, again);
    for (size_t band = 0; band < apart.size(); ++band) {
        const double color = one.noise[band].color / (apart[band].color / std::sqrt(2));
        const double radiance = one.noise[band].radiance / (apart[band].radiance / std::sqrt(2));
        EXPECT_GT(color, 0.8) << band;
        EXPECT_LT(color, 2) << band;
        EXPECT_GT(radiance, 0.8) << band;
        EXPECT_LT(radiance, 2) << band;
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
