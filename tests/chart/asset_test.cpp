#include "chart/asset.h"

#include <gtest/gtest.h>

#include "math/error.h"
#include "pipeline/bake.h"
#include "sample/field.h"
#include "support/files.h"
#include "support/random_image.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

TEST(SampleAsset, HasTheSamplesHeightsColorsAndScale)
{
    const auto field = make_sample("fractal", 20, 20);
    const Asset asset = sample_asset("fractal", 20);
    const reference::Relief& relief = asset.relief;
    EXPECT_EQ(asset.name, "fractal");
    ASSERT_EQ(relief.width, 20);
    ASSERT_EQ(relief.height, 20);
    EXPECT_EQ(relief.beyond_s, reference::Beyond::repeats);
    EXPECT_DOUBLE_EQ(relief.texel_width, field->info().world_width / 20);
    std::vector<float> heights(20), rgb(60);
    field->row(7, heights.data(), rgb.data());
    const size_t row = 140; // the seventh
    for (size_t x = 0; x < 20; ++x) {
        EXPECT_EQ(relief.heights[row + x], static_cast<double>(heights[x]));
        for (size_t c = 0; c < 3; ++c)
            EXPECT_EQ(relief.colors[row + x][c], static_cast<double>(rgb[3 * x + c]));
    }
}

TEST(SampleAsset, TellsWhichKindsThereAre)
{
    try {
        sample_asset("marble", 64);
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("fractal"), std::string::npos) << e.what();
    }
}

/// Bakes into temp/name and returns the bytes of the slope and the color.
std::string baked(Source& source, const BakeOptions& like, const TempFolder& temp,
                  const std::string& name)
{
    BakeOptions options = like;
    options.output = temp / name;
    Manifest manifest;
    manifest.name = "x";
    bake(source, options, manifest);
    return read_bytes(temp / name / "x.slope.exr") + read_bytes(temp / name / "x.colorheight.exr");
}

TEST(AssetSource, BakesAsTheOriginalDoes)
{
    const TempFolder temp;
    const Asset asset = sample_asset("bricks", 40);
    AssetSource copy(asset);
    const auto field = make_sample("bricks", 40, 40);
    MemorySource original = sample_source(*field, 40, 40);
    BakeOptions options;
    options.world_size = {field->info().world_width, field->info().world_height};
    EXPECT_EQ(baked(copy, asset.options, temp, "copy"), baked(original, options, temp, "original"));
}

TEST(AssetOf, ReadsFilesAsABakeDoes)
{
    const TempFolder temp;
    const Image heights = random_image(9, 5, {"Y"}, 1),
                colors = random_image(9, 5, {"R", "G", "B"}, 2);
    write_image(temp / "h.exr", heights);
    write_image(temp / "c.exr", colors);
    BakeOptions options;
    options.height_file = temp / "h.exr";
    options.color_file = temp / "c.exr";
    options.height_scale = 3;
    options.texel_size = {0.5, 0.25};
    options.wrap_s = Wrap::clamp;
    options.wrap_t = Wrap::mirror;
    const Asset asset = asset_of(options);
    EXPECT_EQ(asset.name, "h");
    EXPECT_EQ(asset.relief.texel_height, 0.25);
    EXPECT_EQ(asset.relief.beyond_s, reference::Beyond::extends);
    EXPECT_EQ(asset.relief.beyond_t, reference::Beyond::mirrors);
    EXPECT_DOUBLE_EQ(asset.relief.heights[12], 3 * static_cast<double>(heights.pixels[12]));
    EXPECT_NEAR(asset.relief.colors[12][2], static_cast<double>(colors.pixels[38]), 1e-6);

    options.color_file.clear();
    EXPECT_EQ(asset_of(options).relief.colors[12], (reference::Rgb{1, 1, 1}));
}

TEST(AssetOf, RefusesNormalMaps)
{
    BakeOptions options;
    options.height_file = "bumps.png";
    options.normal_input = true;
    try {
        asset_of(options);
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("bumps.png"), std::string::npos) << e.what();
    }
}

} // namespace
} // namespace scree::test
