#include "figures/markdown.h"

#include <fmt/format.h>

namespace scree::test {

std::string percent(double value) { return fmt::format("{:.2f}", 100 * value); }

void print_row(const std::vector<std::string>& cells)
{
    for (const std::string& cell : cells)
        fmt::print("| {} ", cell);
    fmt::print("|\n");
}

void print_head(const std::vector<std::string>& cells)
{
    print_row(cells);
    for (size_t i = 0; i < cells.size(); ++i)
        fmt::print("|---");
    fmt::print("|\n");
}

std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& rest)
{
    first.insert(first.end(), rest.begin(), rest.end());
    return first;
}

} // namespace scree::test
