// What a renderer reads beside holes: up to the border of data a constant stays constant.
//
// Where texels without data held anything else it would blend in: slope 0, the map's mean color.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "support/baked_levels.h"
#include "texset/texture_lookup.h"

namespace scree::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using HasData = std::function<bool(int x, int y)>;

/// Slopes and colors of a surface; where it has no data they are NaN.
MemorySource flat_source(int width, int height, const HasData& has_data,
                         const std::function<std::array<double, 3>(int x, int y)>& color)
{
    MemorySource source;
    source.map_width = width;
    source.map_height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double s = has_data(x, y) ? 0.75 : kNaN;
            source.slopes.push_back({s, -0.5});
            source.colors.push_back(color(x, y));
        }
    return source;
}

/// Calls `look` at the corners of texels with data, with derivatives of a texel of every
/// level, and of one and a half, which blends two levels.
void at_corners(const std::vector<Image>& coverage,
                const std::function<void(const TexturePlace&, size_t level, int x, int y)>& look)
{
    const Image& finest = coverage[0];
    for (int y = 0; y < finest.height; ++y)
        for (int x = 0; x < finest.width; ++x) {
            if (!(finest.at(x, y, 0) > 0) || (x + 2 * y) % 3 > 0) // a third will do
                continue;
            for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}})
                for (size_t l = 0; l < coverage.size(); ++l)
                    for (const float size : {1.0F, 1.5F}) {
                        TexturePlace place;
                        place.s = static_cast<float>(x + dx) / static_cast<float>(finest.width);
                        place.t = static_cast<float>(y + dy) / static_cast<float>(finest.height);
                        place.ds_dx = size / static_cast<float>(coverage[l].width);
                        place.dt_dy = size / static_cast<float>(coverage[l].height);
                        look(place, l, x, y);
                    }
        }
}

const HasData kLeftHalf = [](int x, int /*y*/) { return x < 35; };
const HasData kBlobs = [](int x, int y) {
    return std::sin(0.31 * x) + std::sin(0.27 * y + 0.2 * x) > -0.3;
};
const HasData kDots = [](int x, int y) { return (x * 7 + y * 11) % 10 > 0; };

TEST(GutterLookup, LookupsOfAConstantSlopeAreConstantUpToTheBorderOfData)
{
    for (const auto& has_data : {kLeftHalf, kBlobs, kDots})
        for (const auto& [width, height] : {std::pair(70, 64), std::pair(71, 33)})
            for (const Wrap wrap : {Wrap::periodic, Wrap::clamp, Wrap::mirror})
                for (const auto type : {PixelTypeChoice::float32, PixelTypeChoice::half}) {
                    BakeOptions options;
                    options.wrap_s = options.wrap_t = wrap;
                    options.pixel_type = type;
                    options.maps = {Map::slope};
                    const BakedLevels baked(flat_source(width, height, has_data,
                                                        [](int, int) {
                                                            return std::array{0.5, 0.25, 0.125};
                                                        }),
                                            options);
                    const TextureLookup lookup(baked.folder(), baked.manifest);
                    // 0.75 and -0.5 and their products are halves; a lookup is in float.
                    const float expected[] = {0.75F, 0.5625F, -0.375F, -0.5F, 0.25F};
                    int looked = 0;
                    at_corners(baked.levels.at("coverage"), [&](const TexturePlace& place,
                                                                size_t level, int x, int y) {
                        float got[5];
                        lookup.read(Map::slope, place, 0, 5, got);
                        for (int c = 0; c < 5; ++c)
                            EXPECT_NEAR(got[c], expected[c], 2e-6F)
                                << wrap_name(wrap) << " level " << level << " texel " << x << ","
                                << y << " at " << place.s << "," << place.t << " channel " << c;
                        ++looked;
                    });
                    ASSERT_GT(looked, 10'000);
                    if (HasFailure())
                        return;
                }
}

TEST(GutterLookup, LookupsOfAPlaneHaveItsSlopeUpToTheBorderOfData)
{
    // Every texel with data has others beside it along both axes: else its own slope would be 0.
    const HasData corner = [](int x, int y) { return y > 10 && (x < 31 || y > 30); };
    for (const auto& has_data : {kLeftHalf, corner}) {
        MemorySource plane;
        plane.map_width = 70;
        plane.map_height = 47;
        for (int y = 0; y < 47; ++y)
            for (int x = 0; x < 70; ++x)
                plane.heights.push_back(has_data(x, y) ? 0.75 * x - 0.5 * y : kNaN);
        BakeOptions options;
        options.wrap_s = options.wrap_t = Wrap::clamp;
        options.pixel_type = PixelTypeChoice::float32;
        const BakedLevels baked(plane, options);
        const TextureLookup lookup(baked.folder(), baked.manifest);
        at_corners(baked.levels.at("coverage"),
                   [&](const TexturePlace& place, size_t level, int x, int y) {
                       float got[5];
                       lookup.read(Map::slope, place, 0, 5, got);
                       EXPECT_NEAR(got[0], 0.75F, 2e-6F) << level << " " << x << "," << y;
                       EXPECT_NEAR(got[3], -0.5F, 2e-6F) << level << " " << x << "," << y;
                       EXPECT_NEAR(got[1] - got[0] * got[0], 0, 4e-6F) << level;
                   });
        if (HasFailure())
            return;
    }
}

TEST(GutterLookup, LookupsOfColorsInIslandsAreNotMixedWithTheMapsMean)
{
    // Two islands 40 texels apart: 5 of level 3, so that their gutters do not meet up to there.
    const auto is_left = [](int x) { return x < 64; };
    const HasData islands = [](int x, int y) {
        return y >= 10 && y < 50 && ((x >= 4 && x < 44) || (x >= 84 && x < 124));
    };
    BakeOptions options;
    options.pixel_type = PixelTypeChoice::float32;
    options.maps = {Map::color};
    const BakedLevels baked(
        flat_source(160, 160, islands,
                    [&](int x, int) {
                        return is_left(x) ? std::array{1.0, 0.0, 0.25} : std::array{0.0, 1.0, 0.5};
                    }),
        options);
    const TextureLookup lookup(baked.folder(), baked.manifest);
    int looked = 0;
    at_corners(baked.levels.at("coverage"),
               [&](const TexturePlace& place, size_t level, int x, int y) {
                   if (level > 2) // blends in the next
                       return;
                   ++looked;
                   float got[3];
                   lookup.read(Map::color, place, 0, 3, got);
                   const bool left = is_left(x);
                   EXPECT_NEAR(got[0], left ? 1.0F : 0.0F, 2e-6F) << level << " " << x << "," << y;
                   EXPECT_NEAR(got[2], left ? 0.25F : 0.5F, 2e-6F) << level << " " << x << "," << y;
               });
    EXPECT_GT(looked, 10'000);
}

} // namespace
} // namespace scree::test
