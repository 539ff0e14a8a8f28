#include "tables/brdf_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/direction_pairs.h"
#include "math/error.h"
#include "pipeline/bake.h"
#include "support/random_image.h"
#include "tables/effective_brdf.h"

namespace scree::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::vector<BrdfGrid> all_grids(std::array<int, 3> size)
{
    std::vector<BrdfGrid> all;
    for (const auto parametrization :
         {BrdfParametrization::half_difference, BrdfParametrization::orthographic,
          BrdfParametrization::hybrid})
        for (const auto spacing : {BrdfSpacing::even, BrdfSpacing::root, BrdfSpacing::angle})
            for (const bool fitted : {false, true})
                all.push_back({parametrization, size, spacing, fitted});
    return all;
}

std::string text(const BrdfGrid& grid)
{
    return name_of(grid.parametrization) + " " + std::to_string(static_cast<int>(grid.spacing)) +
           (grid.fitted ? " fitted" : "");
}

void no_progress(double /*share*/) {}

/// Where the last texels of the axes are not one point of the hemispheres: both directions above
/// the horizon, h off the normal, k not 0.
bool is_regular(const filter::Directions<double>& w)
{
    const auto c = filter::isotropic_coordinates(w);
    return std::min(w.wo.z, w.wi.z) > 1e-6 && c.h_bar > 1e-6 && c.k_bar > 1e-6;
}

TEST(BrdfGrid, NodesLieWhereTheirDirectionsAreLookedUp)
{
    for (const BrdfGrid& grid : all_grids({9, 8, 7})) {
        int checked = 0;
        for (int a = 0; a < 9; ++a)
            for (int b = 0; b < 8; ++b)
                for (int c = 0; c < 7; ++c) {
                    const auto w = grid.directions(a, b, c);
                    if (!is_regular(w))
                        continue;
                    ++checked;
                    const auto place = grid.place(w);
                    EXPECT_NEAR(place[0], a, 1e-9) << text(grid);
                    EXPECT_NEAR(place[1], b, 1e-9) << text(grid) << ' ' << a << ' ' << b;
                    EXPECT_NEAR(place[2], c, 1e-9) << text(grid);
                }
        // Whole axes waste nodes on what is below the horizon; fitted ones only have the edges.
        if (grid.fitted) {
            EXPECT_EQ(checked, 7 * 6 * 7) << text(grid);
        } else {
            EXPECT_GT(checked, 7 * 7 * 2) << text(grid);
        }
    }
}

// No node of a whole axis is wasted on directions that are not there: it repeats the last that is.
TEST(BrdfGrid, NodesBeyondTheReachRepeatItsEnd)
{
    constexpr int kCount = 12;
    for (const BrdfGrid& grid : all_grids({kCount, kCount, 5})) {
        if (grid.fitted || grid.parametrization != BrdfParametrization::hybrid)
            continue;
        const auto axes = grid.axes();
        int repeated = 0;
        for (int a = 1; a + 1 < kCount; ++a)
            for (int c = 0; c < 5; ++c) {
                const double h_bar = axes[0].coordinates[static_cast<size_t>(a)];
                const double azimuth = axes[2].coordinates[static_cast<size_t>(c)];
                const double reach = kernel::scree_hybrid_reach(h_bar, azimuth);
                const auto end =
                    filter::directions(filter::Hybrid<double>{h_bar, 0, reach, azimuth});
                for (int b = 0; b < kCount; ++b) {
                    if (axes[1].coordinates[static_cast<size_t>(b)] <= reach)
                        continue;
                    ++repeated;
                    const auto w = grid.directions(a, b, c);
                    EXPECT_LT((w.wi - end.wi).length() + (w.wo - end.wo).length(), 1e-9)
                        << text(grid);
                }
            }
        EXPECT_GT(repeated, 20) << text(grid);
    }
}

// Linear interpolation gives linear functions of the place back, up to float.
TEST(BrdfGrid, LookUpIsLinearBetweenNodes)
{
    for (const BrdfGrid& grid : all_grids({5, 6, 4})) {
        std::vector<float> values;
        for (int c = 0; c < 4; ++c)
            for (int b = 0; b < 6; ++b)
                for (int a = 0; a < 5; ++a) {
                    values.push_back(static_cast<float>(1 + 2 * a - 3 * b + 5 * c));
                    values.push_back(static_cast<float>(a * b * c));
                }
        for (const auto& [name, w] : direction_pairs()) {
            const auto [a, b, c] = grid.place(w);
            const auto found = look_up(grid, values, 2, w);
            EXPECT_NEAR(found[0], 1 + 2 * a - 3 * b + 5 * c, 1e-12) << text(grid) << name;
            EXPECT_NEAR(found[1], a * b * c, 1e-12) << text(grid) << name;
        }
    }
}

