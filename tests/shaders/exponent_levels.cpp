#include "shaders/exponent_levels.h"

#include <algorithm>

#include "shaders/mip_image.h"

namespace scree::test {

std::vector<Image> exponent_levels(int width, int height)
{
    std::vector<Image> levels;
    float gain = 2.5F, power = 0.9F, threshold = 0;
    for (;;) {
        Image level{width, height, {"gain", "power", "threshold"}, {}};
        for (int i = 0; i < width * height; ++i)
            level.pixels.insert(level.pixels.end(), {gain, power, threshold});
        levels.push_back(std::move(level));
        if (width == 1 && height == 1)
            return levels;
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
        gain *= 1.1F, power *= 0.85F, threshold += 0.003F;
    }
}

void write_exponent_levels(const std::filesystem::path& file, const std::vector<Image>& levels)
{
    write_mip_image(file, levels, [](OIIO::ImageSpec&) {});
}

} // namespace scree::test
