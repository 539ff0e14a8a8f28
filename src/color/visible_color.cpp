#include "color/visible_color.h"

#include <algorithm>
#include <cmath>

#include "color/density_average.h"
#include "math/normal.h"

namespace scree {

namespace {

/// Deviations above the mean below which nothing is visible: P(visible height < z) = Phi^(1 + L)
/// is exp(-43) = 2e-19 there, or z is -9.
double lowest_visible(double exponent)
{
    double hidden = -9, visible = 9;
    while (visible - hidden > 1e-3) {
        const double z = (hidden + visible) / 2;
        ((1 + exponent) * log_normal_cdf(z) < -43 ? hidden : visible) = z;
    }
    return hidden;
}

} // namespace

Rgb visible_color(const ColorMap& map, double mean, double deviation, double exponent)
{
    if (!(deviation > 0))
        return map.at(mean);
    const auto density = [=](double x) {
        const double z = (x - mean) / deviation;
        return std::exp(exponent * log_normal_cdf(z) - z * z / 2);
    };
    // The largest of 1 + L normal numbers: spread over about 1 / sqrt(1 + log(1 + L)), and above
    // the highest end with probability (1 + L) exp(-end^2 / 2) / 2 < exp(-40).
    const double crowd = std::log1p(exponent);
    return density_average(map, mean + lowest_visible(exponent) * deviation,
                           mean + std::sqrt(81 + 2 * crowd) * deviation,
                           deviation / (2 * std::sqrt(1 + crowd)), density);
}

} // namespace scree
