// Pictures of a set beside the truth: what is looked up, what is compared, what stands where.

#include "judge/preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "judge/original.h"
#include "math/error.h"
#include "pipeline/bake.h"
#include "sample/field.h"
#include "support/files.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;

Vec3 direction(double angle_deg, double azimuth_deg)
{
    const double angle = angle_deg * kRadPerDegree, azimuth = azimuth_deg * kRadPerDegree;
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
            std::cos(angle)};
}

/// A set baked from a source, tiled, and the surface.
struct Scene {
    TempFolder temp;
    std::optional<SetLookup> set;
    std::optional<reference::DisplacedSurface> surface;

    explicit Scene(MemorySource source, const std::vector<Map>& maps = {})
    {
        BakeOptions options;
        options.output = temp / "set";
        options.texel_size = {{1, 1}};
        options.pixel_type = PixelTypeChoice::float32;

        options.maps = maps;
        Manifest manifest;
        manifest.name = "test";
        bake(source, options, manifest);
        TextureFilter filter;
        filter.is_tiled = true;
        set.emplace(temp / "set", filter);
        surface.emplace(read_original(source, options, {}).relief);
    }
};

/// Waves along s; red goes once around the map, green goes with height.
MemorySource waves(int size, double amplitude)
{
    MemorySource source;
    source.map_width = source.map_height = size;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double phase = 2 * 3.14159265358979323846 * x / size;
            source.heights.push_back(amplitude * std::sin(3 * phase));
            source.colors.push_back(
                {0.5 + 0.25 * std::sin(phase), 0.4 + 0.2 * std::sin(3 * phase), 0.3});
        }
    return source;
}

PreviewScene lit_from(const Vec3& light, int grid)
{
    PreviewScene scene;
    scene.light = light;
    scene.grid = grid;
    return scene;
}

TEST(SetLookup, IsWhatTheReaderReads)
{
    const auto field = make_sample("bricks", 64, 64);
    const Scene scene(sample_source(*field, 64, 64));
    SetReader reader(scene.temp / "set");
    const SetTexel expected = reader.row(1, 9)[20];
    const float step = 1 / 32.0F;
    const SetTexel got = scene.set->at({20.5F * step, 9.5F * step, step, 0, 0, step});
    constexpr float kRounding = 1e-5F; // of the place, times differences of neighbours
    EXPECT_NEAR(got.slope.st, expected.slope.st, kRounding);
    EXPECT_NEAR(got.hh, expected.hh, kRounding);
    EXPECT_NEAR(got.tau, expected.tau, kRounding);
    EXPECT_NEAR(got.color[2], expected.color[2], kRounding);
    EXPECT_NEAR(got.rank[3][0], expected.rank[3][0], kRounding);
    EXPECT_EQ(got.coverage, 1);
}

TEST(SetLookup, ReadsNoMapThatTheBestColorModelDoesNotNeed)
{
    const auto field = make_sample("bricks", 64, 64);
    const TexturePlace whole{0.5F, 0.5F, 1, 0, 0, 1};
    auto read = [&](const std::vector<Map>& maps) {
        const Scene scene(sample_source(*field, 64, 64), maps);
        return scene.set->at(whole);
    };
    const SetTexel by_rank = read({});
    EXPECT_NE(by_rank.rank[0][0], 0);
    EXPECT_NE(by_rank.color_t[0], 0); // slope goes with any of them
    EXPECT_EQ(by_rank.color_height[0], 0);
    const SetTexel by_height = read({Map::slope, Map::height, Map::color, Map::colorheight});
    EXPECT_NE(by_height.color_height[0], 0);
    EXPECT_EQ(by_height.color_t[0], 0);
    const std::array<float, 3> smiths = by_height.exponent;
    const SetTexel measured =
        read({Map::slope, Map::height, Map::color, Map::colorheight, Map::exponent});
    EXPECT_NE(measured.color_height[0], 0);
    EXPECT_NE(measured.exponent, smiths);
    const SetTexel by_tables = read({Map::slope, Map::height, Map::color, Map::colorheight,
                                     Map::colorslope, Map::exponent, Map::rank, Map::visible});
    EXPECT_NE(by_tables.visible[15], 0); // of the last of four nodes
    EXPECT_EQ(by_tables.color_height[0], 0);
    EXPECT_EQ(by_tables.color_t[0], 0);
    EXPECT_EQ(by_tables.rank[0][0], 0);
    EXPECT_EQ(by_tables.exponent, smiths);
}

