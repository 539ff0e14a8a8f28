#pragma once

#include <string>

namespace scree::test {

/// Whether a page names the maketx on PATH as the one it was written with.
bool is_of_this_maketx(const std::string& page);

/// Where two pages differ, as "... is ..."; empty where they do not.
///
/// Words must be the same. Numbers may differ by a quarter, or by 0.001: rays and single-precision
/// sums of other programs are not the same to the last digit on every machine, and each number is
/// held to a bound of its own elsewhere.
std::string difference(const std::string& page, const std::string& now);

} // namespace scree::test