TEST(BrdfGrid, TheKernelFindsThePlaceInTheTableOfTheCommand)
{
    const BrdfGrid grid; // as the command makes it
    for (const auto& [name, w] : direction_pairs()) {
        const auto place = grid.place(w);
        const auto kernel = filter::hybrid_place(w);
        for (int axis = 0; axis < 3; ++axis) {
            const size_t i = static_cast<size_t>(axis);
            // Angles near 90 degrees by their sines.
            EXPECT_NEAR(kernel[axis] * (grid.size[i] - 1), place[i], 1e-6) << name << ' ' << axis;
        }
    }
}

// The coordinates, of directions that the kernel makes coordinates of: units and names by hand.
TEST(BrdfGrid, TheManifestSaysWhereTheNodesAre)
{
    for (const BrdfGrid& grid : all_grids({6, 5, 4})) {
        const bool angles = grid.parametrization == BrdfParametrization::half_difference;
        const bool flat = grid.parametrization == BrdfParametrization::orthographic;
        const auto axes = grid.axes();
        ASSERT_EQ(axes.size(), 3U);
        EXPECT_EQ(axes[0].unit, angles ? "radians" : "1") << text(grid);
        EXPECT_EQ(axes[1].unit, angles && !grid.fitted ? "radians" : "1") << text(grid);
        EXPECT_EQ(axes[2].unit, "radians");
        EXPECT_EQ(axes[1].name, std::string(angles ? "theta_d"
                                            : flat ? "|k_bar|"
                                                   : "|k|") +
                                    (grid.fitted ? " / reach" : ""));
        const double most = angles ? kPi / 2 : 1;
        const std::array<double, 3> ends = {most, grid.fitted ? 1 : most, kPi / 2};
        for (size_t axis = 0; axis < 3; ++axis) {
            const auto& at = axes[axis].coordinates;
            ASSERT_EQ(at.size(), static_cast<size_t>(grid.size[axis]));
            EXPECT_EQ(at.front(), 0) << text(grid);
            EXPECT_NEAR(at.back(), ends[axis], 1e-15) << text(grid);
        }
        int seen = 0;
        for (int a = 1; a < 5; ++a)
            for (int b = 1; b < 5; ++b)
                for (int c = 1; c < 3; ++c) {
                    const auto w = grid.directions(a, b, c);
                    if (!is_regular(w))
                        continue;
                    ++seen;
                    const auto got = filter::isotropic_coordinates(w);
                    const double first = angles ? got.theta_h : got.h_bar;
                    const double azimuth = angles ? got.phi_d : got.azimuth;
                    const double reach = angles
                                             ? kernel::scree_half_difference_reach(first, azimuth)
                                         : flat ? kernel::scree_orthographic_reach(first, azimuth)
                                                : kernel::scree_hybrid_reach(first, azimuth);
                    const double second = angles ? got.theta_d : flat ? got.k_bar : got.k;
                    EXPECT_NEAR(axes[0].coordinates[static_cast<size_t>(a)], first, 1e-9);
                    EXPECT_NEAR(axes[1].coordinates[static_cast<size_t>(b)],
                                grid.fitted ? second / reach : second, 1e-9)
                        << text(grid);
                    EXPECT_NEAR(axes[2].coordinates[static_cast<size_t>(c)], azimuth, 1e-9);
                }
        EXPECT_GT(seen, 4) << text(grid);
    }
}

