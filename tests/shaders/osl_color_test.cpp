// Visible color in src/shaders/scree_set_osl.h against the kernel's C++ front, by every model.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/bake.h"
#include "shaders/exponent_levels.h"
#include "shaders/osl_fixture.h"
#include "shaders/sample_set.h"
#include "support/random_image.h"

namespace scree::test {
namespace {

using Imath::V3f;

/// OpenImageIO finds the centre of a texel to 2^-23 of the image.
constexpr double kTolerance = 2e-5; // absolute, of colors in [0, 1]

constexpr int kSize = 64; // of the sets, texels

class OslColor : public Osl {
protected:
    /// scree_raw on temp_ / "set", a pixel a texel of that level.
    RunResult shade_color(const std::string& name, size_t level, const V3f& view,
                          const ColorLook& look)
    {
        return shade(words(fmt::format(
            "-g {0} {0} --param folder set --param name {1} --param:type=vector view {2},{3},{4} "
            "--param color_model {5} --param slope_color {6} "
            "--param:type=float light_exponent {7} --param:type=float height_scale {8} "
            "--param:type=vector light {9},{10},{11} "
            "-o visible_color color.exr scree_raw",
            kSize >> level, name, view.x, view.y, view.z, look.color_model,
            look.slope_color ? 1 : 0, look.light_exponent, look.height_scale, look.light.x,
            look.light.y, look.light.z)));
    }

