#include "color/maps.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/erf.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/files.h"
#include "texset/color_map_file.h"

namespace scree::test {

using boost::math::quadrature::gauss_kronrod;

namespace {

constexpr Rgb kTop = {1, 0.5, -2};
const double kPi = std::acos(-1.0);

Rgb sum(const Rgb& a, const Rgb& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// Ends of pieces: knots inside, and no piece longer than a step.
std::vector<double> pieces(const ColorMap& map, double low, double high, double step)
{
    std::vector<double> ends = {low};
    std::vector<double> stops = {high};
    for (const Knot& k : map.knots())
        if (k.x > low && k.x < high)
            stops.push_back(k.x);
    std::sort(stops.begin(), stops.end());
    for (const double stop : stops) {
        const double from = ends.back(), parts = std::ceil((stop - from) / step);
        for (double i = 1; i < parts; ++i)
            ends.push_back(from + (stop - from) * i / parts);
        if (stop > from)
            ends.push_back(stop);
    }
    return ends;
}

/// log of the normal distribution function.
double log_cdf(double z)
{
    const double q = boost::math::erfc(std::abs(z) / std::sqrt(2.0)) / 2;
    return z < 0 ? std::log(q) : std::log1p(-q);
}

} // namespace

ColorMap step_map(double x) { return ColorMap({{x, {}}, {x, kTop}}); }

ColorMap ramp_map(double a, double b) { return ColorMap({{a, {}}, {b, kTop}}); }

ColorMap hat_map(double a, double b, double c) { return ColorMap({{a, {}}, {b, kTop}, {c, {}}}); }

ColorMap random_map(unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> xs = {0, 1};
    while (xs.size() < 24) {
        const double x = uniform(random), kind = uniform(random);
        xs.push_back(x);
        if (kind < 0.2)
            xs.push_back(x); // a jump
        else if (kind < 0.3)
            xs.push_back(std::min(x + 1e-9, 1.0));
    }
    std::sort(xs.begin(), xs.end());
    std::vector<Knot> knots;
    for (const double x : xs) {
        const bool flat = uniform(random) < 0.2 && !knots.empty();
        knots.push_back({x, flat ? knots.back().color
                                 : Rgb{uniform(random), uniform(random), uniform(random) - 0.5}});
    }
    return ColorMap(knots);
}

std::vector<NamedMap> real_maps()
{
    std::vector<NamedMap> maps;
    const auto folder = data_folder() / "colormaps";
    for (const char* file : {"cpt/batlow.cpt",
                             "cpt/cmocean/topo.cpt",
                             "cpt/etopo1.cpt",
                             "cpt/geo.cpt",
                             "cpt/gray.cpt",
                             "cpt/oleron.cpt",
                             "cpt/sealand.cpt",
                             "image/cmap-turbo.tif",
                             "image/cmap-viridis.tif",
                             "image/cmap_divergent.png",
                             "image/cmap_hot.png",
                             "lut/cpf.spi1d",
                             "lut/houdini.lut",
                             "lut/iridas_1d.cube",
                             "lut/lut1d_1.spi1d",
                             "lut/lut1d_32f_example.clf",
                             "lut/lut1d_4.spi1d",
                             "lut/lut1d_example.clf",
                             "lut/nuke-default/rec709.spi1d",
                             "lut/sRGB_to_linear.spi1d"})
        if (!data_folder().empty())
            maps.push_back({file, read_color_map(folder / file).map});
    return maps;
}

Rgb color_by_definition(const std::vector<Knot>& knots, double x)
{
    if (x < knots.front().x)
        return knots.front().color;
    size_t i = knots.size() - 1; // the last knot not above x
    while (knots[i].x > x)
        --i;
    if (i + 1 == knots.size())
        return knots[i].color;
    const Knot &a = knots[i], &b = knots[i + 1];
    const double to_b = (x - a.x) / (b.x - a.x), to_a = (b.x - x) / (b.x - a.x);
    return {a.color[0] * to_a + b.color[0] * to_b, a.color[1] * to_a + b.color[1] * to_b,
            a.color[2] * to_a + b.color[2] * to_b};
}

Rgb average_by_quadrature(const ColorMap& map, double low, double high, double step,
                          const std::function<double(double)>& density)
{
    const std::vector<double> ends = pieces(map, low, high, step);
    const auto& knots = map.knots();
    Rgb total{};
    for (size_t i = 1; i < ends.size(); ++i) {
        const double a = ends[i - 1], b = ends[i];
        const double middle = a + (b - a) / 2;
        // No knot inside: the piece is a line through the middle.
        const Rgb center = color_by_definition(knots, middle);
        const double off = (b - a) / 4;
        const Rgb beside = color_by_definition(knots, middle + off);
        const double mass = gauss_kronrod<double, 15>::integrate(density, a, b, 0);
        const double moment = gauss_kronrod<double, 15>::integrate(
            [&](double x) { return density(x) * (x - middle); }, a, b, 0);
        for (size_t c = 0; c < 3; ++c)
            total[c] += center[c] * mass + (off > 0 ? (beside[c] - center[c]) / off * moment : 0);
    }
    return total;
}

Rgb normal_by_quadrature(const ColorMap& map, double mean, double deviation)
{
    return average_by_quadrature(map, mean - 10 * deviation, mean + 10 * deviation, deviation / 2,
                                 [&](double x) {
                                     const double z = (x - mean) / deviation;
                                     return std::exp(-z * z / 2) / (deviation * std::sqrt(2 * kPi));
                                 });
}

Rgb magnitude_by_quadrature(const ColorMap& map, double mean, double deviation)
{
    // Periodic and smooth: evenly spaced angles converge as fast as any rule, once they resolve a
    // peak of 1 / sqrt(r mean / deviation^2) radians.
    const int angles = 64 + static_cast<int>(20 * mean / deviation);
    const auto density = [&](double r) {
        double around = 0;
        for (int i = 0; i < angles; ++i) {
            const double angle = 2 * kPi * i / angles;
            const double x = r * std::cos(angle) - mean, y = r * std::sin(angle);
            around += std::exp(-(x * x + y * y) / (2 * deviation * deviation));
        }
        return r * around / angles / (deviation * deviation);
    };
    return average_by_quadrature(map, std::max(0.0, mean - 10 * deviation), mean + 10 * deviation,
                                 deviation / 2, density);
}

Rgb visible_by_quadrature(const ColorMap& map, double mean, double deviation, double exponent)
{
    const auto above = [&](double x) { // 1 - Phi^(1 + exponent)
        return -std::expm1((1 + exponent) * log_cdf((x - mean) / deviation));
    };
    const auto& knots = map.knots();
    Rgb total = knots.front().color;
    for (size_t i = 1; i < knots.size(); ++i) {
        const double a = knots[i - 1].x, b = knots[i].x;
        double share = above(a);
        if (a < b) {
            // 12 deviations down all is visible above, 12 up nothing.
            const double from = std::clamp(mean - 12 * deviation, a, b);
            const double to = std::clamp(mean + 12 * deviation, a, b);
            double integral = from - a;
            const double parts = std::ceil((to - from) / (deviation / 8));
            for (double p = 0; p < parts; ++p)
                integral += gauss_kronrod<double, 15>::integrate(
                    above, from + (to - from) * p / parts, from + (to - from) * (p + 1) / parts, 0);
            share = integral / (b - a);
        }
        Rgb rise;
        for (size_t c = 0; c < 3; ++c)
            rise[c] = share * (knots[i].color[c] - knots[i - 1].color[c]);
        total = sum(total, rise);
    }
    return total;
}

double largest_difference(const Rgb& a, const Rgb& b)
{
    double largest = 0;
    for (size_t c = 0; c < 3; ++c) {
        const double difference = std::abs(a[c] - b[c]);
        if (!(difference <= largest)) // a NaN is the largest
            largest = difference;
    }
    return largest;
}

} // namespace scree::test
