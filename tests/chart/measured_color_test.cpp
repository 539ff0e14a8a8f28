#include "chart/measured_color.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/some_footprint.h"

namespace scree::test {
namespace {

/// What a set's colors have in common whose table has such nodes.
template <class Cosines>
SetColors colors_with(const Cosines& cosines, int harmonics)
{
    SetColors colors;
    colors.models = {ColorModel::mean, ColorModel::visible};
    colors.node_cosines.assign(cosines.begin(), cosines.end());
    colors.harmonics = harmonics;
    return colors;
}

/// What preview and validate show of a set (shading.h) is what the chart says of it.
void expect_shows(const std::string& name, const FootprintData& data, const MethodSetting& setting,
                  const SetTexel& texel, const SetColors& colors)
{
    const Vec3f wo(toward(1.4, 0.4)), wi(toward(1.2, 2.5));
    const Method& method = method_named(name);
    EXPECT_EQ(method.color(data, setting, wo), visible_color(texel, colors, colors.best(), wo))
        << name;
    EXPECT_EQ(method.radiance(data, setting, wo, wi),
              set_radiance(texel, colors, setting.material, wo, wi))
        << name;
    EXPECT_NE(method.color(data, setting, wo), texel.color) << name;
}

TEST(MeasuredColor, IsWhatASetShows)
{
    const MethodSetting setting{{0.3F, 0.04F}, nullptr, some_nodes()};
    const VisibilityNodes& nodes = setting.nodes;
    SetColors corrected, axes = colors_with(nodes.along_axes, 0);
    corrected.models = {ColorModel::mean, ColorModel::exponent};
    axes.axes = true;
    axes.axis_s = nodes.axis_cosine;
    axes.axis_t = nodes.axis_sine;
    for (unsigned seed = 0; seed < 10; ++seed) {
        const FootprintData data = some_footprint(seed);
        const auto texel_with = [&data](const auto& table) {
            SetTexel texel = data.set;
            texel.tau = 0;
            std::copy(table.begin(), table.end(), texel.visible.begin());
            return texel;
        };
        const auto expect = [&](const char* name, const auto& table, const SetColors& colors) {
            expect_shows(name, data, setting, texel_with(table), colors);
        };
        expect("linear, corrected", data.set.visible, corrected);
        expect("visibility 2x1", data.visible_2x1, colors_with(nodes.two, 0));
        expect("visibility 4x1", data.visible_4x1, colors_with(nodes.four, 0));
        expect("visibility 4x3", data.visible_4x3, colors_with(nodes.four, 1));
        expect("visibility 4x5", data.set.visible, colors_with(nodes.four, 2));
        expect("visibility 4 axes", data.visible_axes, axes);
    }
}

// Cosines by hand, of 15 and 75 degrees by those of a difference of 45 and 30; to rounding.
TEST(MeasuredColor, NodesAreWhereTheManifestsSay)
{
    const VisibilityNodes nodes =
        nodes_of({{30, 45, 60, 75}, 2, 8, {}}, {{15, 60, 75, 80}, 0, 8, -30.0});
    const float root_half = std::sqrt(0.5F), root_three = std::sqrt(3.0F);
    EXPECT_FLOAT_EQ(nodes.four[0], root_three / 2);
    EXPECT_FLOAT_EQ(nodes.four[1], root_half);
    EXPECT_FLOAT_EQ(nodes.four[2], 0.5F);
    EXPECT_FLOAT_EQ(nodes.four[3], root_half * (root_three - 1) / 2);
    EXPECT_EQ(nodes.two[0], nodes.four[1]);
    EXPECT_EQ(nodes.two[1], nodes.four[3]);
    EXPECT_FLOAT_EQ(nodes.along_axes[0], root_half * (root_three + 1) / 2);
    EXPECT_FLOAT_EQ(nodes.along_axes[1], 0.5F);
    EXPECT_EQ(nodes.along_axes[2], nodes.four[3]);
    EXPECT_FLOAT_EQ(nodes.along_axes[3], 0.173648178F);
    EXPECT_FLOAT_EQ(nodes.axis_cosine, root_three / 2);
    EXPECT_FLOAT_EQ(nodes.axis_sine, -0.5F);
}

} // namespace
} // namespace scree::test