// On a plane nothing hides or spreads: all three parts are the color under the light, but for how
// a texture is filtered.
TEST(Preview, OnAPlaneAllPartsAgree)
{
    const Scene scene(waves(64, 0));
    StripShot shot;
    shot.angles_deg = {0, 60};
    shot.tile = 16;
    shot.texels_per_pixel = 2;
    const Preview preview =
        draw_strip(*scene.set, &*scene.surface, lit_from(direction(40, 20), 4), shot);
    ASSERT_EQ(preview.errors.size(), 2U);
    for (const PreviewErrors& errors : preview.errors)
        for (const PixelErrors& part : {errors.plain, errors.set}) {
            EXPECT_NEAR(part.brightness, 1, 1e-3) << errors.angle_deg;
            EXPECT_LT(part.rms, 0.01) << errors.angle_deg;
        }
}

// Lookups of the whole map are its top level, shaded by the kernel.
TEST(Preview, APixelOverTheWholeMapIsItsTopLevelShaded)
{
    const Scene scene(waves(64, 2));
    reference::Aim aim;
    aim.angle_rad = 70 * kRadPerDegree;
    aim.azimuth_rad = 30 * kRadPerDegree;
    aim.width = 3 * 64 * 4;
    aim.columns = 3;
    const auto camera = reference::Camera::distant(aim, 10);
    const Material material;
    const Vec3 light = direction(50, 200);
    const LookedUp pixels = look_up(*scene.set, material, light, camera, {1, 2, 1});
    ASSERT_EQ(pixels.set.size(), 2U);

    SetReader reader(scene.temp / "set");
    const int top = static_cast<int>(reader.manifest().levels.size()) - 1;
    const SetTexel texel = reader.row(top, 0).front();
    const Vec3f wo(direction(70, 30)), wi(light);
    const auto slopes = slopes_of(texel);
    const float exponent = filter::masking(wo, slopes).lambda + filter::masking(wi, slopes).lambda;
    const Rgbf seen =
        color_of_exponent(texel, reader.colors(), ColorModel::rank, true, wo, exponent);
    const Rgbf of_set = radiance(slopes, seen, material, wo, wi);
    const Rgbf of_plain = plain_radiance(texel, material, wo, wi);
    for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(pixels.set[1].radiance[c], of_set[c], 1e-5F);
        EXPECT_NEAR(pixels.plain[0].radiance[c], of_plain[c], 1e-5F);
        EXPECT_GT(std::abs(of_set[c] - of_plain[c]), 1e-3F) << "a weak example";
    }
}

/// A strip of one tile of the set alone.
Picture tile_of(const Scene& scene, double azimuth_deg)
{
    PreviewScene lit = lit_from(direction(40, 20), 1);
    lit.parts = {PreviewPart::set};
    StripShot shot;
    shot.angles_deg = {60};
    shot.azimuth_deg = azimuth_deg;
    shot.tile = 16;
    shot.texels_per_pixel = 2;
    return draw_strip(*scene.set, nullptr, lit, shot).picture;
}

