#include "support/oracle_case.h"

#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

namespace scree::test {

MemorySource OracleCase::source() const
{
    MemorySource source;
    const reference::Relief& relief = input.relief;
    source.map_width = relief.width;
    source.map_height = relief.height;
    source.heights = relief.heights;
    source.slopes = input.slopes;
    source.colors = relief.colors;
    source.weights = relief.weights;
    return source;
}

OracleCase random_case(int width, int height, unsigned seed)
{
    OracleCase c;
    c.title = fmt::format("random {}x{}", width, height);
    reference::Relief& relief = c.input.relief;
    relief.width = width;
    relief.height = height;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double h = noise(random) + 2 * std::sin(0.37 * x + 0.21 * y) + 0.05 * x;
            const auto rounded = static_cast<double>(static_cast<float>(h));
            relief.heights.push_back(rounded);
            std::array<double, 3> color{};
            for (size_t k = 0; k < 3; ++k)
                color[k] = static_cast<double>(static_cast<float>(
                    0.5 + 0.1 * rounded * static_cast<double>(k) + 0.2 * noise(random)));
            relief.colors.push_back(color);
        }
    set_texel_size(c, 1, 1);
    set_wrap(c, Wrap::periodic, Wrap::periodic);
    return c;
}

OracleCase holes_case(int width, int height, unsigned seed)
{
    OracleCase c = random_case(width, height, seed);
    c.title = fmt::format("holes {}x{}", width, height);
    reference::Relief& relief = c.input.relief;
    std::mt19937 random(seed + 1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i =
                static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
            relief.weights.push_back(static_cast<float>(0.25 + 0.75 * uniform(random)));
            const bool in_block = x >= 2 && x < 5 && y >= 1 && y < 6;
            const bool in_line = x == width - 1 && y % 3 == 0;
            if (in_block || in_line || uniform(random) < 0.05)
                relief.heights[i] = nan;
            else if (uniform(random) < 0.03)
                relief.colors[i][1] = nan;
            else if (uniform(random) < 0.03)
                relief.weights[i] = 0;
        }
    relief.heights.back() = 0.5; // so that some texel has data at any size
    relief.colors.back() = {0.125, 0.25, 0.5};
    relief.weights.back() = 1;
    return c;
}

void set_wrap(OracleCase& c, Wrap wrap_s, Wrap wrap_t)
{
    using reference::Beyond;
    auto beyond = [](Wrap wrap) {
        switch (wrap) {
        case Wrap::periodic:
            return Beyond::repeats;
        case Wrap::clamp:
            return Beyond::extends;
        case Wrap::mirror:
            return Beyond::mirrors;
        case Wrap::black:
            break;
        }
        return Beyond::ends;
    };
    c.options.wrap_s = wrap_s;
    c.options.wrap_t = wrap_t;
    c.input.relief.beyond_s = beyond(wrap_s);
    c.input.relief.beyond_t = beyond(wrap_t);
    c.title += fmt::format(" wrap {} {}", wrap_name(wrap_s), wrap_name(wrap_t));
}

void set_reconstruction(OracleCase& c, Reconstruction reconstruction)
{
    c.options.reconstruction = reconstruction;
    c.input.reconstruction =
        reconstruction == Reconstruction::bilinear  ? reference::Reconstruction::bilinear
        : reconstruction == Reconstruction::central ? reference::Reconstruction::central
                                                    : reference::Reconstruction::sobel;
    c.title += " " + reconstruction_name(reconstruction);
}

void set_texel_size(OracleCase& c, double width, double height)
{
    c.options.texel_size = {width, height};
    c.input.relief.texel_width = width;
    c.input.relief.texel_height = height;
}

} // namespace scree::test
