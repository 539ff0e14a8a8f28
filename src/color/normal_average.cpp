#include "color/normal_average.h"

#include <algorithm>

#include "math/normal.h"

namespace scree {

namespace {

/// Deviations from the mean beyond which nothing is left: Phi(-9) = 1e-19.
constexpr double kReach = 9;

/// The end of a piece: how many deviations the mean is above it.
struct Edge {
    explicit Edge(double above) : z(above), cdf(normal_cdf(above)), pdf(normal_pdf(above)) {}
    double z, cdf, pdf;
};

/// Mean of Phi from `b.z` up to `a.z`; Phi itself where they meet.
double mean_cdf(const Edge& a, const Edge& b)
{
    const double h = a.z - b.z;
    // The difference of the integrals would lose its digits; Euler and Maclaurin's formula stands
    // in for it, whose next term is below h^6 / 30000.
    if (h < 0.03)
        return (a.cdf + b.cdf) / 2 - h / 12 * (a.pdf - b.pdf) +
               h * h * h / 720 * ((a.z * a.z - 1) * a.pdf - (b.z * b.z - 1) * b.pdf);
    return (a.z * a.cdf + a.pdf - b.z * b.cdf - b.pdf) / h;
}

} // namespace

Rgb normal_average(const ColorMap& map, double mean, double deviation)
{
    if (!(deviation > 0))
        return map.at(mean);
    const double low = mean - kReach * deviation, high = mean + kReach * deviation;
    const auto& knots = map.knots();
    auto knot = std::upper_bound(knots.begin(), knots.end(), low,
                                 [](double x, const Knot& k) { return x < k.x; });
    Rgb sum = map.at(low), before_color = sum;
    Edge before(kReach);
    for (; knot != knots.end(); ++knot) {
        const bool last = knot->x > high;
        const Rgb color = last ? map.at(high) : knot->color;
        const Edge edge(last ? -kReach : (mean - knot->x) / deviation);
        const double share = mean_cdf(before, edge);
        for (size_t c = 0; c < 3; ++c)
            sum[c] += (color[c] - before_color[c]) * share;
        if (last)
            break;
        before = edge;
        before_color = color;
    }
    return sum;
}

} // namespace scree