TEST(Preview, IsSeenFromItsAzimuth)
{
    const Scene scene(waves(64, 0)); // red changes along s alone
    auto red = [](const Picture& picture, size_t x, size_t y) {
        return picture.rgb[3 * (16 * y + x)];
    };
    const Picture from_t = tile_of(scene, 90), from_s = tile_of(scene, 0);
    EXPECT_NEAR(red(from_t, 8, 2), red(from_t, 8, 13), 1e-4F);
    EXPECT_GT(red(from_t, 3, 8) - red(from_t, 12, 8), 0.1F) << "the middle falls to the right";
    EXPECT_NEAR(red(from_s, 2, 8), red(from_s, 13, 8), 1e-4F);
    EXPECT_GT(red(from_s, 8, 6) - red(from_s, 8, 10), 0.1F) << "the middle falls to the viewer";
}

TEST(Preview, FarRepeatsAreAsSharpAsNearOnes)
{
    const Scene scene(waves(64, 0));
    auto row_at = [&scene](double repeats) {
        reference::Aim aim;
        aim.target = {64 * (repeats + 0.5), 64 * (repeats + 0.5)};
        aim.width = 64;
        aim.columns = 32;
        const auto camera = reference::Camera::distant(aim, 10);
        return look_up(*scene.set, Material(), direction(40, 20), camera, {0, 32, 1}).plain;
    };
    const ShadedPixels near = row_at(0), far = row_at(0x1p24);
    for (size_t i = 0; i < near.size(); ++i)
        EXPECT_NEAR(near[i].radiance[1], far[i].radiance[1], 1e-5F) << "pixel " << i;
}

ShadedPixels grays(const std::vector<float>& values, float covered = 1)
{
    ShadedPixels pixels;
    for (const float value : values)
        pixels.push_back({{value, value, value}, covered});
    return pixels;
}

TEST(Preview, ErrorsAreThoseOfTheirDefinition)
{
    TruePixels truth;
    truth.all = grays({1, 3});
    truth.halves = {grays({1.5F, 3}), grays({0.5F, 3})};
    const PixelErrors errors = compare(grays({2, 4}), truth);
    EXPECT_DOUBLE_EQ(errors.brightness, 6.0 / 4);
    EXPECT_DOUBLE_EQ(errors.rms, std::sqrt(2.0 / 10));
    EXPECT_DOUBLE_EQ(errors.noise, std::sqrt(0.25 / 10));

    // The sky does not count, on either side.
    truth.all[1].covered = 0.5F;
    EXPECT_DOUBLE_EQ(compare(grays({2, 4}), truth).brightness, 2);
    EXPECT_EQ(compare(grays({2, 4}, 0), truth).brightness, 0);
}

const float* pixel(const Picture& picture, int x, int y)
{
    return &picture.rgb[3 * (static_cast<size_t>(y) * static_cast<size_t>(picture.width) +
                             static_cast<size_t>(x))];
}

bool is_white(const float* rgb) { return rgb[0] == 1 && rgb[1] == 1 && rgb[2] == 1; }

TEST(Preview, ThePlanesPictureIsSplitAndHasASky)
{
    const Scene scene(waves(16, 0.5));
    PreviewScene lit = lit_from(direction(40, 20), 2);
    lit.exposure = 0.5;
    PlaneShot shot;
    shot.width = 100;
    shot.height = 40;
    double last = 0;
    lit.progress = [&last](double done) {
        EXPECT_GE(done, last);
        last = done;
    };
    const Preview preview = draw_plane(*scene.set, &*scene.surface, lit, shot);
    EXPECT_DOUBLE_EQ(last, 1);
    EXPECT_EQ(preview.picture.width, 100);
    EXPECT_EQ(preview.picture.height, 40);
    EXPECT_EQ(preview.exposure, 0.5);
    EXPECT_EQ(preview.samples, 34 * 40 * 4);
    for (int x = 0; x < 100; ++x) {
        const bool is_line = x == 33 || x == 66;
        EXPECT_EQ(is_white(pixel(preview.picture, x, 39)), is_line) << "column " << x;
        EXPECT_EQ(pixel(preview.picture, x, 0)[2] > pixel(preview.picture, x, 0)[0], !is_line)
            << "no sky in column " << x;
    }
    // Half the exposure, half as bright.
    lit.exposure = 0.25;
    lit.progress = {};
    const Preview darker = draw_plane(*scene.set, &*scene.surface, lit, shot);
    for (const int x : {10, 50, 90})
        EXPECT_NEAR(pixel(darker.picture, x, 30)[1], pixel(preview.picture, x, 30)[1] / 2, 1e-6F);
}

