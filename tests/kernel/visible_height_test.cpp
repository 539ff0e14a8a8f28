// Mean and variance of the visible height of Gaussian heights.

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/erf.hpp>

#include <cmath>

#include "kernel/filter.h"

namespace scree::test {
namespace {

using boost::math::quadrature::gauss_kronrod;

double log_normal_cdf(double x)
{
    return x < 0 ? std::log(boost::math::erfc(-x / std::sqrt(2.0)) / 2)
                 : std::log1p(-boost::math::erfc(x / std::sqrt(2.0)) / 2);
}

/// Moment about `from` of the density proportional to phi Phi^L, by quadrature.
double moment(double exponent, int power, double from)
{
    const auto weight = [&](double x) {
        return (1 + exponent) * std::exp(-x * x / 2 + exponent * log_normal_cdf(x)) /
               std::sqrt(2 * std::acos(-1.0)) * std::pow(x - from, power);
    };
    double sum = 0;
    for (double x = -12; x < 12; x += 0.5)
        sum += gauss_kronrod<double, 31>::integrate(weight, x, x + 0.5, 0);
    return sum;
}

TEST(VisibleHeight, MomentsMatchTheirIntegrals)
{
    for (double exponent = 1e-3; exponent <= 1e6; exponent *= 1.5) {
        const double mean = moment(exponent, 1, 0), variance = moment(exponent, 2, mean);
        const auto got = filter::visible_height(exponent);
        EXPECT_NEAR(got.mean / mean, 1, 1e-6) << "exponent " << exponent;
        EXPECT_NEAR(got.variance / variance, 1, 2e-6) << "exponent " << exponent;
        const auto single = filter::visible_height(static_cast<float>(exponent));
        EXPECT_NEAR(static_cast<double>(single.mean) / mean, 1, 2e-6) << "exponent " << exponent;
        EXPECT_NEAR(static_cast<double>(single.variance) / variance, 1, 3e-6)
            << "exponent " << exponent;
    }
}

// The largest of two normal numbers.
TEST(VisibleHeight, OneMoreNumberThanTheExponent)
{
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(filter::visible_height(1.0).mean, 1 / std::sqrt(pi), 1e-6);
    EXPECT_NEAR(filter::visible_height(1.0).variance, 1 - 1 / pi, 2e-6);
    EXPECT_NEAR(filter::visible_height(2.0).mean, 1.5 / std::sqrt(pi), 2e-6);
}

TEST(VisibleHeight, SeenFromAboveItIsTheHeight)
{
    EXPECT_EQ(filter::visible_height(0.0).mean, 0);
    EXPECT_EQ(filter::visible_height(0.0).variance, 1);
    EXPECT_EQ(filter::visible_height(0.0F).mean, 0);
    EXPECT_EQ(filter::visible_height(0.0F).variance, 1);
    // For small exponents the mean is exponent times mu'(0) = 0.9032.
    EXPECT_NEAR(filter::visible_height(1e-6F).mean, 1e-6F * 0.90320F, 1e-11F);
}

TEST(VisibleHeight, BeyondItsRangeItStaysAtTheEnd)
{
    for (const float exponent : {1e6F, 1e7F, 1e30F}) {
        EXPECT_NEAR(filter::visible_height(exponent).mean, 4.8629F, 1e-4F);
        EXPECT_NEAR(filter::visible_height(exponent).variance, 0.0615063F, 1e-6F);
    }
    EXPECT_EQ(filter::visible_height(-1.0F).mean, 0);
}

} // namespace
} // namespace scree::test
