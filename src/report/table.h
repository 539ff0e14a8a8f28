#pragma once

#include <string>
#include <vector>

namespace scree::report {

/// Rows of words under headings: one table for the terminal, a page and a spreadsheet.
struct Table {
    std::string title;
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows; ///< each as long as headings
};

/// Columns padded; those of numbers to the right. Ends with a newline.
std::string to_text(const Table& table);
/// An HTML table element; words are escaped.
std::string to_html(const Table& table);
/// RFC 4180, with a line of headings.
std::string to_csv(const Table& table);

} // namespace scree::report
