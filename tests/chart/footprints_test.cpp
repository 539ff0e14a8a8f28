#include "chart/footprints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "chart/temp_folder.h"
#include "judge/set_reader.h"
#include "pipeline/bake.h"

namespace scree {
namespace {

/// Mean over a footprint of a figure of its texels, by the definition.
template <class Figure>
double mean_over(const reference::Footprint& footprint, Figure figure)
{
    double sum = 0;
    for (size_t j = 0; j < footprint.t.share.size(); ++j)
        for (size_t i = 0; i < footprint.s.share.size(); ++i)
            sum += footprint.t.share[j] * footprint.s.share[i] *
                   figure(footprint.s.first + static_cast<int>(i),
                          footprint.t.first + static_cast<int>(j));
    return sum;
}

class ChartFootprintsTest : public testing::Test {
protected:
    static constexpr int kSize = 36; ///< 9 x 9, 4 x 4, 2 x 2 and 1 x 1 footprints, some uneven

    const Asset asset = sample_asset("fractal", kSize);
    const ChartFootprints all = bake_footprints(asset, 20, 1, {});

    /// The map is periodic.
    [[nodiscard]] size_t texel(int x, int y) const
    {
        const auto row = static_cast<size_t>((y + kSize) % kSize);
        return row * kSize + static_cast<size_t>((x + kSize) % kSize);
    }
    [[nodiscard]] double height(int x, int y) const { return asset.relief.heights[texel(x, y)]; }
};

TEST_F(ChartFootprintsTest, AreOfEveryLevelFromFourTexelsUp)
{
    ASSERT_EQ(all.places.size(), 20U + 16 + 4 + 1);
    ASSERT_EQ(all.data.size(), all.places.size());
    for (const reference::Footprint& place : all.places)
        EXPECT_GE(place.s.share.size(), 4U);
}

// Tolerances: what half storage costs, 2^-11 of the number.
TEST_F(ChartFootprintsTest, HoldWhatTheTexelsHold)
{
    for (size_t f = 0; f < all.places.size(); ++f) {
        const double green = mean_over(
            all.places[f], [this](int x, int y) { return asset.relief.colors[texel(x, y)][1]; });
        EXPECT_NEAR(all.data[f].set.color[1] / green, 1, 6e-4) << f;
    }
}

// Oracle: the 3 x 3 Sobel operator, rows 1 2 1 over 8, on the heights themselves.
TEST_F(ChartFootprintsTest, HaveTheMomentsOfSobelSlopes)
{
    const auto slope_s = [this](int x, int y) {
        const double rise = height(x + 1, y - 1) - height(x - 1, y - 1) +
                            2 * (height(x + 1, y) - height(x - 1, y)) + height(x + 1, y + 1) -
                            height(x - 1, y + 1);
        return rise / 8 / asset.relief.texel_width;
    };
    for (size_t f = 0; f < all.places.size(); ++f) {
        const double mean = mean_over(all.places[f], slope_s);
        const double square =
            mean_over(all.places[f], [&](int x, int y) { return std::pow(slope_s(x, y), 2); });
        EXPECT_NEAR(all.data[f].sobel.s, mean, 1e-3 * std::sqrt(square)) << f;
        EXPECT_NEAR(all.data[f].sobel.ss / square, 1, 1e-3) << f;
        EXPECT_LT(all.data[f].sobel.ss, all.data[f].set.slope.ss) << "Sobel smooths";
    }
}

// Of a rough surface normals are no plane's; their mean points where the mean slope does.
TEST_F(ChartFootprintsTest, HaveShortenedNormals)
{
    for (size_t f = 0; f < all.places.size(); ++f) {
        const FootprintData& data = all.data[f];
        EXPECT_LT(data.normal.length(), 1.0005F) << f;
        const auto slopes = filter::slopes(data.set.slope);
        const float spread = slopes.covariance.ss + slopes.covariance.tt;
        EXPECT_NEAR(-data.normal.x / data.normal.z, slopes.mean.x, spread) << f;
        EXPECT_NEAR(-data.normal.y / data.normal.z, slopes.mean.y, spread) << f;
    }
    EXPECT_LT(all.data.back().normal.length(), 0.98F) << "the whole map";
}

/// What a set with such a table alone has of the whole map.
struct BakedTable {
    std::array<float, kMostVisibleChannels> numbers;
    VisibilityRecord layout;
};

BakedTable baked_table(const Asset& asset, int harmonics, bool axes)
{
    const TempFolder temp;
    BakeOptions options = asset.options;
    options.output = temp.path() / "set";
    options.maps = {Map::visible};
    options.table = {best_node_angles(4), harmonics, 8, axes};
    options.pixel_type = PixelTypeChoice::float32;
    Manifest manifest;
    manifest.name = "asset";
    AssetSource source(asset);
    manifest = bake(source, options, manifest);
    const int levels = static_cast<int>(manifest.levels.size());
    return {SetReader(options.output).row(levels - 1, 0).front().visible,
            manifest.visibility.value()};
}

// Oracle: sets that were baked with those tables alone.
TEST_F(ChartFootprintsTest, HoldTablesAsSetsOfTheirOwnDo)
{
    const FootprintData& whole = all.data.back();
    const auto expect_equal = [](const auto& table, const auto& want) {
        for (size_t i = 0; i < table.size(); ++i) // halves, of which the largest is 1
            EXPECT_NEAR(table[i], want[i], 5e-4) << i;
        double largest = 0;
        for (const float value : table)
            largest = std::max(largest, static_cast<double>(std::abs(value)));
        EXPECT_GT(largest, 0.02) << "nothing that is off would be found";
    };
    const auto mean = baked_table(asset, 0, false).numbers;
    expect_equal(whole.visible_4x1, mean);
    expect_equal(whole.visible_2x1, std::array<float, 8>{mean[4], mean[5], mean[6], mean[7],
                                                         mean[12], mean[13], mean[14], mean[15]});
    expect_equal(whole.visible_4x3, baked_table(asset, 1, false).numbers);
    expect_equal(whole.visible_axes, baked_table(asset, 0, true).numbers);
}

// Of a surface so flat that it hides late, and whose walls stand askew: what a bake decides on of
// itself is not what it begins with.
TEST(ChartFootprints, KnowWhereTheBakesLaidNodesAndAxes)
{
    Asset asset = sample_asset("bricks", 16);
    reference::Relief& relief = asset.relief;
    for (size_t i = 0; i < relief.heights.size(); ++i) {
        const size_t x = i % 16, y = i / 16;
        relief.heights[i] = 0.03 * relief.texel_width * static_cast<double>((x + 2 * y) % 16);
    }
    const ChartFootprints all = bake_footprints(asset, 1, 1, {});
    const VisibilityRecord harmonics = baked_table(asset, 2, false).layout;
    const VisibilityRecord axes = baked_table(asset, 0, true).layout;
    EXPECT_EQ(all.visibility.node_angles_deg, harmonics.node_angles_deg);
    EXPECT_EQ(all.visibility.axis_deg, std::nullopt);
    EXPECT_EQ(all.visibility_axes.node_angles_deg, axes.node_angles_deg);
    ASSERT_TRUE(all.visibility_axes.axis_deg);
    EXPECT_EQ(*all.visibility_axes.axis_deg, axes.axis_deg);
    EXPECT_GT(std::abs(*all.visibility_axes.axis_deg), 5);
}

TEST_F(ChartFootprintsTest, HaveColorsForAllHeights)
{
    for (const FootprintData& data : all.data) {
        EXPECT_GE(data.set.h, all.height_colors.low);
        EXPECT_LE(data.set.h, all.height_colors.high);
    }
}

} // namespace
} // namespace scree
