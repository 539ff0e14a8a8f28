#include "color/shortcut_error.h"

#include <algorithm>
#include <cmath>

#include "color/normal_average.h"
#include "color/visible_color.h"
#include "kernel/filter.h"

namespace scree {

namespace {

constexpr int kMeans = 33, kDeviations = 8;
constexpr std::array<double, 16> kExponents = {0,   0.1, 0.3, 1,   3,   10,  30,  100,
                                               300, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6};

} // namespace

ShortcutError shortcut_error(const ColorMap& map, double low, double high, double widest)
{
    ShortcutError error;
    const double span = color_span(map, low, high);
    if (span == 0)
        return error;
    Rgb squares{};
    for (int d = 1; d <= kDeviations; ++d) {
        const double y = static_cast<double>(d) / kDeviations, deviation = widest * y * y;
        for (const double exponent : kExponents) {
            const auto visible = filter::visible_height(exponent);
            const double spread = deviation * std::sqrt(visible.variance);
            for (int m = 0; m < kMeans; ++m) {
                const double mean = low + (high - low) * m / (kMeans - 1);
                const Rgb exact = visible_color(map, mean, deviation, exponent);
                const Rgb shortcut = normal_average(map, mean + deviation * visible.mean, spread);
                for (size_t c = 0; c < 3; ++c) {
                    const double difference = std::abs(shortcut[c] - exact[c]) / span;
                    squares[c] += difference * difference;
                    if (difference > error.largest) {
                        error.largest = difference;
                        error.mean = mean;
                        error.deviation = deviation;
                        error.exponent = exponent;
                    }
                }
            }
        }
    }
    const double count = static_cast<double>(kMeans * kDeviations) * kExponents.size();
    error.rms = std::sqrt(*std::max_element(squares.begin(), squares.end()) / count);
    return error;
}

} // namespace scree
