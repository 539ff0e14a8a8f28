#include "failures/surfaces.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "figures/uniform.h"
#include "sample/field.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

constexpr double kTwoPi = 6.283185307179586;

MemorySource empty_map(int width, int height)
{
    MemorySource map;
    map.map_width = width;
    map.map_height = height;
    return map;
}

} // namespace

size_t index_of(const MemorySource& map, int x, int y)
{
    const auto column = static_cast<size_t>((x + map.map_width) % map.map_width);
    const auto row = static_cast<size_t>((y + map.map_height) % map.map_height);
    return row * static_cast<size_t>(map.map_width) + column;
}

MemorySource heights_of(int width, int height, const std::function<double(int x, int y)>& h)
{
    MemorySource map = empty_map(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map.heights.push_back(h(x, y));
    return map;
}

MemorySource slope_map_of(int width, int height,
                          const std::function<std::array<double, 2>(int x, int y)>& slope)
{
    MemorySource map = empty_map(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map.slopes.push_back(slope(x, y));
    return map;
}

MemorySource v_groove(int width, int height, double steepness)
{
    return heights_of(width, height,
                      [=](int x, int /*y*/) { return steepness * std::abs(x % 16 - 8); });
}

MemorySource transposed(const MemorySource& surface)
{
    return heights_of(surface.map_height, surface.map_width,
                      [&](int x, int y) { return surface.heights[index_of(surface, y, x)]; });
}

MemorySource white_noise(int width, int height, unsigned seed)
{
    std::mt19937 random(seed);
    return heights_of(width, height, [&](int /*x*/, int /*y*/) { return uniform(random); });
}

MemorySource gaussian_waves(int size, double shortest, double longest, unsigned seed)
{
    constexpr int kWaves = 200;
    const double lowest = size / longest, highest = size / shortest; // waves a map
    MemorySource map = heights_of(size, size, [](int /*x*/, int /*y*/) { return 0.0; });
    std::mt19937 random(seed);
    for (int wave = 0; wave < kWaves; ++wave) {
        const double frequency = lowest * std::pow(highest / lowest, uniform(random));
        const double direction = kTwoPi * uniform(random), phase = kTwoPi * uniform(random);
        // Whole waves along both sides keep the map periodic.
        const double kx = std::round(frequency * std::cos(direction)) / size;
        const double ky = std::round(frequency * std::sin(direction)) / size;
        for (int y = 0, i = 0; y < size; ++y)
            for (int x = 0; x < size; ++x, ++i)
                map.heights[static_cast<size_t>(i)] +=
                    std::sqrt(2.0 / kWaves) * std::cos(kTwoPi * (kx * x + ky * y) + phase);
    }
    return map;
}

MemorySource sample(const std::string& kind, int size)
{
    return sample_source(*make_sample(kind, size, size), size, size);
}

double slope_of_texel(const MemorySource& surface, int x, int y)
{
    const auto difference = [&](int row) {
        return (surface.heights[index_of(surface, x + 1, row)] -
                surface.heights[index_of(surface, x - 1, row)]) /
               2;
    };
    return 0.75 * difference(y) + 0.125 * (difference(y - 1) + difference(y + 1));
}

MemorySource painted(MemorySource surface, const std::function<double(int x, int y, double h)>& red)
{
    surface.colors.clear();
    for (int y = 0; y < surface.map_height; ++y)
        for (int x = 0; x < surface.map_width; ++x)
            surface.colors.push_back({red(x, y, surface.heights[surface.colors.size()]), 0, 0});
    return surface;
}

Image height_image(const MemorySource& surface)
{
    Image image{surface.map_width, surface.map_height, {"Y"}, {}};
    image.pixels.assign(surface.heights.begin(), surface.heights.end());
    return image;
}

Image normal_image(const MemorySource& surface)
{
    Image image{surface.map_width, surface.map_height, {"R", "G", "B"}, {}};
    for (const auto& [s, t] : surface.slopes) {
        const double length = std::sqrt(1 + s * s + t * t);
        for (const double n : {-s, -t, 1.0})
            image.pixels.push_back(static_cast<float>(n / length));
    }
    return image;
}

double mean_red(const MemorySource& map)
{
    double sum = 0;
    for (const auto& color : map.colors)
        sum += color[0];
    return sum / static_cast<double>(map.colors.size());
}

double mean_of_slopes(const MemorySource& surface,
                      const std::function<double(double s, double t)>& of)
{
    double sum = 0;
    for (const auto& [s, t] : surface.slopes)
        sum += of(s, t);
    return sum / static_cast<double>(surface.slopes.size());
}

double variance_of_slopes(const MemorySource& surface)
{
    const double mean = mean_of_slopes(surface, [](double s, double) { return s; });
    return mean_of_slopes(surface, [=](double s, double) { return (s - mean) * (s - mean); });
}

} // namespace scree::test
