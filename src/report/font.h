#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scree::report {

/// Width of a line of text in a usual sans-serif face, in pixels; an estimate, rather too wide,
/// since the face is the reader's.
double text_width(std::string_view utf8, double font_size);

/// Text broken at spaces into lines of at most that width, as far as its words allow.
std::vector<std::string> wrapped(const std::string& utf8, double font_size, double width);

/// Of what a chart says, pixels.
constexpr double kFontSize = 12, kTitleSize = 15, kSmallSize = 11;

} // namespace scree::report
