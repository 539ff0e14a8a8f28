#include "reference/rough_plane.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>

namespace scree::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

double projected(const Vec3& w, const Vec2& slope) { return w.z - w.x * slope.x - w.y * slope.y; }

} // namespace

double own_lambda(const Vec3& w, const Vec2& slope, double base_alpha)
{
    const double deviation = base_alpha / std::sqrt(2.0) * std::hypot(w.x, w.y);
    const double area = projected(w, slope);
    const double edge_on = area / deviation; // deviations up to where slopes turn away
    if (!(edge_on < 38))
        return 0;
    const auto turned_away = [&](double x) {
        return (deviation * x - area) * std::exp(-x * x / 2) / std::sqrt(2 * kPi);
    };
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(turned_away, edge_on,
                                                                         edge_on + 12, 10, 1e-14) /
           area;
}

double mirrored_by_plane(const Vec3& wo, const Vec3& wi, const Vec2& slope, double base_alpha)
{
    const Vec3 h = (wo + wi).normalized();
    const Vec2 away = Vec2(-h.x / h.z, -h.y / h.z) - slope;
    const double variance = base_alpha * base_alpha / 2;
    const double density = std::exp(-away.length2() / (2 * variance)) / (2 * kPi * variance);
    const double g2 =
        1 / (1 + own_lambda(wo, slope, base_alpha) + own_lambda(wi, slope, base_alpha));
    return density * g2 / (4 * std::pow(h.z, 4) * projected(wo, slope));
}

} // namespace scree::test
