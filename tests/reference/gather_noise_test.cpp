// What samples know of a footprint, and what they know of their own noise.

#include <gtest/gtest.h>

#include <cmath>

#include "reference/gather.h"
#include "reference/gathered.h"
#include "reference/reliefs.h"
#include "reference/statistics.h"
#include "support/files.h"

namespace scree::reference {
namespace {

using test::direction;
using test::values;
using test::whole;

/// Root mean square.
class Rms {
public:
    void add(double x)
    {
        sum_ += x * x;
        ++count_;
    }
    [[nodiscard]] unsigned count() const { return count_; }
    [[nodiscard]] double value() const { return std::sqrt(sum_ / count_); }

private:
    double sum_ = 0;
    unsigned count_ = 0;
};

// The projection of a periodic surface is that of its mean plane, whatever its heights; a mirrored
// map is a quarter of its period, so azimuths are taken in fours that mirror each other. Tolerance:
// what the halves say the noise is, both as root mean squares over the azimuths.
void expect_projection_is_kept(const Relief& relief, int grid, double most_noise)
{
    const DisplacedSurface surface(relief);
    const Footprint all = whole(relief);
    for (const double theta : {30.0, 60.0, 75.0, 80.0, 85.0, 88.0}) {
        GatherPlan plan;
        plan.grid = grid;
        for (const double azimuth : {3.0, 27.0, 48.0, 90.0})
            for (const double image : {azimuth, 180 - azimuth, 180 + azimuth, -azimuth})
                plan.views.push_back(direction(theta, image));
        const Estimate e = gather(surface, all, plan, 0);
        const double cosine = plan.views[0].z;
        Rms noise, error;
        for (size_t v = 0; v < plan.views.size(); v += 4) {
            double mean = 0, apart = 0;
            for (size_t image = v; image < v + 4; ++image) {
                mean += e.all.seen[image].area / 4;
                apart += (e.halves[0].seen[image].area - e.halves[1].seen[image].area) / 2 / 4;
            }
            noise.add(apart / cosine);
            error.add(mean / cosine - 1);
        }
        EXPECT_LT(noise.value(), most_noise) << theta;
        // Four draws of one variance over four others: 16 is exceeded by chance in 1 of 100.
        EXPECT_LT(error.value(), 4 * noise.value() + 1e-12) << theta;
    }
}

TEST(GatherNoise, ProjectedAreaIsKeptByARoughMap)
{
    Relief relief = test::rough_relief(16, 16, 1);
    expect_projection_is_kept(relief, 128, 0.01);
    relief.beyond_s = relief.beyond_t = Beyond::mirrors;
    expect_projection_is_kept(relief, 128, 0.01);
}

TEST(GatherNoise, ProjectedAreaIsKeptByARamp)
{
    // A saw: its mean slope is made good by the cliff where it repeats.
    const Relief relief =
        test::relief_of(12, 5, [](int x, int y) { return 0.3 * x + (x * y % 3) * 0.2; });
    expect_projection_is_kept(relief, 128, 0.02);
}

TEST(GatherNoise, ProjectedAreaIsKeptByRock)
{
    const auto folder = test::data_folder();
    if (folder.empty())
        GTEST_SKIP() << "no real data";
    const test::Image image =
        test::read_levels(folder / "heights/material/rock_05/rock_05_bump_1k.png").at(0);
    const Relief relief = test::relief_of(image.width, image.height, [&](int x, int y) {
        return 20.0 * static_cast<double>(image.at(x, y, 0));
    });
    expect_projection_is_kept(relief, 128, 0.1);
}

// Seen from above everything is seen once, so what is seen are the statistics. Noise as above.
TEST(GatherNoise, FromAboveTheStatisticsAreSeen)
{
    Relief relief = test::rough_relief(33, 17, 4);
    test::punch_holes(relief, 5);
    test::Uniform uniform(6);
    for (Rgb& color : relief.colors)
        if (std::isfinite(color[0] + color[1] + color[2]))
            color = {uniform(), uniform(), uniform()};
    StatisticsInput input;
    input.relief = relief;
    const Statistics truth(input);

    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.views = {direction(0, 0)};
    int compared = 0;
    for (int level = 0; level < truth.levels(); ++level) {
        Rms noise, error;
        for (int y = 0; y < truth.height(level); ++y)
            for (int x = 0; x < truth.width(level); ++x) {
                const Texel texel = truth.at(level, x, y);
                const uint64_t index = noise.count();
                const Estimate e = gather(surface, footprint_of(33, 17, level, x, y), plan, index);
                ASSERT_EQ(e.samples > 0, texel.coverage > 0) << level << " " << x << " " << y;
                if (e.samples == 0)
                    continue;
                const Seen& all = e.all.seen[0];
                EXPECT_EQ(all.area, 1);
                const std::vector<double> got = values(e.all), a = values(e.halves[0]),
                                          b = values(e.halves[1]);
                const double want[] = {texel.mean_color[0], texel.mean_color[1],
                                       texel.mean_color[2], texel.mean_slope[0],
                                       texel.mean_slope[1], texel.cov_slope[0],
                                       texel.cov_slope[2],  texel.cov_slope[1]};
                for (size_t k = 0; k < 8; ++k) {
                    noise.add((a[k + 2] - b[k + 2]) / 2);
                    error.add(got[k + 2] - want[k]);
                    ++compared;
                }
            }
        EXPECT_LT(noise.value(), 0.02) << level;
        EXPECT_LT(error.value(), 1.5 * noise.value()) << level;
    }
    EXPECT_GT(compared, 8 * 300);
}

/// For each value of an estimate, what the halves say of its noise over how far results of other
/// seeds lie apart.
std::vector<double> noise_ratios(int size)
{
    Relief relief = test::rough_relief(size, size, 2);
    for (double& h : relief.heights)
        h *= 2;
    test::Uniform uniform(3);
    for (size_t i = 0; i < relief.heights.size(); ++i)
        relief.colors.push_back({uniform(), uniform(), uniform()});
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.views = {direction(40, 10), direction(75, 130)};
    plan.lights = {direction(50, 200), direction(80, 310)};
    plan.base_alpha = 0.5;

    constexpr int kSeeds = 40;
    std::vector<std::vector<double>> results;
    std::vector<Rms> said;
    for (int seed = 0; seed < kSeeds; ++seed) {
        plan.seed = static_cast<uint64_t>(seed);
        const Estimate e = gather(surface, whole(relief), plan, 5);
        results.push_back(values(e.all));
        const std::vector<double> a = values(e.halves[0]), b = values(e.halves[1]);
        said.resize(a.size());
        for (size_t k = 0; k < a.size(); ++k)
            said[k].add((a[k] - b[k]) / 2);
    }
    std::vector<double> ratios;
    for (size_t k = 0; k < said.size(); ++k) {
        double mean = 0;
        for (const auto& result : results)
            mean += result[k] / kSeeds;
        Rms spread;
        for (const auto& result : results)
            spread.add(result[k] - mean);
        ratios.push_back(said[k].value() / spread.value());
    }
    return ratios;
}

// Both are known to 1 / sqrt(2 x 40 seeds) = 11 %, their ratio to 16 %: three of that, and the mean
// of the ratios much closer.
TEST(GatherNoise, HalvesTellTheNoise)
{
    double mean = 0;
    const std::vector<double> rough = noise_ratios(50); // a texel or two a sample
    for (size_t k = 0; k < rough.size(); ++k) {
        EXPECT_NEAR(rough[k], 1, 0.5) << k;
        mean += rough[k] / static_cast<double>(rough.size());
    }
    EXPECT_NEAR(mean, 1, 0.15);
    // 2x2 samples a texel, whose quarters differ in ways that strata know and halves do not.
    const std::vector<double> fine = noise_ratios(16);
    for (size_t k = 0; k < fine.size(); ++k) {
        EXPECT_GT(fine[k], 0.7) << k;
        EXPECT_LT(fine[k], 4) << k;
    }
}

} // namespace
} // namespace scree::reference
