// Visible color where the answer is known in closed form.

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>

#include <cmath>

#include "kernel/filter.h"

namespace scree::test {
namespace {

using Imath::V2d;
using Imath::V3d;
using Imath::V3f;

const double kExponents[] = {0, 0.3, 1, 2.7, 8, 100, 1e4, 1e6};

// c = 0.5 + 0.1 (h - mean): a line in the height, so the mean color is the color of the mean.
TEST(ColorByHeight, OfALineIsTheLineAtTheVisibleHeight)
{
    const double h = 0.4, sigma = 0.7, slope = 0.1;
    const double noise = (h * h + sigma * sigma) / 1024 / (sigma * sigma);
    const double fading = 1 / (1 + noise * noise); // 2e-6 less than 1 here
    const V3d color(0.5, 0.6, 0.9);
    V3d with_height;
    for (int i = 0; i < 3; ++i)
        with_height[i] = color[i] * h + slope * (i + 1) * sigma * sigma;
    for (const double exponent : kExponents) {
        const auto visible = filter::visible_height(exponent);
        const V3d got =
            filter::color_by_height(color, with_height, h, h * h + sigma * sigma, visible);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(got[i], color[i] + slope * (i + 1) * sigma * visible.mean * fading, 1e-12)
                << "exponent " << exponent;
    }
}

TEST(ColorByHeight, WithoutSpreadOrCorrelationIsTheMeanColor)
{
    const V3f color(0.2F, 0.3F, 0.4F);
    const auto visible = filter::visible_height(1e6F);
    EXPECT_EQ(filter::color_by_height(color, color * 2.0F, 2.0F, 4.0F, visible), color);
    EXPECT_EQ(filter::color_by_height(color, V3f(0), 0.0F, 0.0F, visible), color);
    EXPECT_EQ(filter::color_by_height(color, color * 0.5F, 0.5F, 1.0F, visible), color);
}

TEST(ColorByHeight, IsNeverNegative)
{
    const V3f got =
        filter::color_by_height(V3f(0.1F), V3f(-0.5F), 0.0F, 1.0F, filter::visible_height(1e6F));
    EXPECT_EQ(got, V3f(0));
}

/// a_n = (2 n + 1) E[c P_n(2 q - 1)] of a color given by rank.
template <typename Color>
double coefficient(int n, Color color)
{
    return (2 * n + 1) *
           boost::math::quadrature::gauss<double, 30>::integrate(
               [&](double q) { return color(q) * boost::math::legendre_p(n, 2 * q - 1); }, 0.0,
               1.0);
}

// The weight of the rank q is (L + 1) q^L, so q^k shows as (L + 1) / (L + 1 + k).
TEST(ColorByRank, OfAPolynomialOfTheRankIsExact)
{
    for (int power = 0; power <= 8; ++power) {
        const auto color = [&](double q) { return std::pow(q, power); };
        V3d a[8];
        for (int n = 1; n <= 8; ++n)
            a[n - 1] = V3d(coefficient(n, color));
        for (const double exponent : kExponents)
            EXPECT_NEAR(filter::color_by_rank(V3d(coefficient(0, color)), a, 8, exponent)[1],
                        (exponent + 1) / (exponent + 1 + power), 1e-11)
                << "power " << power << " exponent " << exponent;
    }
}

TEST(ColorByRank, UsesTheCoefficientsItIsGiven)
{
    const V3d a[2] = {V3d(0.2, 0, 0), V3d(0, 0.1, 0)};
    const V3d one = filter::color_by_rank(V3d(0.5), a, 1, 3.0);
    const V3d two = filter::color_by_rank(V3d(0.5), a, 2, 3.0);
    EXPECT_NEAR(one[0], 0.5 + 0.2 * 3 / 5, 1e-15);
    EXPECT_EQ(one[1], 0.5);
    EXPECT_NEAR(two[1], 0.5 + 0.1 * (3.0 / 5) * (2.0 / 6), 1e-15);
    EXPECT_EQ(filter::color_by_rank(V3d(0.5), a, 2, 0.0), V3d(0.5));
}

// c = c0 + r . slope: visible is c0 + r . m_vis, whatever the covariance, grooves included.
TEST(ColorBySlope, OfALinearColorIsTheColorOfTheVisibleMeanSlope)
{
    const V2d r(0.2, -0.1);
    const V3d c0(0.5, 0.5, 0.5);
    const filter::Covariance<double> covariances[] = {
        {0.09, 0, 0.09}, {0.2, 0.1, 0.3}, {0.25, 0, 0}, {0.25, -0.25, 0.25}, {0.25, 0.2, 0.17}};
    for (const auto& covariance : covariances)
        for (const double tau : {0.0, 0.5, 1.0})
            for (const double theta : {0.0, 0.4, 1.2, 1.5})
                for (const double phi : {0.0, 1.0, -2.0}) {
                    filter::Slopes<double> slopes;
                    slopes.mean = {0.1, -0.2};
                    slopes.covariance = covariance;
                    slopes.tau = tau;
                    const V3d w(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                std::cos(theta));
                    if (w.z - w.x * slopes.mean.x - w.y * slopes.mean.y <= 0)
                        continue;
                    const auto& [ss, st, tt] = covariance;
                    const double mean = c0[0] + (r ^ slopes.mean);
                    const V3d color(mean);
                    const V3d cs(mean * slopes.mean.x + r.x * ss + r.y * st);
                    const V3d ct(mean * slopes.mean.y + r.x * st + r.y * tt);
                    const V2d visible = filter::visible_slopes(w, slopes).mean;
                    // 1e-8: the fade-out of spreads below 1e-4 of the largest
                    EXPECT_NEAR(filter::color_by_slope(color, cs, ct, w, slopes)[0],
                                c0[0] + (r ^ visible), 3e-8)
                        << "tau " << tau << " theta " << theta << " phi " << phi << " covariance "
                        << ss << ' ' << st << ' ' << tt;
                }
}

TEST(ColorBySlope, RoundingAlongAGrooveDoesNotShow)
{
    // Seen along the groove: no spread there but for rounding, and a mean plane turned away.
    filter::Slopes<float> slopes;
    slopes.mean = {0.1F, 0.1F};
    slopes.covariance = {0.25F, 0, 0};
    const V3f w(-4.37e-8F, 0.99978F, 0.0208F), color(0.5F), noise(0.05F + 1e-8F);
    const V3f got = filter::color_by_slope(color, noise, noise, w, slopes);
    EXPECT_NEAR(got[0], 0.5F, 1e-3F);
}

TEST(ColorMap, CoordinatesAreTexelCentres)
{
    const filter::ColorMapTable<double> table{-1, 3, 2, 5, 3};
    const auto at = [&](double mean, double deviation) {
        return filter::color_map_coordinates(mean, deviation, table);
    };
    EXPECT_NEAR(at(-1, 0).x, 0.5 / 5, 1e-15);
    EXPECT_NEAR(at(-1, 0).y, 0.5 / 3, 1e-15);
    EXPECT_NEAR(at(3, 2).x, 4.5 / 5, 1e-15);
    EXPECT_NEAR(at(3, 2).y, 2.5 / 3, 1e-15);
    EXPECT_NEAR(at(1, 0.5).x, 0.5, 1e-15);
    EXPECT_NEAR(at(1, 0.5).y, 0.5, 1e-15) << "rows are roots: half way is a quarter of the widest";
    EXPECT_EQ(at(-9, -1), at(-1, 0)) << "beyond the range: its border";
    EXPECT_EQ(at(9, 9), at(3, 2));
    const filter::ColorMapTable<double> point{1, 1, 0, 1, 1};
    EXPECT_EQ(filter::color_map_coordinates(7.0, 7.0, point), V2d(0.5, 0.5));
}

TEST(SlopeAlong, IsTheProjectionOfTheCovariance)
{
    const filter::Covariance<double> covariance{0.2, 0.1, 0.3};
    for (double angle = 0; angle < 6.3; angle += 0.3) {
        const V2d d(std::cos(angle), std::sin(angle));
        const auto got = filter::slope_along(d, V2d(0.3, -0.4), covariance);
        EXPECT_NEAR(got.mean, 0.3 * d.x - 0.4 * d.y, 1e-15);
        EXPECT_NEAR(got.deviation * got.deviation,
                    0.2 * d.x * d.x + 0.2 * d.x * d.y + 0.3 * d.y * d.y, 1e-15);
    }
}

} // namespace
} // namespace scree::test
