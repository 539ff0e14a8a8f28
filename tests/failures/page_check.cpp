#include "failures/page_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "failures/maketx.h"

namespace scree::test {
namespace {

/// A word that is a number and what follows it: "(0.25" is not, "0.25)" and "12" are.
struct Number {
    double value;
    std::string rest;
    bool is_one;
};

Number number_in(const std::string& word)
{
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    return {value, end, end != word.c_str() && std::isfinite(value)};
}

bool is_alike(const std::string& a, const std::string& b)
{
    if (a == b)
        return true;
    const Number x = number_in(a), y = number_in(b);
    return x.is_one && y.is_one && x.rest == y.rest &&
           std::abs(x.value - y.value) <=
               0.001 + 0.25 * std::max(std::abs(x.value), std::abs(y.value));
}

} // namespace

bool is_of_this_maketx(const std::string& page)
{
    const std::string version = maketx_version();
    return !version.empty() && page.find(version + ",") != std::string::npos;
}

std::string difference(const std::string& page, const std::string& now)
{
    std::istringstream old_words(page), new_words(now);
    for (std::string last;;) {
        std::string a, b;
        const bool more_old = static_cast<bool>(old_words >> a);
        const bool more_new = static_cast<bool>(new_words >> b);
        if (!more_old && !more_new)
            return {};
        if (more_old != more_new || !is_alike(a, b))
            return fmt::format("'{0} {1}' is '{0} {2}'", last, a, b);
        last = std::move(a);
    }
}

} // namespace scree::test
