#include "texset/cpt_colors.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <vector>

namespace scree {

namespace {

struct NamedColor {
    std::string_view name;
    int red, green, blue;
};

/// Names that color tables use, of the X11 list GMT follows. Besides: gray0 (black) to gray100.
constexpr NamedColor kNames[] = {
    {"black", 0, 0, 0},
    {"white", 255, 255, 255},
    {"red", 255, 0, 0},
    {"green", 0, 255, 0},
    {"blue", 0, 0, 255},
    {"cyan", 0, 255, 255},
    {"magenta", 255, 0, 255},
    {"yellow", 255, 255, 0},
    {"gray", 190, 190, 190},
    {"grey", 190, 190, 190},
    {"lightgray", 211, 211, 211},
    {"lightgrey", 211, 211, 211},
    {"darkgray", 169, 169, 169},
    {"darkgrey", 169, 169, 169},
    {"dimgray", 105, 105, 105},
    {"orange", 255, 165, 0},
    {"darkorange", 255, 140, 0},
    {"brown", 165, 42, 42},
    {"purple", 160, 32, 240},
    {"violet", 238, 130, 238},
    {"pink", 255, 192, 203},
    {"gold", 255, 215, 0},
    {"beige", 245, 245, 220},
    {"tan", 210, 180, 140},
    {"khaki", 240, 230, 140},
    {"navy", 0, 0, 128},
    {"turquoise", 64, 224, 208},
    {"skyblue", 135, 206, 235},
    {"lightblue", 173, 216, 230},
    {"darkblue", 0, 0, 139},
    {"lightgreen", 144, 238, 144},
    {"darkgreen", 0, 100, 0},
    {"darkred", 139, 0, 0},
    {"maroon", 176, 48, 96},
    {"ivory", 255, 255, 240},
    {"snow", 255, 250, 250},
};

/// Numbers between separators; empty when something else is among them. A sign or an exponent is
/// part of its number: 1e-2-0.5-1 has three.
std::vector<double> separated(std::string_view text, char separator)
{
    std::vector<double> numbers;
    const char *at = text.data(), *const end = text.data() + text.size();
    while (true) {
        double value = 0;
        const auto [after, failed] = std::from_chars(at, end, value);
        if (failed != std::errc() || !std::isfinite(value))
            return {};
        numbers.push_back(value);
        if (after == end)
            return numbers;
        if (*after != separator)
            return {};
        at = after + 1;
    }
}

CptColor of_bytes(int red, int green, int blue)
{
    return {{red / 255.0, green / 255.0, blue / 255.0}, false};
}

std::optional<CptColor> named(std::string word)
{
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& [name, red, green, blue] : kNames)
        if (word == name)
            return of_bytes(red, green, blue);
    const bool gray = word.rfind("gray", 0) == 0 || word.rfind("grey", 0) == 0;
    const auto percent = gray ? decimal_number(word.substr(4)) : std::nullopt;
    if (!percent || *percent < 0 || *percent > 100 || *percent != std::floor(*percent))
        return std::nullopt;
    // X11's list rounds halves up, but for these two.
    const int down = *percent == 50 || *percent == 90 ? 1 : 0;
    const int level = static_cast<int>(std::lround(*percent * 255 / 100)) - down;
    return of_bytes(level, level, level);
}

std::optional<CptColor> hexadecimal(const std::string& digits)
{
    unsigned int code = 0;
    const auto [after, failed] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 6 || failed != std::errc() || after != digits.data() + digits.size())
        return std::nullopt;
    return of_bytes(static_cast<int>(code >> 16), static_cast<int>(code >> 8 & 255),
                    static_cast<int>(code & 255));
}

} // namespace

Rgb rgb_of_hsv(const Rgb& hsv)
{
    const auto channel = [&](double turned) {
        // Distance along the hexagon of hues to where this channel is darkest, in sixths.
        const double sixth = std::fmod(std::fmod(turned + hsv[0] / 60, 6) + 6, 6);
        const double share = std::clamp(std::min(sixth, 4 - sixth), 0.0, 1.0);
        return hsv[2] * (1 - hsv[1] * share);
    };
    return {channel(5), channel(3), channel(1)};
}

Rgb hsv_of_rgb(const Rgb& rgb)
{
    const double most = *std::max_element(rgb.begin(), rgb.end());
    const double chroma = most - *std::min_element(rgb.begin(), rgb.end());
    if (!(chroma > 0))
        return {0, 0, most};
    double sixth = 0;
    if (most == rgb[0])
        sixth = (rgb[1] - rgb[2]) / chroma + (rgb[1] < rgb[2] ? 6 : 0);
    else if (most == rgb[1])
        sixth = (rgb[2] - rgb[0]) / chroma + 2;
    else
        sixth = (rgb[0] - rgb[1]) / chroma + 4;
    return {60 * sixth, chroma / most, most};
}

std::optional<double> decimal_number(const std::string& text)
{
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    const std::vector<double> numbers =
        separated(std::string_view(text).substr(plus ? 1 : 0), '\0');
    return numbers.size() == 1 ? std::optional(numbers[0]) : std::nullopt;
}

std::optional<CptColor> cpt_color(const Rgb& numbers, bool hsv_model)
{
    const Rgb most = hsv_model ? Rgb{360, 1, 1} : Rgb{255, 255, 255};
    CptColor color{{}, hsv_model};
    for (size_t c = 0; c < 3; ++c) {
        if (!(numbers[c] >= 0 && numbers[c] <= most[c]))
            return std::nullopt;
        color.value[c] = hsv_model ? numbers[c] : numbers[c] / 255;
    }
    return color;
}

std::optional<CptColor> cpt_color(const std::string& word_and_transparency, bool hsv_model)
{
    const std::string word = word_and_transparency.substr(0, word_and_transparency.find('@'));
    if (word.empty())
        return std::nullopt;
    if (word[0] == '#')
        return hexadecimal(word.substr(1));
    if (const auto gray = decimal_number(word))
        return cpt_color(Rgb{*gray, *gray, *gray}, false);
    for (const char separator : {'/', '-'}) {
        const std::vector<double> numbers = separated(word, separator);
        if (numbers.size() == 3)
            return cpt_color(Rgb{numbers[0], numbers[1], numbers[2]},
                             separator == '-' || hsv_model);
    }
    return named(word);
}

} // namespace scree
