#pragma once

#include <string_view>

namespace scree::report {

/// Width of a line of text in a usual sans-serif face, in pixels; an estimate, rather too wide,
/// since the face is the reader's.
double text_width(std::string_view utf8, double font_size);

} // namespace scree::report
