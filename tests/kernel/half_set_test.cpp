// Visible color from a set in half floats against the same set in float32: what rounding of the
// stored moments may show.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/filter.h"
#include "pipeline/bake.h"
#include "support/files.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

using Imath::V3f;

struct Maps {
    std::vector<Image> height, color, colorheight;
};

Maps bake_as(const std::string& kind, PixelTypeChoice type)
{
    TempFolder temp;
    MemorySource source = sample_source(*make_sample(kind, 256, 256), 256, 256);
    BakeOptions options;
    options.output = temp / "set";
    options.pixel_type = type;
    options.texel_size = {{1, 1}};
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
    const auto levels = [&](const std::string& map) {
        return read_levels(temp / "set" / ("test." + map + ".exr"));
    };
    return {levels("height"), levels("color"), levels("colorheight")};
}

V3f color_at(const Maps& maps, size_t level, int x, int y, float exponent)
{
    const auto rgb = [&](const Image& image) {
        return V3f(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2));
    };
    return filter::color_by_height(rgb(maps.color[level]), rgb(maps.colorheight[level]),
                                   maps.height[level].at(x, y, 0), maps.height[level].at(x, y, 1),
                                   filter::visible_height(exponent));
}

// The shift fades out where half the variance may be rounding. What is left of rounding there is up
// to 2^-6 of the color times mu(L), 1.9 at exponent 20.
TEST(HalfSet, ShowsTheColorsOfTheFloatSet)
{
    for (const char* kind : {"fractal", "bricks"}) {
        const Maps half = bake_as(kind, PixelTypeChoice::half);
        const Maps single = bake_as(kind, PixelTypeChoice::float32);
        for (const float exponent : {0.0F, 1.0F, 20.0F})
            for (size_t level = 0; level < 6; ++level) {
                float worst = 0;
                for (int y = 0; y < single.color[level].height; ++y)
                    for (int x = 0; x < single.color[level].width; ++x) {
                        const V3f difference = color_at(half, level, x, y, exponent) -
                                               color_at(single, level, x, y, exponent);
                        for (int i = 0; i < 3; ++i)
                            worst = std::max(worst, std::abs(difference[i]));
                    }
                EXPECT_LE(worst, exponent > 1 ? 0.04F : 0.02F)
                    << kind << " level " << level << " exponent " << exponent;
            }
    }
}

} // namespace
} // namespace scree::test