    /// Compares levels and views of a set; returns the largest difference.
    double worst_difference(const std::string& name, const ColorLook& look)
    {
        const SampleSet set = read_set(temp_ / "set");
        double worst = 0;
        float shift = 0; // of the mean color
        const std::pair<size_t, V3f> runs[] = {{1, V3f(0.5F, 0.6F, 0.7F).normalized()},
                                               {2, V3f(-0.9F, 0.3F, 0.2F).normalized()},
                                               {4, V3f(0.2F, -0.7F, 0.3F).normalized()}};
        for (const auto& [level, view] : runs) {
            const RunResult result = shade_color(name, level, view, look);
            EXPECT_EQ(result.status, 0) << result.said;
            if (result.status != 0)
                return 1;
            const Image got = output("color");
            EXPECT_EQ(got.width, kSize >> level);
            for (int y = 0; y < got.height; ++y)
                for (int x = 0; x < got.width; ++x) {
                    const V3f want = visible_color(set, level, x, y, view, look);
                    shift = std::max(shift, (want - rgb(set.color[level], x, y)).length());
                    for (int k = 0; k < 3; ++k) {
                        const double error =
                            std::abs(static_cast<double>(got.at(x, y, k)) - want[k]);
                        worst = std::max(worst, error);
                        EXPECT_LE(error, kTolerance)
                            << got.at(x, y, k) << " for " << want[k] << ", model "
                            << look.color_model << " slope color " << look.slope_color << " map by "
                            << set.map_by << " level " << level << " texel " << x << ',' << y
                            << " channel " << k << " view " << view;
                        if (HasFailure())
                            return worst;
                    }
                }
        }
        EXPECT_GE(shift, look.color_model > 0 || look.slope_color ? 0.02F : 0)
            << "a set that shows nothing of model " << look.color_model;
        return worst;
    }
};

TEST_F(OslColor, ByHeightRankAndSlopeIsThatOfTheCppFront)
{
    bake_sample_into(temp_ / "set", "bricks", kSize, kSize);
    compile("src/shaders/scree_raw.osl");
    for (const int model : {0, 1, 2})
        for (const bool slope_color : {false, true})
            RecordProperty(
                fmt::format("worst model {} slope {}", model, slope_color),
                fmt::format("{:.1e}", worst_difference("test", {model, slope_color, 0.7F, 0.5F})));
}

TEST_F(OslColor, OfAColorMapIsThatOfTheCppFront)
{
    compile("src/shaders/scree_raw.osl");
    for (const MapBy by : {MapBy::height, MapBy::slope, MapBy::slope_magnitude}) {
        bake_sample_into(temp_ / "set", "fractal", kSize, kSize, by);
        for (const bool slope_color : {false, true})
            RecordProperty(
                fmt::format("worst by {} slope {}", map_by_name(by), slope_color),
                fmt::format("{:.1e}", worst_difference("test", {3, slope_color, 0.3F, 0.8F})));
    }
}

// Tables along axes, and without harmonics, with one and two; without and with a light.
TEST_F(OslColor, ByVisibilityTablesIsThatOfTheCppFront)
{
    compile("src/shaders/scree_raw.osl");
    bake_sample_into(temp_ / "set", "bricks", kSize, kSize);
    const std::vector<float> cosines[] = {
        {0.9F, 0.4F, 0.2F}, {0.45F}, {0.8F, 0.3F}, {0.9F, 0.75F, 0.5F, 0.3F, 0.15F}};
    int harmonics = -1; // along axes
    for (const auto& nodes : cosines) {
        write_visible_tables(temp_ / "set/test.visible.exr",
                             random_visible_tables(kSize, kSize, nodes, harmonics));
        ColorLook look{4, true}; // the slope has no say
        const std::string key = fmt::format("worst {} nodes {} harmonics", nodes.size(), harmonics);
        RecordProperty(key, fmt::format("{:.1e}", worst_difference("test", look)));
        look.light = V3f(0.3F, 0.5F, 0.4F).normalized();
        RecordProperty(key + " lit", fmt::format("{:.1e}", worst_difference("test", look)));
        ++harmonics;
    }
}

// Without and with a light, as baked and with heights scaled, which scales second moments twice.
TEST_F(OslColor, WithTheMeasuredExponentIsThatOfTheCppFront)
{
    compile("src/shaders/scree_raw.osl");
    bake_sample_into(temp_ / "set", "bricks", kSize, kSize);
    write_exponent_levels(temp_ / "set/test.exponent.exr", exponent_levels(kSize, kSize));
    for (const bool slope_color : {false, true})
        for (const float height_scale : {1.0F, 2.0F}) {
            ColorLook look{5, slope_color, 0, height_scale};
            const std::string key =
                fmt::format("worst slope {} scale {}", slope_color, height_scale);
            RecordProperty(key, fmt::format("{:.1e}", worst_difference("test", look)));
            look.light = V3f(0.3F, 0.5F, 0.4F).normalized();
            RecordProperty(key + " lit", fmt::format("{:.1e}", worst_difference("test", look)));
        }
}

TEST_F(OslColor, ByRankTakesAsManyTermsAsTheFileHas)
{
    compile("src/shaders/scree_raw.osl");
    write_image(temp_ / "h.exr", random_image(kSize, kSize, {"Y"}, 51));
    write_image(temp_ / "c.exr", random_image(kSize, kSize, {"R", "G", "B"}, 52));
    BakeOptions options;
    options.height_file = temp_ / "h.exr";
    options.color_file = temp_ / "c.exr";
    options.output = temp_ / "set";
    options.name = "rough";
    options.texel_size = {{1, 1}};
    options.pixel_type = PixelTypeChoice::float32;
    for (const int terms : {1, 3, 5, 8}) {
        options.rank_terms = terms;
        bake(options);
        RecordProperty(fmt::format("worst of {} terms", terms),
                       fmt::format("{:.1e}", worst_difference("rough", {2, false, 2})));
    }
}

// A map by height keeps the colors of the heights as baked; one by slope sees the scaled slopes.
TEST_F(OslColor, ScaleOfTheHeightsMovesAColorMapBySlopeOnly)
{
    compile("src/shaders/scree_raw.osl");
    const V3f above(0, 0, 1);
    const auto change = [&](MapBy by) {
        bake_sample_into(temp_ / "set", "fractal", kSize, kSize, by);
        float largest = 0;
        Image first;
        for (const float height_scale : {1.0F, 0.5F}) {
            const RunResult result = shade_color("test", 2, above, {3, false, 0, height_scale});
            EXPECT_EQ(result.status, 0) << result.said;
            const Image image = output("color");
            for (size_t i = 0; i < first.pixels.size(); ++i)
                largest = std::max(largest, std::abs(image.pixels[i] - first.pixels[i]));
            first = image;
        }
        return largest;
    };
    EXPECT_EQ(change(MapBy::height), 0);
    EXPECT_GT(change(MapBy::slope), 0.05F);
    EXPECT_GT(change(MapBy::slope_magnitude), 0.05F);
}

TEST_F(OslColor, AMissingMapIsNamed)
{
    compile("src/shaders/scree_raw.osl");
    bake_sample_into(temp_ / "set", "bricks", kSize, kSize);
    for (const char* map : {"rank", "colorheight", "colorslope"})
        std::filesystem::remove(temp_ / "set" / fmt::format("test.{}.exr", map));
    const std::pair<ColorLook, const char*> cases[] = {
        {{4, false}, "test.visible.exr"},     {{5, false}, "test.exponent.exr"},
        {{1, false}, "test.colorheight.exr"}, {{2, false}, "test.rank.exr"},
        {{3, false}, "test.map.exr"},         {{0, true}, "test.colorslope.exr"}};
    for (const auto& [look, file] : cases) {
        const RunResult result = shade_color("test", 3, V3f(0, 0, 1), look);
        EXPECT_NE(result.status, 0);
        EXPECT_NE(result.said.find(std::string("set/") + file), std::string::npos) << result.said;
        EXPECT_NE(result.said.find("bake the set with this map"), std::string::npos) << result.said;
    }
}

} // namespace
} // namespace scree::test
