#include "color/magnitude_average.h"

#include <algorithm>
#include <cmath>

#include "color/density_average.h"

namespace scree {

namespace {

/// Deviations from the mean beyond which nothing is left: exp(-9^2 / 2) = 3e-18.
constexpr double kReach = 9;

} // namespace

double scaled_bessel_i0(double x)
{
    constexpr double kNegligible = 1e-15;
    double sum = 1, term = 1;
    if (x < 20) { // power series; all terms are positive
        for (int k = 1; term > kNegligible * sum; ++k) {
            term *= x * x / (4.0 * k * k);
            sum += term;
        }
        return std::exp(-x) * sum;
    }
    // Asymptotic series: its terms shrink down to exp(-2 x), below what counts, before they grow.
    for (int k = 1; term > kNegligible; ++k) {
        term *= (2 * k - 1) * (2 * k - 1) / (8.0 * k * x);
        sum += term;
    }
    constexpr double kTwoPi = 6.28318530717958647693;
    return sum / std::sqrt(kTwoPi * x);
}

Rgb magnitude_average(const ColorMap& map, double mean, double deviation)
{
    if (!(deviation > 0))
        return map.at(mean);
    const double ratio = mean / deviation;
    const auto density = [=](double r) {
        const double q = r / deviation;
        return q * std::exp(-(q - ratio) * (q - ratio) / 2) * scaled_bessel_i0(q * ratio);
    };
    return density_average(map, std::max(0.0, mean - kReach * deviation), mean + kReach * deviation,
                           deviation / 2, density);
}

} // namespace scree
