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

/// Which multiples of powers of ten get numbers, from few to many.
const std::vector<std::vector<int>>& digit_sets()
{
    static const std::vector<std::vector<int>> sets = {
        {1}, {1, 2, 5}, {1, 2, 3, 5, 7}, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
    return sets;
}

bool holds(const std::vector<int>& digits, int digit)
{
    return std::find(digits.begin(), digits.end(), digit) != digits.end();
}

/// How many digits times powers of ten lie in a range of logarithms.
int count_within(const std::vector<int>& digits, double low, double high)
{
    int count = 0;
    for (int exponent = static_cast<int>(std::floor(low)); exponent <= high; ++exponent)
        for (const int digit : digits) {
            const double at = exponent + std::log10(digit);
            count += at >= low && at <= high ? 1 : 0;
        }
    return count;
}

} // namespace

Scale::Scale(const std::vector<double>& values, bool logarithmic, int steps)
    : logarithmic_(logarithmic)
{
    std::vector<double> shown;
    for (const double value : values)
        if (std::isfinite(value) && (!logarithmic || value > 0))
            shown.push_back(logarithmic ? std::log10(std::clamp(value, 1 / kLargest, kLargest))
                                        : std::clamp(value, -kLargest, kLargest));
    if (shown.empty())
        shown = {0, 1};
    const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
    if (logarithmic)
        make_logarithmic(*low, *high, steps);
    else
        make_linear(*low, *high, steps);
}

void Scale::add_round_numbers(double low, double high, int steps)
{
    constexpr double kPlainBelow = 1e9;
    constexpr int kPlainDecimals = 6;
    const Step step = round_step(high - low, steps);
    const double size = std::max(std::abs(low), std::abs(high));
    const bool is_plain = step.exponent >= -kPlainDecimals && size < kPlainBelow;
    const double first = std::ceil(low / step.size - kNear);
    const int count = static_cast<int>(std::floor(high / step.size + kNear) - first) + 1;
    for (int i = 0; i < count; ++i) {
        const double value = (first + i) * step.size;
        ticks_.push_back(
            {place(value), is_plain ? grouped(value, std::max(0, -step.exponent)) : brief(value)});
    }
}

void Scale::make_linear(double low, double high, int steps)
{
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= 1e-9 * size + kSmallest) {
        const double around = size <= kSmallest ? 1 : size / 2;
        low -= around;
        high += around;
    }
    const double room = kRoom * (high - low);
    low_ = low >= 0 && low < high / 2 ? 0 : low - room;
    high_ = high <= 0 && high > low / 2 ? 0 : high + room;
    add_round_numbers(low_, high_, steps);
}

void Scale::make_logarithmic(double low, double high, int steps)
{
    constexpr double kLeastDecades = 0.05, kFewNumbers = 3;
    const double missing = std::max(0.0, kLeastDecades - (high - low));
    const double room = kRoom * (high - low) + missing / 2;
    low_ = low - room;
    high_ = high + room;
    const std::vector<int>* digits = &digit_sets().front();
    for (const auto& more : digit_sets())
        if (count_within(more, low_, high_) <= 1.3 * steps)
            digits = &more;
    if (count_within(*digits, low_, high_) < kFewNumbers)
        add_round_numbers(std::pow(10.0, low_), std::pow(10.0, high_), steps);
    else
        add_decades(*digits, steps);
}

void Scale::add_decades(const std::vector<int>& numbered, int steps)
{
    constexpr double kManyDecades = 9; // small marks would run together
    const double decades = high_ - low_;
    const int first = static_cast<int>(std::floor(low_));
    const int last = static_cast<int>(std::floor(high_));
    const int every = std::max(1, static_cast<int>(std::ceil(decades / steps)));
    const bool is_raised = std::ceil(low_) < kFirstWritten || last > kLastWritten;
    for (int exponent = first; exponent <= last; ++exponent)
        for (int digit = 1; digit <= 9; ++digit) {
            const double at = exponent + std::log10(digit);
            const bool has_number = holds(numbered, digit) && exponent % every == 0;
            const bool is_mark = digit == 1 || decades <= kManyDecades;
            if (at >= low_ && at <= high_ && (has_number || is_mark))
                ticks_.push_back({(at - low_) / decades,
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
