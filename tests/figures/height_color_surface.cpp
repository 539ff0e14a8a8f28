#include "figures/height_color_surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "figures/uniform.h"
#include "pipeline/file_source.h"
#include "sample/field.h"
#include "support/sample_source.h"

namespace scree::test {
namespace {

namespace fs = std::filesystem;

constexpr int kLargest = 512; // texels along a side; what is larger is cropped

/// The upper left of what a bake would read.
Surface cropped(const std::string& name, Source& source)
{
    Surface surface{name, std::min({source.width(), source.height(), kLargest}), {}, {}};
    const auto size = static_cast<size_t>(surface.size);
    SurfaceRows row;
    source.rewind(true);
    for (size_t y = 0; y < size; ++y) {
        source.read(1, row);
        for (size_t x = 0; x < size; ++x) {
            surface.heights.push_back(row.height[x]);
            if (source.has_color())
                surface.colors.push_back({static_cast<double>(row.color[3 * x]),
                                          static_cast<double>(row.color[3 * x + 1]),
                                          static_cast<double>(row.color[3 * x + 2])});
        }
    }
    return surface;
}

/// color    may be empty: no color
/// channel  of the height; empty: the only one
Surface from_files(const std::string& name, const fs::path& height, const fs::path& color,
                   const std::string& channel = "")
{
    BakeOptions options;
    options.height_file = height;
    options.height_channel = channel;
    options.color_file = color;
    FileSource source(options);
    return cropped(name, source);
}

Surface from_sample(const std::string& kind)
{
    MemorySource source = sample_source(*make_sample(kind, kLargest, kLargest), kLargest, kLargest);
    return cropped(kind, source);
}

/// Colors that follow the height.
Surface painted(Surface surface, const std::function<Color(double)>& map)
{
    surface.colors.resize(surface.heights.size());
    std::transform(surface.heights.begin(), surface.heights.end(), surface.colors.begin(), map);
    return surface;
}

/// Waves in all directions, 4 texels long and longer: Gaussian heights of deviation 1.
Surface gaussian_field(const std::string& name)
{
    constexpr int kSize = 256, kWaves = 200;
    constexpr double kTwoPi = 6.283185307179586;
    Surface surface{name, kSize, std::vector<double>(size_t{kSize} * kSize), {}};
    std::mt19937 random(1);
    for (int wave = 0; wave < kWaves; ++wave) {
        const double frequency = 2 * std::pow(32.0, uniform(random)); // waves a map
        const double direction = kTwoPi * uniform(random), phase = kTwoPi * uniform(random);
        // Whole waves along both sides keep the map periodic.
        const double kx = std::round(frequency * std::cos(direction)) / kSize;
        const double ky = std::round(frequency * std::sin(direction)) / kSize;
        for (size_t y = 0; y < kSize; ++y)
            for (size_t x = 0; x < kSize; ++x) {
                const double turns = kx * static_cast<double>(x) + ky * static_cast<double>(y);
                surface.heights[y * kSize + x] +=
                    std::sqrt(2.0 / kWaves) * std::cos(kTwoPi * turns + phase);
            }
    }
    return surface;
}

Color snow_above_rock(double height)
{
    const double snow = std::clamp((height - 0.3) / 0.1, 0.0, 1.0);
    return {0.12 + 0.73 * snow, 0.09 + 0.79 * snow, 0.07 + 0.85 * snow};
}

/// A jump: what no smooth function of the height follows.
Color two_colors(double height)
{
    return height > 0.3 ? Color{0.7, 0.6, 0.4} : Color{0.1, 0.15, 0.2};
}

} // namespace

std::vector<Surface> height_color_surfaces(const fs::path& data)
{
    const fs::path material = data / "heights/material", built = data / "heights/structured";
    const fs::path rock_05 = material / "rock_05",
                   rock023 = material / "rock023/rock023_alb_ht.png";
    const fs::path bricks_02 = built / "bricks_02_256", floor = built / "e7brickfloor01";
    const fs::path mountain = data / "heights/terrain/brushes/mountain1.exr";
    return {
        from_files("rock_05", rock_05 / "rock_05_bump_1k.png", rock_05 / "rock_05_diff_1k.png"),
        from_files("rock023", rock023, rock023, "A"),
        from_files("bricks_02", bricks_02 / "bricks_02_height_2k_raw.exr",
                   bricks_02 / "bricks_02_basecolor_2k_acescg.exr"),
        from_files("e7brickfloor01", floor / "e7brickfloor01_bump.jpg",
                   floor / "e7brickfloor01.jpg"),
        painted(from_files("mountain1, snow", mountain, {}), snow_above_rock),
        from_sample("bricks"),
        from_sample("fractal"),
        painted(gaussian_field("gaussian, step"), two_colors),
    };
}

} // namespace scree::test