TEST(BrdfTable, HoldsTheFunctionAtItsNodes)
{
    const auto brdf = [](const filter::Directions<double>& w) {
        return Rgbf{static_cast<float>(w.wo.z * w.wi.z), static_cast<float>(w.wo.z + w.wi.z), 1};
    };
    for (const BrdfGrid& grid : all_grids({5, 4, 3})) {
        double told = 0;
        const auto values = brdf_table(grid, brdf, [&](double share) { told = share; });
        EXPECT_EQ(told, 1);
        ASSERT_EQ(values.size(), 3 * grid.nodes());
        const auto w = grid.directions(2, 1, 1);
        const size_t node = 3 * ((1 * 4 + 1) * size_t{5} + 2);
        EXPECT_EQ(values[node], static_cast<float>(w.wo.z * w.wi.z)) << text(grid);
        EXPECT_EQ(values[node + 2], 1);
        const TableManifest manifest = brdf_manifest(grid);
        EXPECT_EQ(static_cast<size_t>(manifest.width()) * static_cast<size_t>(manifest.height()),
                  grid.nodes());
    }
}

// A smooth function of second order: halving the steps must leave a quarter of the error.
TEST(BrdfTable, ErrorFallsWithTheSquareOfTheStep)
{
    const auto brdf = [](const filter::Directions<double>& w) {
        const auto c = filter::isotropic_coordinates(w);
        const double value = std::exp(-2 * c.h_bar * c.h_bar) * (1 + c.k * c.k);
        return Rgbf{static_cast<float>(value), 0, 0};
    };
    for (const auto parametrization :
         {BrdfParametrization::half_difference, BrdfParametrization::orthographic,
          BrdfParametrization::hybrid}) {
        std::array<double, 2> rms{};
        for (const size_t fine : {0U, 1U}) {
            const int n = fine == 0 ? 9 : 17;
            const BrdfGrid grid{parametrization, {n, n, n}, BrdfSpacing::even, false};
            const auto values = brdf_table(grid, brdf, no_progress);
            int count = 0;
            for (const auto& [name, w] : direction_pairs()) {
                // Nodes beyond the horizon repeat its value, which is only of first order there.
                if (name != "random" || std::min(w.wo.z, w.wi.z) < 0.5)
                    continue;
                ++count;
                rms[fine] +=
                    std::pow(look_up(grid, values, 3, w)[0] - static_cast<double>(brdf(w)[0]), 2);
            }
            rms[fine] = std::sqrt(rms[fine] / count);
        }
        EXPECT_NEAR(rms[0] / rms[1], 4, 0.8) << name_of(parametrization);
    }
}

class EffectiveBrdfTest : public ::testing::Test {
protected:
    /// 16x16 heights, and colors of mean `color_`.
    void bake_heights(float low, float high)
    {
        write_image(temp_ / "h.exr", random_image(16, 16, {"Y"}, 5, low, high));
        const Image colors = random_image(16, 16, {"R", "G", "B"}, 6);
        write_image(temp_ / "c.exr", colors);
        for (size_t i = 0; i < colors.pixels.size(); ++i)
            color_[i % 3] += static_cast<double>(colors.pixels[i]) / 256;
        bake(options());
    }

    [[nodiscard]] BakeOptions options() const
    {
        BakeOptions options;
        options.height_file = temp_ / "h.exr";
        options.color_file = temp_ / "c.exr";
        options.output = temp_ / "set";
        options.height_scale = 0.5;
        options.texel_size = {{1, 1}};
        options.wrap_s = options.wrap_t = Wrap::periodic;
        options.pixel_type = PixelTypeChoice::float32;
        options.maps = {Map::color, Map::slope};
        return options;
    }

    TempFolder temp_;
    std::array<double, 3> color_{};
};

