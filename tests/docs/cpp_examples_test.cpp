// The C++ examples of docs/: what the pages print is what tests/consumer builds, and it is right.

#include <gtest/gtest.h>

#include <random>

#include "kernel/k0.h"
#include "kernel/linear_light.h"
#include "kernel/linear_light_oracle.h"
#include "shaders/doc_example.h"
#include "tables/brdf_table.h"

using Imath::V3f;
using namespace scree;

V3f mirrored(const V3f& wo, const filter::Slopes<float>& slopes, const float (&u)[5], float& pdf);
float tube(const filter::LinearLight<float>& light, const V3f& to_viewer,
           const filter::Slopes<float>& slopes, float base_alpha);
V3f brdf(const V3f* texels, const std::array<int, 3>& size, const V3f& wo, const V3f& wi);

namespace scree::test {
namespace {

TEST(CppExamples, AreWhatTheConsumerBuilds)
{
    for (const auto& [page, file] : {std::pair{"filtering.md", "shade.cpp"},
                                     {"k0.md", "mirrored.cpp"},
                                     {"linear-lights.md", "tube.cpp"},
                                     {"brdf-parametrizations.md", "brdf_lookup.cpp"}}) {
        const std::string example = doc_example("cpp", page);
        ASSERT_FALSE(example.empty()) << page;
        const auto built = read_bytes(std::string(SCREE_SOURCE "/tests/consumer/") + file);
        EXPECT_NE(built.find(example), std::string::npos) << page;
    }
}

// Of slopes: dslope = dm / mz^3, dwi = 4 (wo . m) dm.
TEST(CppExamples, OfK0MirrorsWithTheDensityOfFacingSlopes)
{
    const filter::Slopes<float> slopes{{0.1F, -0.2F}, {0.09F, 0.02F, 0.05F}, 1};
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const V3f& wo : {V3f(0, 0, 1), V3f(0.6F, 0, 0.8F), V3f(0.3F, -0.9F, 0.3F).normalized()})
        for (int i = 0; i < 100; ++i) {
            float u[5];
            for (float& each : u)
                each = uniform(random);
            float pdf = 0;
            const V3f wi = mirrored(wo, slopes, u, pdf);
            EXPECT_NEAR(wi.length(), 1, 1e-5F);
            const V3f m = (wi + wo).normalized();
            const float facing = k0::visible_slope_pdf({-m.x / m.z, -m.y / m.z}, wo, slopes);
            const float want = facing / (m.z * m.z * m.z * 4 * wo.dot(m));
            EXPECT_NEAR(pdf, want, 2e-3F * want); // of wi in float, where the density is steep
        }
}

TEST(CppExamples, OfALinearLightReflectsWhatTheIntegralDoes)
{
    LinearScene scene;
    scene.from = {-1, 0.3, 1};
    scene.to = {1.5, 0.3, 1};
    scene.light_normal = {0, 0, -1};
    scene.normal = filter::normal(Imath::V2d(0.05, -0.1));
    scene.viewer = Imath::V3d(0.2, -0.4, 1).normalized();
    for (const auto& [variance, alpha] : {std::pair{0.0008F, 0.05F}, {0.04F, 0.2F}}) {
        const filter::Slopes<float> slopes{{0.05F, -0.1F}, {variance, 0, variance}, 0};
        scene.sigma2 = static_cast<double>(2 * variance + alpha * alpha);
        const double want = reflected_exactly(scene);
        const double got =
            static_cast<double>(tube({V3f(scene.from), V3f(scene.to), V3f(scene.light_normal)},
                                     V3f(scene.viewer), slopes, alpha));
        EXPECT_NEAR(got, want, 0.01 * want) << variance;
    }
}

TEST(CppExamples, OfBrdfsLooksUpWhatTheTableHolds)
{
    const BrdfGrid grid; // as the command makes it
    const auto values = brdf_table(
        grid,
        [](const filter::Directions<double>& w) {
            return Rgbf{static_cast<float>(w.wo.z * w.wi.z), static_cast<float>(w.wo.z + w.wi.z),
                        1};
        },
        [](double) {});
    std::vector<V3f> texels;
    for (size_t i = 0; i < values.size(); i += 3)
        texels.emplace_back(values[i], values[i + 1], values[i + 2]);
    for (const Imath::V3d& wi :
         {Imath::V3d(0, 0, 1), Imath::V3d(0.5, 0.2, 0.7), Imath::V3d(-0.8, 0.5, 0.1)}) {
        const filter::Directions<double> w{Imath::V3d(0.3, -0.4, 0.6).normalized(),
                                           wi.normalized()};
        const auto want = look_up(grid, values, 3, w);
        const V3f got = brdf(texels.data(), grid.size, V3f(w.wo), V3f(w.wi));
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], want[static_cast<size_t>(c)], 1e-4) << wi; // places in float
        EXPECT_NEAR(got[0], w.wo.z * w.wi.z, 0.01) << wi;                  // interpolation
    }
}

} // namespace
} // namespace scree::test
