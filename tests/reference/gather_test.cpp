#include "reference/gather.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "math/error.h"
#include "oracle/brute_force.h"
#include "reference/reliefs.h"
#include "support/files.h"

namespace scree::reference {
namespace {

using test::direction;
using test::kPi;

Footprint whole(const Relief& relief)
{
    return footprint_of(relief.width, relief.height, level_count(relief.width, relief.height) - 1,
                        0, 0);
}

Relief ramp(double slope_s, double slope_t)
{
    Relief relief = test::relief_of(8, 5, [&](int x, int y) { return slope_s * x + slope_t * y; });
    relief.beyond_s = relief.beyond_t = Beyond::extends;
    return relief;
}

TEST(Gather, PlanesAreSeenWhole)
{
    GatherPlan plan;
    plan.views = {direction(0, 0), direction(60, 30), direction(89.9, 200)};
    plan.lights = {direction(45, 100), direction(89.9, 10)};
    const Vec2 slopes[] = {{0, 0}, {0.001, -0.0005}, {-0.25, 0.125}};
    for (const Vec2& slope : slopes)
        for (const Beyond beyond : {Beyond::extends, Beyond::repeats}) {
            Relief relief = ramp(slope.x, slope.y);
            if (beyond == Beyond::repeats && slope.length() > 0)
                continue; // a ramp that repeats is a saw
            relief.beyond_s = relief.beyond_t = beyond;
            const DisplacedSurface surface(relief);
            const Gathered all = gather(surface, whole(relief), plan, 0).all;
            const double length = std::sqrt(1 + slope.length2());
            for (size_t v = 0; v < plan.views.size(); ++v) {
                const Vec3 w = plan.views[v];
                const double area = w.z - w.x * slope.x - w.y * slope.y;
                const Seen& seen = all.seen[v];
                EXPECT_NEAR(seen.area, std::max(0.0, area), 1e-13) << v;
                EXPECT_EQ(seen.g1(), area > 0 ? 1 : 0) << v;
                if (area <= 0)
                    continue;
                EXPECT_NEAR((seen.slope - slope).length(), 0, 1e-13) << v;
                EXPECT_NEAR(seen.covariance[0] + seen.covariance[2], 0, 1e-13) << v;
                for (size_t l = 0; l < plan.lights.size(); ++l) {
                    const Vec3 light = plan.lights[l];
                    const double cosine =
                        (light.z - light.x * slope.x - light.y * slope.y) / length;
                    const Lit& lit = all.lit[v * plan.lights.size() + l];
                    EXPECT_EQ(lit.share, cosine > 0 ? 1 : 0) << v << " " << l;
                    EXPECT_NEAR(lit.diffuse[0], std::max(0.0, cosine) / kPi, 1e-13) << v;
                }
            }
        }
}

// A flat plane seen from above: the light mirrored by the facets of one slope is weighted by their
// share, so over all lights, 4 (wo . h) of solid angle for one of h, it adds up to
//   integral of D(h) h.z dh = 1,
// short of the facets that send it below the horizon, exp(-1 / alpha^2) = 1e-11 of them.
TEST(Gather, SpecularLightAddsUpToWhatTheFacetsCover)
{
    const Relief relief = test::relief_of(1, 1, [](int, int) { return 2.0; });
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = 1;
    plan.base_alpha = 0.2;
    plan.views = {direction(0, 0)};
    double sum = 0;
    constexpr int kSteps = 1000; // midpoints; a smooth function that ends at 0 on both sides
    for (int k = 0; k < kSteps; ++k) {
        const double theta = (k + 0.5) / kSteps * kPi / 4;
        plan.lights = {direction(2 * theta * 180 / kPi, 77)};
        const double solid_angle = 2 * kPi * std::sin(theta) * kPi / 4 / kSteps;
        // 4 (wo . h) h.z with wo = (0, 0, 1)
        sum += gather(surface, whole(relief), plan, 0).all.lit[0].specular * 4 * std::cos(theta) *
               std::cos(theta) * solid_angle / std::cos(theta);
    }
    EXPECT_NEAR(sum, 1, 1e-5);
}

/// Root mean square.
class Rms {
public:
    void add(double x)
    {
        sum_ += x * x;
        ++count_;
    }
    [[nodiscard]] double value() const { return std::sqrt(sum_ / count_); }

private:
    double sum_ = 0;
    int count_ = 0;
};

/// Every value of an estimate that is a mean over samples.
std::vector<double> values(const Gathered& g)
{
    std::vector<double> all;
    for (const Seen& s : g.seen)
        all.insert(all.end(), {s.facing, s.area, s.color[0], s.color[1], s.color[2], s.slope.x,
                               s.slope.y, s.covariance[0], s.covariance[1], s.covariance[2]});
    for (const Lit& l : g.lit)
        all.insert(all.end(), {l.share, l.color[0], l.color[1], l.color[2], l.diffuse[0],
                               l.diffuse[1], l.diffuse[2], l.specular});
    return all;
}

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

TEST(Gather, ProjectedAreaIsKeptByARoughMap)
{
    Relief relief = test::rough_relief(16, 16, 1);
    expect_projection_is_kept(relief, 128, 0.01);
    relief.beyond_s = relief.beyond_t = Beyond::mirrors;
    expect_projection_is_kept(relief, 128, 0.01);
}

TEST(Gather, ProjectedAreaIsKeptByARamp)
{
    // A saw: its mean slope is made good by the cliff where it repeats.
    const Relief relief =
        test::relief_of(12, 5, [](int x, int y) { return 0.3 * x + (x * y % 3) * 0.2; });
    expect_projection_is_kept(relief, 128, 0.02);
}

TEST(Gather, ProjectedAreaIsKeptByRock)
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
TEST(Gather, FromAboveTheStatisticsAreSeen)
{
    Relief relief = test::rough_relief(33, 17, 4);
    test::punch_holes(relief, 5);
    test::Uniform uniform(6);
    for (Rgb& color : relief.colors)
        if (std::isfinite(color[0] + color[1] + color[2]))
            color = {uniform(), uniform(), uniform()};
    oracle::Input input;
    input.width = relief.width;
    input.height = relief.height;
    input.heights = relief.heights;
    input.colors = relief.colors;
    input.weights.assign(relief.weights.begin(), relief.weights.end());
    const oracle::Result truth = oracle::brute_force(input);

    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.views = {direction(0, 0)};
    int compared = 0;
    for (size_t level = 0; level < truth.levels.size(); ++level) {
        Rms noise, error;
        const oracle::Level& texels = truth.levels[level];
        for (int y = 0; y < texels.height; ++y)
            for (int x = 0; x < texels.width; ++x) {
                const oracle::Texel& texel = texels.at(x, y);
                const auto index = static_cast<uint64_t>(y * texels.width + x);
                const Estimate e = gather(
                    surface, footprint_of(33, 17, static_cast<int>(level), x, y), plan, index);
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
TEST(Gather, HalvesTellTheNoise)
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

TEST(Gather, WhereNothingIsSeenAllIsZero)
{
    GatherPlan plan;
    plan.views = {direction(60, 0), direction(60, 180)};
    plan.lights = {direction(60, 0), direction(60, 180)};
    const Relief steep = ramp(5, 0); // turned away from +s
    const DisplacedSurface surface(steep);
    const Gathered away = gather(surface, whole(steep), plan, 0).all;
    for (const double value : values({{away.seen[0]}, {away.lit[0], away.lit[1]}}))
        EXPECT_EQ(value, 0);
    EXPECT_EQ(away.seen[0].g1(), 0);
    EXPECT_GT(away.seen[1].area, 0);
    EXPECT_EQ(away.lit[2].share, 0); // seen, but not lit
    EXPECT_EQ(away.lit[2].color, Rgb{});
    EXPECT_EQ(away.lit[3].share, 1);

    Relief empty = ramp(0, 0);
    empty.weights.assign(empty.heights.size(), 0.0F);
    const Estimate nothing = gather(DisplacedSurface(empty), whole(empty), plan, 0);
    EXPECT_EQ(nothing.samples, 0);
    EXPECT_EQ(nothing.rays, 0);
    for (const double value : values(nothing.all))
        EXPECT_EQ(value, 0);

    plan.grid = 1; // one sample: a half is of none
    const Relief flat = ramp(0, 0);
    const Estimate one = gather(DisplacedSurface(flat), whole(flat), plan, 0);
    EXPECT_EQ(one.halves[0].seen[0].g1() + one.halves[1].seen[0].g1(), 1);
    for (const Gathered& half : one.halves)
        for (const double value : values(half))
            EXPECT_TRUE(std::isfinite(value));
    EXPECT_EQ(one.all.seen[0].g1(), 1);
}

bool same_bytes(const Gathered& a, const Gathered& b)
{
    const std::vector<double> x = values(a), y = values(b);
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

TEST(Gather, ThreadsChangeNoByte)
{
    const Relief relief = test::rough_relief(33, 17, 12);
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = 8;
    plan.views = {direction(30, 0), direction(80, 50)};
    plan.lights = {direction(60, 100)};
    std::vector<Footprint> footprints;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            footprints.push_back(footprint_of(33, 17, 1, x, y));

    std::vector<std::vector<Estimate>> runs;
    for (const size_t threads : {1u, 2u, 5u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        runs.push_back(gather_all(surface, footprints, plan));
    }
    for (size_t i = 0; i < footprints.size(); ++i) {
        const Estimate alone = gather(surface, footprints[i], plan, i);
        for (const auto& run : runs) {
            EXPECT_TRUE(same_bytes(run[i].all, alone.all)) << i;
            EXPECT_TRUE(same_bytes(run[i].halves[0], alone.halves[0])) << i;
            EXPECT_TRUE(same_bytes(run[i].halves[1], alone.halves[1])) << i;
            EXPECT_EQ(run[i].rays, alone.rays) << i;
        }
    }
    // Equal footprints, but jitter of their own; and so has another seed.
    const Estimate other = gather(surface, footprints[0], plan, 1);
    EXPECT_FALSE(same_bytes(other.all, runs[0][0].all));
    plan.seed = 2;
    EXPECT_FALSE(same_bytes(gather(surface, footprints[0], plan, 0).all, runs[0][0].all));
}

TEST(Gather, ProgressIsToldAndMayStop)
{
    const Relief relief = test::rough_relief(16, 16, 13);
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.views = {direction(30, 0)};
    const std::vector<Footprint> footprints(50, whole(relief));
    double last = 0;
    gather_all(surface, footprints, plan, [&](double done) {
        EXPECT_GT(done, last);
        last = done;
    });
    EXPECT_EQ(last, 1);
    EXPECT_THROW(gather_all(surface, footprints, plan, [](double) { throw Cancelled(); }),
                 Cancelled);
}

// Rays: a view that a face is turned away from costs none, nor does a light behind it.
TEST(Gather, CountsTheRaysItCasts)
{
    const Relief relief = ramp(1, 0);
    const DisplacedSurface surface(relief);
    GatherPlan plan;
    plan.grid = 4;
    plan.views = {direction(60, 180), direction(70, 0), direction(0, 0)};
    plan.lights = {direction(60, 180), direction(70, 0)};
    EXPECT_EQ(gather(surface, whole(relief), plan, 0).rays, 16 * 3);
}

} // namespace
} // namespace scree::reference