// Flat: a Lambertian of the mean color, 1e-5 of float; where Schlick's term is below 1e-7.
TEST_F(EffectiveBrdfTest, OfAFlatSurfaceIsItsColorOverPi)
{
    bake_heights(0.5F, 0.5F);
    for (const int level : {0, 2, 4}) {
        const EffectiveBrdf brdf(temp_ / "set", level, {0.3F, 0, 4});
        for (const auto& [name, w] : direction_pairs()) {
            if (name != "random" || std::min(w.wo.z, w.wi.z) < 0.02 || w.wo.dot(w.wi) < 0.9)
                continue;
            const Rgbf got = brdf(w);
            for (size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(static_cast<double>(got[c]) * kPi, color_[c], 1e-5) << level;
            if (level == 0)
                break; // 256 texels
        }
    }
}

TEST_F(EffectiveBrdfTest, IsReciprocalAndAllButIsotropic)
{
    bake_heights(0, 1);
    const EffectiveBrdf brdf(temp_ / "set", 2, {0.3F, 0.04F, 32});
    const filter::Directions<double> w{Imath::V3d(0.6, 0.1, 0.5).normalized(),
                                       Imath::V3d(-0.3, 0.7, 0.4).normalized()};
    const float here = brdf(w)[0];
    EXPECT_NEAR(brdf({w.wi, w.wo})[0], here, 1e-6F * here);
    // Up to 32 turns instead of all.
    const auto turned = [](const Imath::V3d& v) { return Imath::V3d(v.y, -v.x, v.z); };
    const auto mirrored = [](const Imath::V3d& v) { return Imath::V3d(v.x, -v.y, v.z); };
    EXPECT_NEAR(brdf({turned(w.wo), turned(w.wi)})[0], here, 1e-3F * here);
    EXPECT_NEAR(brdf({mirrored(w.wo), mirrored(w.wi)})[0], here, 1e-6F * here);
}

// A cosine of 0.01 counts as 0.02 one way; the other way, lit from above, a Lambertian stays one.
TEST_F(EffectiveBrdfTest, LightAtTheHorizonIsDividedByTheLeastCosine)
{
    bake_heights(0.5F, 0.5F);
    const EffectiveBrdf brdf(temp_ / "set", 4, {0.3F, 0, 4});
    const auto at = [](double z) { return Imath::V3d(std::sqrt(1 - z * z), 0, z); };
    EXPECT_NEAR(static_cast<double>(brdf({at(0.5), at(0.01)})[1]) * kPi, 0.75 * color_[1], 1e-4);
    EXPECT_NEAR(static_cast<double>(brdf({at(0.01), at(0.5)})[1]) * kPi, 0.75 * color_[1], 1e-4);
}

// A quarter of the heights is no data, and the colors there are those of the dark quarter beside
// it.
TEST_F(EffectiveBrdfTest, TexelsWithoutDataDoNotCount)
{
    bake_heights(0.5F, 0.5F);
    Image heights = random_image(16, 16, {"Y"}, 5, 0.5F, 0.5F);
    Image colors = random_image(16, 16, {"R", "G", "B"}, 6, 0.6F, 0.6F);
    for (size_t i = 0; i < heights.pixels.size(); ++i) {
        if (i % 16 < 4)
            heights.pixels[i] = std::numeric_limits<float>::quiet_NaN();
        if (i % 16 < 8)
            std::fill_n(colors.pixels.begin() + 3 * static_cast<std::ptrdiff_t>(i), 3, 0.2F);
    }
    write_image(temp_ / "h.exr", heights);
    write_image(temp_ / "c.exr", colors);
    bake(options());
    const Imath::V3d up(0, 0, 1);
    for (const int level : {1, 3}) {
        const EffectiveBrdf brdf(temp_ / "set", level, {0.3F, 0, 4});
        EXPECT_NEAR(static_cast<double>(brdf({up, up})[0]) * kPi, (0.2 + 2 * 0.6) / 3, 1e-5)
            << level;
    }
}

// A flat surface: its color over pi and a lobe times Schlick's term, which is 1 for f0 = 1.
TEST_F(EffectiveBrdfTest, FresnelGoesWithTheAngleFromTheHalfVector)
{
    bake_heights(0.5F, 0.5F);
    const EffectiveBrdf whole(temp_ / "set", 4, {0.3F, 1, 4});
    for (const float f0 : {0.0F, 0.04F}) {
        const EffectiveBrdf brdf(temp_ / "set", 4, {0.3F, f0, 4});
        for (const double theta_d : {0.2, 0.8, 1.2}) {
            const double sine = std::sin(theta_d), cosine = std::cos(theta_d);
            const filter::Directions<double> w{{sine, 0, cosine}, {-sine, 0, cosine}};
            const double lobe = static_cast<double>(whole(w)[0]) - color_[0] / kPi;
            const auto least = static_cast<double>(f0);
            const double schlick = least + (1 - least) * std::pow(1 - cosine, 5);
            EXPECT_NEAR(static_cast<double>(brdf(w)[0]), color_[0] / kPi + schlick * lobe,
                        1e-4 * lobe)
                << f0 << ' ' << theta_d;
        }
    }
}

TEST_F(EffectiveBrdfTest, ALevelThatIsNotThereIsAnError)
{
    bake_heights(0, 1);
    for (const int level : {-1, 5})
        EXPECT_THROW(EffectiveBrdf(temp_ / "set", level, {}), Error) << level;
}

} // namespace
} // namespace scree::test
