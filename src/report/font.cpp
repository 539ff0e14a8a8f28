#include "report/font.h"

#include <sstream>

namespace scree::report {

namespace {

/// In parts of the font size, by class: letters of Helvetica and DejaVu Sans differ by a tenth.
double glyph_width(unsigned char c)
{
    constexpr std::string_view kThin = "ijl.,:;'|!()[]tfrI/ ", kWide = "mwMW%@";
    if ((c & 0xc0U) == 0x80U)
        return 0; // rest of a character counted already
    const char ascii = static_cast<char>(c);
    if (kThin.find(ascii) != std::string_view::npos)
        return 0.34;
    if (kWide.find(ascii) != std::string_view::npos)
        return 0.9;
    const bool is_capital = c >= 'A' && c <= 'Z';
    return is_capital ? 0.7 : 0.6;
}

} // namespace

double text_width(std::string_view utf8, double font_size)
{
    double width = 0;
    for (const char c : utf8)
        width += glyph_width(static_cast<unsigned char>(c));
    return width * font_size;
}

std::vector<std::string> wrapped(const std::string& utf8, double font_size, double width)
{
    std::vector<std::string> lines;
    std::istringstream words(utf8);
    for (std::string word; words >> word;) {
        const bool fits =
            !lines.empty() && text_width(lines.back() + " " + word, font_size) <= width;
        if (fits)
            lines.back() += " " + word;
        else
            lines.push_back(word);
    }
    return lines;
}

} // namespace scree::report
