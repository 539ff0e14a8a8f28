#pragma once

#include <string>

namespace scree::report {

/// A number as people read it: 1 000, 0.25, digits grouped by thin spaces, a minus sign that is
/// one. decimals  0 to 15, after the point
std::string grouped(double value, int decimals);

/// 10^exponent: 0.001, 10, 10 000; beyond 10^-4 .. 10^6 the exponent raised, as in 10⁻⁵.
std::string power_of_ten(int exponent);

/// digit 10^exponent, likewise.
/// digit  1 to 9
std::string of_decade(int digit, int exponent);

/// Up to four significant digits, for words in running text.
std::string brief(double value);

/// A coordinate in a drawing: at most two decimals, never in exponents or a locale's commas.
std::string coordinate(double value);

} // namespace scree::report
