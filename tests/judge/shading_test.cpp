// How a set shows its colors: what each model makes of a texel.

#include "judge/shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scree::test {
namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180;

Vec3f toward(double angle_deg, double azimuth_deg)
{
    const double angle = angle_deg * kRadPerDegree, azimuth = azimuth_deg * kRadPerDegree;
    return Vec3f(Vec3(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                      std::cos(angle)));
}

/// A level rough texel whose color goes with height and with slope.
SetTexel rough_texel()
{
    SetTexel texel;
    texel.color = {0.5F, 0.25F, 0.125F};
    texel.slope = {0, 0.125F, 0.03125F, 0, 0.25F};
    texel.h = 0.5F;
    texel.hh = 1.25F; // sigma 1
    texel.color_height = {0.35F, 0.125F, 0.025F};
    texel.color_s = {0.01F, 0.02F, 0.03F};
    texel.color_t = {0.02F, -0.01F, 0.01F};
    return texel;
}

SetColors with_nodes(const std::vector<double>& angles_deg, int harmonics)
{
    SetColors colors;
    colors.models = {ColorModel::mean, ColorModel::visible};
    for (const double angle : angles_deg)
        colors.node_cosines.push_back(static_cast<float>(std::cos(angle * kRadPerDegree)));
    colors.harmonics = harmonics;
    return colors;
}

// By hand: at a node the table itself, halfway in tan theta half of it. Channels A B G R of the
// mean, then of cos phi, then of sin phi.
TEST(Shading, TablesTellTheColorOfAView)
{
    SetTexel texel = rough_texel();
    const float table[] = {-0.25F, 0.01F, 0.02F, -0.05F, 0.125F, 0, 0, 0.02F, 0, 0.03F, 0, 0};
    std::copy(std::begin(table), std::end(table), texel.visible.begin());
    const SetColors colors = with_nodes({60}, 1);
    const double half_deg = std::atan(std::tan(60 * kRadPerDegree) / 2) / kRadPerDegree;
    struct {
        Vec3f wo;
        double a, red, green, blue; // a and beta
    } const cases[] = {{toward(60, 0), -0.125, -0.03, 0.02, 0.01},
                       {toward(60, 90), -0.25, -0.05, 0.02, 0.04},
                       {toward(80, 180), -0.375, -0.07, 0.02, 0.01}, // beyond the node
                       {toward(half_deg, 0), -0.0625, -0.015, 0.01, 0.005},
                       {{0, 0, 1}, 0, 0, 0, 0}};
    for (const auto& want : cases) {
        const Rgbf got = visible_color(texel, colors, ColorModel::visible, want.wo);
        // Rounding of single precision.
        EXPECT_NEAR(got[0], (0.5 + want.red) / (1 + want.a), 1e-6);
        EXPECT_NEAR(got[1], (0.25 + want.green) / (1 + want.a), 1e-6);
        EXPECT_NEAR(got[2], (0.125 + want.blue) / (1 + want.a), 1e-6);
    }
}

TEST(Shading, TablesTellOfViewAndLightAlike)
{
    SetTexel texel = rough_texel();
    const float table[] = {-0.25F, 0.01F, 0.02F, -0.2F, 0.125F, 0, 0, 0.02F, 0, 0.03F, 0, 0};
    std::copy(std::begin(table), std::end(table), texel.visible.begin());
    const SetColors colors = with_nodes({60}, 1);
    const Vec3f wo = toward(60, 90), wi = toward(40, 200), up(0, 0, 1);
    const Rgbf seen = visible_color(texel, colors, ColorModel::visible, wo);
    const auto lit = [&](const Vec3f& view, const Vec3f& light) {
        return lit_color(texel, colors, ColorModel::visible, view, light);
    };
    const Rgbf both = lit(wo, wi), exchanged = lit(wi, wo), from_above = lit(wo, up);
    for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(from_above[c], seen[c], 1e-6) << "light from above hides nothing";
        EXPECT_NEAR(both[c], exchanged[c], 1e-6);
        EXPECT_GT(std::abs(both[c] - seen[c]), 1e-3F) << "the light hides nothing of it";
    }
    // What a set shows is that color.
    const Material material;
    EXPECT_EQ(set_radiance(texel, colors, material, wo, wi),
              radiance(slopes_of(texel), both, material, wo, wi));
}

// Of a level texel whose slopes lie about 0 Smith's Lambda is that of the raw moments: an exponent
// of gain 1, power 1, threshold 0 is Smith's, and a gain is as much more of Lambda.
TEST(Shading, TheMeasuredExponentTakesLambdasPlace)
{
    SetTexel texel = rough_texel();
    const SetColors colors;
    const Vec3f wo = toward(70, 20), wi = toward(60, 200);
    const auto lambda = [&texel](const Vec3f& w) {
        return filter::masking(w, slopes_of(texel)).lambda;
    };
    const auto line = [&](float exponent) {
        return color_of_exponent(texel, colors, ColorModel::height, false, wo, exponent);
    };
    const auto expect_equal = [](const Rgbf& got, const Rgbf& want) {
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], want[c], 1e-6);
    };
    const auto seen = [&] { return visible_color(texel, colors, ColorModel::exponent, wo); };
    const auto lit = [&] { return lit_color(texel, colors, ColorModel::exponent, wo, wi); };
    expect_equal(seen(), line(lambda(wo)));
    expect_equal(lit(), line(lambda(wo) + lambda(wi)));
    EXPECT_GT(std::abs(lit()[0] - seen()[0]), 1e-3F);

    texel.exponent = {3, 2, 0.0625F};
    const auto corrected = [&](const Vec3f& w) {
        return 3 * std::pow(std::max(lambda(w) - 0.0625F, 0.0F), 2.0F);
    };
    ASSERT_GT(corrected(wo), 0);
    expect_equal(seen(), line(corrected(wo)));
    expect_equal(lit(), line(corrected(wo) + corrected(wi)));
    EXPECT_GT(std::abs(seen()[0] - line(lambda(wo))[0]), 1e-3F);

    texel.exponent = {0, 1, 0};
    expect_equal(seen(), texel.color);
}

// On a tilted texel the exponent goes by the slopes about the texture plane, not about their mean.
TEST(Shading, TheMeasuredExponentGoesByTheSlopesAboutTheTexturePlane)
{
    SetTexel level = rough_texel(), tilted = level;
    tilted.slope.s = 0.25F;
    const Vec3f wo = toward(70, 20);
    const auto seen = [&wo](const SetTexel& texel, ColorModel model) {
        return visible_color(texel, {}, model, wo);
    };
    EXPECT_EQ(seen(level, ColorModel::exponent), seen(tilted, ColorModel::exponent));
    EXPECT_NE(seen(level, ColorModel::height), seen(tilted, ColorModel::height));
}

TEST(Shading, MeasuredVisibilityHasTheCorrelationWithSlopeAlready)
{
    SetColors colors = with_nodes({60}, 0);
    colors.has_slope = true;
    EXPECT_FALSE(colors.adds_slope(ColorModel::visible));
    EXPECT_TRUE(colors.adds_slope(ColorModel::exponent));
    const SetTexel texel = rough_texel(); // its tables are 0: nothing is hidden
    EXPECT_EQ(visible_color(texel, colors, ColorModel::visible, toward(80, 10)), texel.color);
    EXPECT_NE(visible_color(texel, colors, ColorModel::mean, toward(80, 10)), texel.color);
}

} // namespace
} // namespace scree::test
