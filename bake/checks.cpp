#include "bake/checks.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace scree::tool {

namespace {

/// holds  takes the number; expected and shown say what it must be, in an error and in the help
template <class Number, class Holds>
CLI::Validator check(const Holds& holds, const std::string& expected, const std::string& shown)
{
    auto complaint = [holds, expected](const std::string& word) {
        Number number{};
        if (CLI::detail::lexical_cast(word, number) && holds(number))
            return std::string();
        return fmt::format("expected {}, got '{}'", expected, word);
    };
    return CLI::Validator(complaint, shown);
}

} // namespace

CLI::Validator number_from_to(double least, double most)
{
    return check<double>([least, most](double x) { return x >= least && x <= most; },
                         fmt::format("a number from {:g} to {:g}", least, most),
                         fmt::format("{:g} to {:g}", least, most));
}

CLI::Validator number_above_zero()
{
    return check<double>([](double x) { return x > 0 && std::isfinite(x); }, "a number above 0",
                         "above 0");
}

CLI::Validator finite_number()
{
    return check<double>([](double x) { return std::isfinite(x); }, "a number", "");
}

CLI::Validator whole_number_from_to(long long least, long long most)
{
    return check<long long>([least, most](long long n) { return n >= least && n <= most; },
                            fmt::format("a whole number from {} to {}", least, most),
                            fmt::format("{} to {}", least, most));
}

CLI::Validator whole_number_from(long long least)
{
    return check<long long>([least](long long n) { return n >= least; },
                            fmt::format("a whole number, {} or more", least),
                            fmt::format("{} or more", least));
}

CLI::Validator angle_or_auto()
{
    auto complaint = [](const std::string& word) {
        double number = 0;
        if (word == "auto" || (CLI::detail::lexical_cast(word, number) && std::isfinite(number)))
            return std::string();
        return fmt::format("expected auto, or an angle in degrees, got '{}'", word);
    };
    return CLI::Validator(complaint, "");
}

} // namespace scree::tool
