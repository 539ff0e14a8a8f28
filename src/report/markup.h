#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scree::report {

/// Text as it may stand inside an element or a quoted attribute of XML and HTML; control
/// characters, which XML has no way to write, become U+FFFD.
std::string escaped(std::string_view text);

/// RFC 4648 base64, with padding, without line ends.
std::string base64(const std::vector<uint8_t>& bytes);

/// Number of code points of UTF-8 text: columns it takes on a terminal, East Asian text aside.
size_t printed_width(std::string_view text);

} // namespace scree::report
