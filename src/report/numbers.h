#pragma once

#include <string>

namespace scree::report {

/// A number as people read it: 1 000, 0.25, digits grouped by thin spaces, a minus sign that is
/// one. decimals  0 to 15, after the point
std::string grouped(double value, int decimals);

/// Powers of ten from 0.0001 to 1 000 000 are written out.
constexpr int kFirstWritten = -4, kLastWritten = 6;

/// digit 10^exponent, as on a logarithmic axis: 0.002, 10, 20 000; raised: 2·10⁻³, 10, 2·10⁴.
/// digit  1 to 9
std::string of_decade(int digit, int exponent, bool is_raised);

/// Up to four significant digits, for words in running text.
std::string brief(double value);

/// A coordinate in a drawing: at most two decimals, never in exponents or a locale's commas.
std::string coordinate(double value);

} // namespace scree::report
