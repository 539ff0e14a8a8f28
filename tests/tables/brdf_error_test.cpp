#include "tables/brdf_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tables/measured_brdf.h"

namespace scree::test {
namespace {

using filter::Directions;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadPerDegree = kPi / 180;

void no_progress(double /*share*/) {}

Rgbf white(const Directions<double>& /*w*/) { return {1, 1, 1}; }

TEST(BrdfRegions, AreWhatTheyAreCalled)
{
    const auto regions = brdf_regions(500);
    ASSERT_EQ(regions.size(), 4U);
    for (const BrdfRegion& region : regions) {
        ASSERT_EQ(region.pairs.size(), 500U);
        for (const auto& w : region.pairs) {
            const Imath::V3d h = (w.wo + w.wi).normalized();
            ASSERT_GE(std::min(w.wo.z, w.wi.z), std::cos(87.2 * kRadPerDegree));
            if (region.name == "specular") {
                ASSERT_GT(h.z, std::cos(20.01 * kRadPerDegree));
            } else if (region.name == "Fresnel") {
                ASSERT_LT(h.dot(w.wi), std::cos(59.99 * kRadPerDegree));
            } else if (region.name == "grazing") {
                ASSERT_LT(std::min(w.wo.z, w.wi.z), std::cos(74.99 * kRadPerDegree));
            }
        }
    }
}

// Both directions even over the hemisphere: mean cosine 1/2 (from 0.05: 0.525), mean of its square
// (0.35 of both), to what 4000 pairs tell.
TEST(BrdfRegions, AllIsEvenOverSolidAngles)
{
    const auto pairs = brdf_regions(4000)[0].pairs;
    double first = 0, second = 0;
    for (const auto& w : pairs) {
        first += (w.wo.z + w.wi.z) / 2;
        second += (w.wo.z * w.wo.z + w.wi.z * w.wi.z) / 2;
    }
    const double n = static_cast<double>(pairs.size());
    EXPECT_NEAR(first / n, 0.525, 0.01);
    EXPECT_NEAR(second / n, (1 - std::pow(0.05, 3)) / 3 / 0.95, 0.01);
}

// An azimuth of the surface that is left, or which of the two is the light, makes no difference.
TEST(RegionValues, AreOfTheIsotropicPairTimesTheCosine)
{
    const auto regions = brdf_regions(100);
    const auto brdf = [](const Directions<double>& w) {
        const Imath::V3d h = w.wo + w.wi;
        return Rgbf{static_cast<float>(h.y), static_cast<float>(w.wo.z + w.wi.z),
                    w.wi.x - w.wo.x > -1e-9 ? 1.0F : 0.0F};
    };
    const RegionValues values = region_values(brdf, regions, no_progress);
    for (size_t i = 0; i < 100; ++i) {
        const auto& w = regions[0].pairs[i];
        const auto wi = static_cast<float>(w.wi.z);
        EXPECT_NEAR(values[0][i][0], 0, 1e-6F);
        EXPECT_NEAR(values[0][i][1], static_cast<float>(w.wo.z + w.wi.z) * wi, 1e-5F);
        EXPECT_EQ(values[0][i][2], wi);
    }
}

// One color off by a tenth: sqrt(0.01 / 3).
TEST(RelativeErrors, AreOfAllColorsTogether)
{
    const auto regions = brdf_regions(50);
    const auto off = [](const Directions<double>& /*w*/) { return Rgbf{1, 1.1F, 1}; };
    const auto errors = relative_errors(region_values(off, regions, no_progress),
                                        region_values(white, regions, no_progress));
    ASSERT_EQ(errors.size(), regions.size());
    for (const double error : errors)
        EXPECT_NEAR(error, std::sqrt(0.01 / 3), 1e-6);
}

TEST(RelativeErrors, OfATableAreThoseOfItsInterpolation)
{
    const auto regions = brdf_regions(200);
    const BrdfGrid grid{BrdfParametrization::half_difference, {3, 3, 3}, BrdfSpacing::even, false};
    // Linear in theta_d is exact; its square is off by up to a quarter of the step's square.
    const double step = kPi / 4;
    for (const bool square : {false, true}) {
        const auto brdf = [square](const Directions<double>& w) {
            const double d = filter::isotropic_coordinates(w).theta_d;
            const auto value = static_cast<float>(square ? d * d : d);
            return Rgbf{value, value, value};
        };
        const auto table = brdf_table(grid, brdf, no_progress);
        const RegionValues truth = region_values(brdf, regions, no_progress);
        const RegionValues found = region_values(grid, table, regions);
        double worst = 0;
        for (size_t i = 0; i < 200; ++i) {
            const auto& w = regions[0].pairs[i];
            // Nodes beyond the horizon repeat its value.
            if (std::min(w.wo.z, w.wi.z) > 0.8)
                worst =
                    std::max(worst, static_cast<double>(found[0][i][0] - truth[0][i][0]) / w.wi.z);
        }
        EXPECT_LE(worst, square ? step * step / 4 : 1e-6);
        EXPECT_GE(worst, square ? step * step / 8 : 0);
    }
}

TEST(MeasuredBrdf, TellsErrorsOfThreeAndTheNoise)
{
    const BrdfGrid grid{BrdfParametrization::orthographic, {4, 4, 3}};
    const auto brighter = [](const Directions<double>& /*w*/) { return Rgbf{1.2F, 1.2F, 1.2F}; };
    double told = 0;
    const auto progress = [&told](double share) {
        EXPECT_GE(share, told);
        told = share;
    };
    const MeasuredBrdf made = measured_brdf(grid, {white, brighter}, true, progress);
    EXPECT_EQ(told, 1);
    EXPECT_EQ(made.values, brdf_table(grid, white, no_progress));
    ASSERT_EQ(made.figures.size(), 16U);
    EXPECT_EQ(made.figures[0].name, "rms error in %, orthographic, all");
    EXPECT_EQ(made.figures[4].name, "rms error in %, hybrid, all");
    EXPECT_EQ(made.figures[11].name, "rms error in %, half-difference, grazing");
    EXPECT_EQ(made.figures[15].name, "rms noise in %, grazing");
    for (size_t i = 0; i < 12; ++i)
        EXPECT_LT(made.figures[i].value, 1e-4);
    for (size_t i = 12; i < 16; ++i)
        EXPECT_NEAR(made.figures[i].value, 20 / std::sqrt(2), 1e-4);
    EXPECT_EQ(measured_brdf(grid, {white, {}}, false, no_progress).figures.size(), 4U);
}

} // namespace
} // namespace scree::test
