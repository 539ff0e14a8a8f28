// What primary rays show is what footprints gather.

#include "reference/render.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <stdexcept>

#include "reference/gather.h"
#include "reference/reliefs.h"
#include "reference/rough_plane.h"

namespace scree::test {
namespace {

using namespace reference;

/// A distant picture of `repeats` whole repeats of a relief, seen from +t.
struct Shot {
    Camera camera;
    PictureArea area;
};

Shot whole_repeats(const Relief& relief, int columns, int rows, double angle_deg, double highest)
{
    Aim aim;
    aim.target = {relief.width / 2.0, relief.height / 2.0};
    aim.angle_rad = radians(angle_deg);
    aim.azimuth_rad = radians(90);
    aim.width = relief.width;
    aim.columns = columns;
    aim.rows = rows;
    return {Camera::distant(aim, highest), {0, columns, rows}};
}

/// Of all pixels; the covered share is left out.
Radiance mean_of(const Rendering& rendering)
{
    Radiance mean;
    const auto count = static_cast<double>(rendering.pixels.size());
    for (const RenderedPixel& pixel : rendering.pixels) {
        for (size_t c = 0; c < 3; ++c)
            mean.diffuse[c] += pixel.all.diffuse[c] / count;
        mean.specular += pixel.all.specular / count;
    }
    return mean;
}

TEST(Render, AFlatPlaneIsAsBrightAsItsFormulas)
{
    Relief relief = relief_of(4, 4, [](int, int) { return 2.0; });
    relief.colors.assign(16, {0.2, 0.5, 0.8});
    const DisplacedSurface surface(relief);
    const Shot shot = whole_repeats(relief, 6, 5, 40, 3);
    RenderPlan plan;
    plan.light = direction(30, 10);
    plan.base_alpha = 0.4;
    plan.grid = 2;
    const Rendering rendering = render(surface, shot.camera, shot.area, plan);
    ASSERT_EQ(rendering.pixels.size(), 30U);
    EXPECT_EQ(rendering.rays, 2 * 4 * 30);
    const double lobe = mirrored_by_plane(direction(40, 90), direction(30, 10), {0, 0}, 0.4);
    for (const RenderedPixel& pixel : rendering.pixels) {
        EXPECT_NEAR(pixel.all.covered, 1, 1e-12);
        EXPECT_NEAR(pixel.all.diffuse[0], 0.2 * std::cos(radians(30)) / kPi, 1e-12);
        EXPECT_NEAR(pixel.all.diffuse[2], 0.8 * std::cos(radians(30)) / kPi, 1e-12);
        EXPECT_NEAR(pixel.all.specular, lobe, 1e-12);
    }
}

// The twin: gather() takes samples of the plane and asks what of them is seen; here rays bring what
// is seen. Nothing in common but the surface.
TEST(Render, PicturesOfWholeRepeatsShowWhatTheWholeMapGathers)
{
    Relief relief = rough_relief(16, 16, 5);
    for (double& height : relief.heights)
        height *= 3; // so that much is hidden, and much in shadow
    Uniform uniform(6);
    for (int i = 0; i < 256; ++i)
        relief.colors.push_back({uniform(), relief.heights[static_cast<size_t>(i)], uniform()});
    const DisplacedSurface surface(relief);
    for (const double angle : {0.0, 60.0, 75.5224878140701}) { // cosines 1, 1/2, 1/4
        const int rows = static_cast<int>(std::lround(32 * std::cos(radians(angle))));
        const Shot shot = whole_repeats(relief, 32, rows, angle, surface.highest());
        RenderPlan plan;
        plan.light = direction(50, 160);
        plan.base_alpha = 0.5;
        plan.grid = 12;
        const Radiance mean = mean_of(render(surface, shot.camera, shot.area, plan));

        GatherPlan gathering;
        gathering.views = {direction(angle, 90)};
        gathering.lights = {plan.light};
        gathering.base_alpha = plan.base_alpha;
        gathering.grid = 400;
        const Lit lit = gather(surface, footprint_of(16, 16, 4, 0, 0), gathering, 0).all.lit[0];
        // Over seeds either varied by up to 2e-3 of the diffuse part and 4e-3 of the specular.
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(mean.diffuse[c] / lit.diffuse[c], 1, 4e-3)
                << "angle " << angle << " color " << c;
        EXPECT_NEAR(mean.specular / lit.specular, 1, 0.01) << "angle " << angle;
    }
}

TEST(Render, HalvesTellTheNoise)
{
    const DisplacedSurface surface(rough_relief(16, 16, 8));
    const Shot shot = whole_repeats(surface.relief(), 24, 12, 60, surface.highest());
    RenderPlan plan;
    plan.light = direction(40, 200);
    plan.grid = 4;
    const Rendering one = render(surface, shot.camera, shot.area, plan);
    plan.seed = 2;
    const Rendering other = render(surface, shot.camera, shot.area, plan);
    double told = 0, found = 0;
    for (size_t i = 0; i < one.pixels.size(); ++i) {
        const auto& [a, b] = one.pixels[i].halves;
        told += std::pow((a.diffuse[1] - b.diffuse[1]) / 2, 2);
        found += std::pow(one.pixels[i].all.diffuse[1] - other.pixels[i].all.diffuse[1], 2) / 2;
    }
    // Variances of 288 pixels: 3 deviations of a ratio are 0.35; halves of a stratified grid are
    // noisier than a half of it.
    EXPECT_GT(told, 0.65 * found);
    EXPECT_LT(told, 2.5 * found);
}

// The surface lies between texel centres: half a texel beside one without data is gone too.
TEST(Render, TexelsWithoutDataAreNotCovered)
{
    Relief relief = relief_of(8, 2, [](int, int) { return 0.0; });
    relief.weights = {1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0};
    const DisplacedSurface surface(relief);
    const Shot shot = whole_repeats(relief, 8, 2, 0, 1);
    const Rendering rendering = render(surface, shot.camera, shot.area, RenderPlan());
    const std::array<double, 8> expected = {0.5, 1, 1, 0.5, 0, 0, 0, 0};
    for (size_t i = 0; i < 16; ++i)
        EXPECT_EQ(rendering.pixels[i].all.covered, expected[i % 8]) << "pixel " << i;
}

TEST(Render, EqualSeedsGiveEqualPicturesWhateverTheThreads)
{
    const DisplacedSurface surface(rough_relief(16, 16, 8));
    const Shot shot = whole_repeats(surface.relief(), 12, 6, 60, surface.highest());
    RenderPlan plan;
    plan.light = direction(40, 200);
    const Rendering many = render(surface, shot.camera, shot.area, plan);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const Rendering one = render(surface, shot.camera, shot.area, plan);
    EXPECT_EQ(one.rays, many.rays);
    bool any_differs = false;
    plan.seed = 9;
    const Rendering other = render(surface, shot.camera, shot.area, plan);
    for (size_t i = 0; i < many.pixels.size(); ++i) {
        EXPECT_EQ(one.pixels[i].all.diffuse, many.pixels[i].all.diffuse);
        any_differs = any_differs || other.pixels[i].all.diffuse != one.pixels[i].all.diffuse;
    }
    EXPECT_TRUE(any_differs);
}

TEST(Render, AnAreaIsACutOfThePicture)
{
    const DisplacedSurface surface(rough_relief(16, 16, 8));
    const Shot shot = whole_repeats(surface.relief(), 12, 6, 60, surface.highest());
    RenderPlan plan;
    plan.light = direction(40, 200);
    const Rendering whole = render(surface, shot.camera, shot.area, plan);
    const Rendering cut = render(surface, shot.camera, {5, 4, 6}, plan);
    for (size_t y = 0; y < 6; ++y)
        for (size_t x = 0; x < 4; ++x)
            EXPECT_EQ(cut.pixels[4 * y + x].all.diffuse, whole.pixels[12 * y + x + 5].all.diffuse);
}

TEST(Render, ProgressRisesToOneAndMayStop)
{
    const DisplacedSurface surface(rough_relief(4, 4, 8));
    const Shot shot = whole_repeats(surface.relief(), 4, 8, 0, surface.highest());
    double last = 0;
    render(surface, shot.camera, shot.area, RenderPlan(), [&last](double done) {
        EXPECT_GT(done, last);
        last = done;
    });
    EXPECT_EQ(last, 1);
    EXPECT_THROW(render(surface, shot.camera, shot.area, RenderPlan(),
                        [](double) { throw std::runtime_error("stop"); }),
                 std::runtime_error);
}

} // namespace
} // namespace scree::test
