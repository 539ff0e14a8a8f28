#include "support/oracle_case.h"

#include <cmath>
#include <limits>
#include <random>

#include <fmt/format.h>

namespace scree::test {

MemorySource OracleCase::source() const
{
    MemorySource source;
    source.map_width = input.width;
    source.map_height = input.height;
    source.heights = input.heights;
    source.slopes = input.slopes;
    source.colors = input.colors;
    source.weights = input.weights;
    return source;
}

OracleCase random_case(int width, int height, unsigned seed)
{
    OracleCase c;
    c.title = fmt::format("random {}x{}", width, height);
    c.input.width = width;
    c.input.height = height;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double h = noise(random) + 2 * std::sin(0.37 * x + 0.21 * y) + 0.05 * x;
            const auto rounded = static_cast<double>(static_cast<float>(h));
            c.input.heights.push_back(rounded);
            std::array<double, 3> color{};
            for (size_t k = 0; k < 3; ++k)
                color[k] = static_cast<double>(static_cast<float>(
                    0.5 + 0.1 * rounded * static_cast<double>(k) + 0.2 * noise(random)));
            c.input.colors.push_back(color);
        }
    set_texel_size(c, 1, 1);
    set_wrap(c, Wrap::periodic, Wrap::periodic);
    return c;
}

OracleCase holes_case(int width, int height, unsigned seed)
{
    OracleCase c = random_case(width, height, seed);
    c.title = fmt::format("holes {}x{}", width, height);
    std::mt19937 random(seed + 1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i =
                static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
            c.input.weights.push_back(
                static_cast<double>(static_cast<float>(0.25 + 0.75 * uniform(random))));
            const bool in_block = x >= 2 && x < 5 && y >= 1 && y < 6;
            const bool in_line = x == width - 1 && y % 3 == 0;
            if (in_block || in_line || uniform(random) < 0.05)
                c.input.heights[i] = nan;
            else if (uniform(random) < 0.03)
                c.input.colors[i][1] = nan;
            else if (uniform(random) < 0.03)
                c.input.weights[i] = 0;
        }
    c.input.heights.back() = 0.5; // so that some texel has data at any size
    c.input.colors.back() = {0.125, 0.25, 0.5};
    c.input.weights.back() = 1;
    return c;
}

void set_wrap(OracleCase& c, Wrap wrap_s, Wrap wrap_t)
{
    auto oracle_wrap = [](Wrap wrap) {
        switch (wrap) {
        case Wrap::periodic:
            return oracle::Wrap::kPeriodic;
        case Wrap::clamp:
            return oracle::Wrap::kClamp;
        case Wrap::mirror:
            return oracle::Wrap::kMirror;
        case Wrap::black:
            break;
        }
        return oracle::Wrap::kBlack;
    };
    c.options.wrap_s = wrap_s;
    c.options.wrap_t = wrap_t;
    c.input.wrap_s = oracle_wrap(wrap_s);
    c.input.wrap_t = oracle_wrap(wrap_t);
    c.title += fmt::format(" wrap {} {}", wrap_name(wrap_s), wrap_name(wrap_t));
}

void set_reconstruction(OracleCase& c, Reconstruction reconstruction)
{
    c.options.reconstruction = reconstruction;
    c.input.reconstruction =
        reconstruction == Reconstruction::bilinear  ? oracle::Reconstruction::kBilinear
        : reconstruction == Reconstruction::central ? oracle::Reconstruction::kCentral
                                                    : oracle::Reconstruction::kSobel;
    c.title += " " + reconstruction_name(reconstruction);
}

void set_texel_size(OracleCase& c, double width, double height)
{
    c.options.texel_size = {width, height};
    c.input.dx = width;
    c.input.dy = height;
}

} // namespace scree::test
