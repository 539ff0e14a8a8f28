#pragma once

#include <string>
#include <vector>

namespace scree::test {

/// Of a share: "1.23" for 0.0123.
std::string percent(double value);

/// A row of a table, and its head, on stdout.
void print_row(const std::vector<std::string>& cells);
void print_head(const std::vector<std::string>& cells);

std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& rest);

} // namespace scree::test
