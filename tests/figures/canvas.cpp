#include "figures/canvas.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>

#include "math/error.h"

namespace scree::test {
namespace {

uint8_t srgb_byte(double light)
{
    const double v = std::clamp(light, 0.0, 1.0);
    const double code = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return static_cast<uint8_t>(std::lround(255 * code));
}

} // namespace

Rgb srgb(double r, double g, double b) { return {srgb_byte(r), srgb_byte(g), srgb_byte(b)}; }

Rgb scale_color(double value)
{
    // CIE L* of the stops: 10, 31, 53, 73, 94.
    constexpr std::array<std::array<double, 3>, 5> kStops = {
        {{22, 27, 60}, {28, 77, 122}, {40, 139, 130}, {138, 190, 105}, {248, 239, 178}}};
    const double place = std::clamp(value, 0.0, 1.0) * (kStops.size() - 1);
    const auto low = std::min(static_cast<size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(low);
    Rgb color{};
    for (size_t i = 0; i < 3; ++i)
        color[i] = static_cast<uint8_t>(
            std::lround(kStops[low][i] + part * (kStops[low + 1][i] - kStops[low][i])));
    return color;
}

Canvas::Canvas(int width, int height, std::string font)
    : pixels_(OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8)), font_(std::move(font))
{
    pixels_.specmod().attribute("DateTime", ""); // else files of equal pictures differ
    fill(0, 0, width, height, {255, 255, 255});
}

void Canvas::put(int x, int y, const Rgb& color)
{
    std::copy(color.begin(), color.end(), static_cast<uint8_t*>(pixels_.pixeladdr(x, y)));
}

void Canvas::fill(int x, int y, int width, int height, const Rgb& color)
{
    for (int j = y; j < y + height; ++j)
        for (int i = x; i < x + width; ++i)
            put(i, j, color);
}

void Canvas::words(int x, int y, int size, Align align, const std::string& utf8)
{
    using namespace OIIO::ImageBufAlgo;
    const auto side = align == Align::left     ? TextAlignX::Left
                      : align == Align::centre ? TextAlignX::Center
                                               : TextAlignX::Right;
    constexpr std::array<float, 3> kInk = {0.1F, 0.1F, 0.1F};
    if (!render_text(pixels_, x, y, utf8, size, font_, kInk, side, TextAlignY::Baseline))
        throw Error(font_ + ": cannot be drawn with: " + pixels_.geterror());
}

void Canvas::write(const std::string& png) const
{
    if (!pixels_.write(png))
        throw Error(png + ": cannot be written: " + pixels_.geterror());
}

} // namespace scree::test
