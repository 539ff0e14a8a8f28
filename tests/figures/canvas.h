#pragma once

#include <OpenImageIO/imagebuf.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scree::test {

/// 8-bit sRGB.
using Rgb = std::array<uint8_t, 3>;

/// The color of scene-linear Rec. 709 light, clamped.
Rgb srgb(double r, double g, double b);

/// A perceptually ordered scale: lightness rises evenly from dark blue (0) over green to pale
/// yellow (1).
Rgb scale_color(double value);

/// White paper for panels and words; y down.
class Canvas {
public:
    /// font  a TrueType file
    Canvas(int width, int height, std::string font);

    void put(int x, int y, const Rgb& color);
    void fill(int x, int y, int width, int height, const Rgb& color);

    enum class Align { left, centre, right };
    /// y  of the line that letters stand on. Throws Error when the font cannot be read.
    void words(int x, int y, int size, Align align, const std::string& utf8);

    /// Throws Error when the file cannot be written.
    void write(const std::string& png) const;

private:
    OIIO::ImageBuf pixels_;
    std::string font_;
};

} // namespace scree::test