TEST(Preview, TheStripHasARowForEachPartAndAColumnForEachAngle)
{
    const auto field = make_sample("bricks", 64, 64);
    const Scene scene(sample_source(*field, 64, 64));
    PreviewScene lit = lit_from(direction(60, 200), 3);
    lit.exposure = 1;
    StripShot shot;
    shot.angles_deg = {0, 40, 80};
    shot.tile = 10;
    const Preview all = draw_strip(*scene.set, &*scene.surface, lit, shot);
    EXPECT_EQ(all.picture.width, 3 * 10 + 2 * 2);
    EXPECT_EQ(all.picture.height, 3 * 10 + 2 * 2);
    ASSERT_EQ(all.errors.size(), 3U);
    EXPECT_EQ(all.errors[2].angle_deg, 80);

    // A strip of the set alone is its middle row, and needs no surface.
    lit.parts = {PreviewPart::set};
    const Preview alone = draw_strip(*scene.set, nullptr, lit, shot);
    EXPECT_TRUE(alone.errors.empty());
    EXPECT_EQ(alone.samples, 0);
    ASSERT_EQ(alone.picture.height, 10);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 34; ++x)
            EXPECT_TRUE(std::equal(pixel(alone.picture, x, y), pixel(alone.picture, x, y) + 3,
                                   pixel(all.picture, x, 12 + y)))
                << x << " " << y;
}

// What the pictures are for: plain MIP is far off at grazing angles, the set much less. Bricks'
// mortar hides behind bricks.
TEST(Preview, TheSetIsNearerToTheTruthThanPlainMip)
{
    const auto field = make_sample("bricks", 64, 64);
    const Scene scene(sample_source(*field, 64, 64));
    StripShot shot;
    shot.angles_deg = {75};
    shot.tile = 16;
    const Preview preview =
        draw_strip(*scene.set, &*scene.surface, lit_from(direction(60, 200), 16), shot);
    ASSERT_EQ(preview.errors.size(), 1U);
    EXPECT_LT(preview.errors[0].set.rms, preview.errors[0].plain.rms / 2);
    EXPECT_LT(preview.errors[0].set.noise, preview.errors[0].set.rms / 2) << "too noisy to tell";
}

TEST(Preview, FitsTheExposureToWhatIsShown)
{
    const Scene scene(waves(16, 0));
    StripShot shot;
    shot.angles_deg = {0};
    shot.tile = 16;
    const Preview preview =
        draw_strip(*scene.set, &*scene.surface, lit_from(direction(40, 20), 1), shot);
    std::vector<float> values = preview.picture.rgb;
    // The lines are white; of the rest 2 % are brighter than 0.8.
    values.erase(std::remove(values.begin(), values.end(), 1.0F), values.end());
    std::sort(values.begin(), values.end());
    EXPECT_NEAR(values[values.size() * 995 / 1000], 0.8F, 0.02F);
}

TEST(Preview, ACameraInsideTheSurfaceIsAnError)
{
    const Scene scene(waves(16, 4));
    PlaneShot shot;
    shot.repeats = 0.05;
    try {
        draw_plane(*scene.set, &*scene.surface, lit_from(direction(40, 20), 1), shot);
        ADD_FAILURE() << "was drawn";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("show more repeats"), std::string::npos) << e.what();
    }
}

TEST(Preview, ProgressMayStopIt)
{
    const Scene scene(waves(16, 0));
    PreviewScene lit = lit_from(direction(40, 20), 1);
    lit.progress = [](double) { throw std::runtime_error("stop"); };
    EXPECT_THROW(draw_plane(*scene.set, &*scene.surface, lit, PlaneShot()), std::runtime_error);
}

} // namespace
} // namespace scree::test
