#include "report/scale.h"

#include <algorithm>
#include <cmath>

#include "report/numbers.h"

namespace scree::report {

namespace {

constexpr double kRoom = 0.04;                         // beyond the outermost points, of the axis
constexpr double kLargest = 1e300, kSmallest = 1e-290; // so that no sum or step overflows
constexpr double kNear = 1e-9;                         // rounding of logarithms and quotients

/// A step of 1, 2 or 5 times a power of ten with about `count` steps in `range`.
struct Step {
    double size = 1;
    int exponent = 0; ///< of the power of ten
};

Step round_step(double range, int count)
{
    const double rough = range / count;
    const int exponent = static_cast<int>(std::floor(std::log10(rough)));
    const double power = std::pow(10.0, exponent);
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= rough * 0.9)
            return {digit * power, exponent};
    return {10 * power, exponent + 1};
}

/// The logarithm of the next of 1, 2, 5, 10, ... below (or above) a logarithm.
double round_decade(double logarithm, bool up)
{
    const double decade = std::floor(logarithm + kNear);
    double below = decade;
    for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
        const double at = decade + std::log10(digit);
        if (up && at >= logarithm - kNear)
            return at;
        if (at <= logarithm + kNear)
            below = at;
    }
    return below;
}

/// Whether digit 10^n gets a number, on an axis of so many decades with room for so many numbers.
bool is_written(int digit, int exponent, double decades, int steps)
{
    if (decades > 0.4 * steps) {
        const int every = std::max(1, static_cast<int>(std::ceil(decades / steps)));
        return digit == 1 && exponent % every == 0;
    }
    if (decades > 0.15 * steps)
        return digit == 1 || digit == 2 || digit == 5;
    return digit <= 3 || digit == 5 || digit == 7;
}

} // namespace

Scale::Scale(const std::vector<double>& values, bool logarithmic, int steps)
    : logarithmic_(logarithmic)
{
    std::vector<double> shown;
    for (const double value : values)
        if (std::isfinite(value) && (!logarithmic || value > 0))
            shown.push_back(logarithmic ? std::log10(value)
                                        : std::clamp(value, -kLargest, kLargest));
    if (shown.empty())
        shown = {0, 1};
    const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
    if (logarithmic)
        make_logarithmic(*low, *high, steps);
    else
        make_linear(*low, *high, steps);
}

void Scale::make_linear(double low, double high, int steps)
{
    constexpr double kPlainBelow = 1e9;
    constexpr int kPlainDecimals = 6;
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= 1e-9 * size + kSmallest) {
        const double around = size <= kSmallest ? 1 : size / 2;
        low -= around;
        high += around;
    }
    const double room = kRoom * (high - low);
    low_ = low >= 0 && low < high / 2 ? 0 : low - room;
    high_ = high <= 0 && high > low / 2 ? 0 : high + room;
    const Step step = round_step(high_ - low_, steps);
    const bool is_plain = step.exponent >= -kPlainDecimals && size < kPlainBelow;
    const double first = std::ceil(low_ / step.size - kNear);
    const int count = static_cast<int>(std::floor(high_ / step.size + kNear) - first) + 1;
    for (int i = 0; i < count; ++i) {
        const double value = (first + i) * step.size;
        ticks_.push_back(
            {place(value), is_plain ? grouped(value, std::max(0, -step.exponent)) : brief(value)});
    }
}

void Scale::make_logarithmic(double low, double high, int steps)
{
    constexpr double kManyDecades = 9;                         // small marks would run together
    const double room = kRoom / 2 * std::max(high - low, 1.0); // rounding gives more
    low_ = round_decade(low - room, false);
    high_ = round_decade(high + room, true);
    const double decades = high_ - low_;
    const int first = static_cast<int>(std::floor(low_ + kNear));
    const int last = static_cast<int>(std::floor(high_ + kNear));
    const bool is_raised = first < kFirstWritten || last > kLastWritten;
    for (int exponent = first; exponent <= last; ++exponent)
        for (int digit = 1; digit <= 9; ++digit) {
            const double at = exponent + std::log10(digit);
            const bool has_number = is_written(digit, exponent, decades, steps);
            const bool is_outside = at < low_ - kNear || at > high_ + kNear;
            if (is_outside || (digit > 1 && !has_number && decades > kManyDecades))
                continue;
            ticks_.push_back({std::clamp((at - low_) / decades, 0.0, 1.0),
                              has_number ? of_decade(digit, exponent, is_raised) : ""});
        }
}

double Scale::place(double value) const
{
    if (logarithmic_ && value <= 0)
        return 0;
    const double at = logarithmic_ ? std::log10(value) : value;
    return std::clamp((at - low_) / (high_ - low_), 0.0, 1.0);
}

} // namespace scree::report
