#include "failures/plain_code.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace scree::test {
namespace {

using Integral = boost::math::quadrature::gauss_kronrod<double, 61>;

double density(double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::acos(-1.0)); }

double weighted_by_powers(const std::vector<HeightColor>& rising, double exponent, bool at)
{
    const auto power = static_cast<float>(exponent);
    float below = 0, colors = 0, weights = 0;
    for (const HeightColor& step : rising) {
        const auto share = static_cast<float>(step.share);
        const float weight = share * std::pow(at ? below + share : below, power);
        colors += weight * static_cast<float>(step.color);
        weights += weight;
        below += share;
    }
    return static_cast<double>(colors / weights);
}

} // namespace

double plain_lambda(double cot, double mean, double sigma)
{
    const double v = (cot - mean) / (sigma * std::sqrt(2.0));
    const double root_pi = std::sqrt(std::acos(-1.0));
    return (std::exp(-v * v) - v * root_pi * std::erfc(v)) / (2 * v * root_pi);
}

double plain_g1(double cot, double mean, double sigma)
{
    return 1 / (1 + plain_lambda(cot, mean, sigma));
}

double walter_g1(double cot, double mean, double sigma)
{
    const double a = (cot - mean) / (sigma * std::sqrt(2.0));
    return a < 1.6 ? (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a) : 1;
}

double lambda_by_quadrature(double z)
{
    return Integral::integrate([=](double x) { return (x - z) * density(x); }, z, z + 12) / z;
}

double visible_height_by_quadrature(double exponent)
{
    const auto weight = [=](double x) {
        // log1p: Phi is 1 to rounding where it counts
        return density(x) * std::exp(exponent * std::log1p(-std::erfc(x / std::sqrt(2.0)) / 2));
    };
    double mean = 0, total = 0;
    for (int piece = -12; piece < 12; ++piece) {
        mean += Integral::integrate([&](double x) { return x * weight(x); }, piece, piece + 1);
        total += Integral::integrate(weight, piece, piece + 1);
    }
    return mean / total;
}

double visible_height_by_samples(double exponent)
{
    constexpr int kSamples = 64;
    float mean = 0, total = 0;
    for (int i = 0; i < kSamples; ++i) {
        const float x = -3 + 6 * (static_cast<float>(i) + 0.5F) / kSamples;
        const float below = 1 - std::erfc(x / std::sqrt(2.0F)) / 2;
        const float weight = std::exp(-x * x / 2) * std::pow(below, static_cast<float>(exponent));
        mean += x * weight;
        total += weight;
    }
    return static_cast<double>(mean / total);
}

double visible_variance_by_quadrature(double z)
{
    const double end = 60 / -z; // exp(-60) is left
    const auto moment = [&](int n) {
        return Integral::integrate(
            [&](double u) { return std::pow(u, 1 + n) * std::exp(z * u - u * u / 2); }, 0.0, end);
    };
    const double mean = moment(1) / moment(0);
    return moment(2) / moment(0) - mean * mean;
}

double color_by_definition(const std::vector<HeightColor>& rising, double exponent)
{
    double below = 0, color = 0;
    for (const HeightColor& step : rising) {
        const double at = std::min(below + step.share, 1.0);
        color += step.color * (std::pow(at, 1 + exponent) - std::pow(below, 1 + exponent));
        below = at;
    }
    return color;
}

double color_at_or_below(const std::vector<HeightColor>& rising, double exponent)
{
    return weighted_by_powers(rising, exponent, true);
}

double color_below(const std::vector<HeightColor>& rising, double exponent)
{
    return weighted_by_powers(rising, exponent, false);
}

double variance_by_float_sums(const MemorySource& map)
{
    float sum = 0, squares = 0;
    for (const auto& slope : map.slopes) {
        const auto s = static_cast<float>(slope[0]);
        sum += s;
        squares += s * s;
    }
    const auto count = static_cast<float>(map.slopes.size());
    const float mean = sum / count;
    return static_cast<double>(squares / count - mean * mean);
}

std::vector<HeightColor> by_rising_height(std::vector<std::pair<double, double>> texels)
{
    std::sort(texels.begin(), texels.end());
    const double share = 1.0 / static_cast<double>(texels.size());
    std::vector<HeightColor> rising;
    for (size_t first = 0, end = 0; first < texels.size(); first = end) {
        double colors = 0;
        for (end = first; end < texels.size() && texels[end].first == texels[first].first; ++end)
            colors += texels[end].second;
        const auto count = static_cast<double>(end - first);
        rising.push_back({count * share, colors / count});
    }
    return rising;
}

} // namespace scree::test
