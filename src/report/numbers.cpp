#include "report/numbers.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>

namespace scree::report {

namespace {

constexpr const char* kMinus = "\u2212";
constexpr const char* kThinSpace = "\u2009";

std::string raised(int number)
{
    constexpr std::array<const char*, 10> kDigits = {"\u2070", "\u00b9", "\u00b2", "\u00b3",
                                                     "\u2074", "\u2075", "\u2076", "\u2077",
                                                     "\u2078", "\u2079"};
    std::string text = number < 0 ? "\u207b" : "";
    for (const char c : std::to_string(std::abs(number)))
        text += kDigits[static_cast<size_t>(c - '0')];
    return text;
}

} // namespace

std::string grouped(double value, int decimals)
{
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
    const size_t whole = std::min(digits.find('.'), digits.size());
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    std::string text = value < 0 && !is_zero ? kMinus : "";
    for (size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && i < whole && (whole - i) % 3 == 0)
            text += kThinSpace;
        text += digits[i];
    }
    return text;
}

std::string of_decade(int digit, int exponent, bool is_raised)
{
    const bool is_small_number = exponent == 0 || exponent == 1;
    if (!is_raised || is_small_number)
        return grouped(digit * std::pow(10.0, exponent), std::max(0, -exponent));
    const std::string power = "10" + raised(exponent);
    return digit == 1 ? power : std::to_string(digit) + "\u00b7" + power;
}

std::string brief(double value) { return fmt::format("{:.4g}", value); }

std::string coordinate(double value)
{
    std::string text = fmt::format("{:.2f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text == "-0" ? "0" : text;
}

} // namespace scree::report
