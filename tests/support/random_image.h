#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/files.h"

namespace scree::test {

/// White noise, uniform in [low, high), the same on every machine.
inline Image random_image(int width, int height, std::vector<std::string> channels, unsigned seed,
                          float low = 0, float high = 1)
{
    Image image{width, height, std::move(channels), {}};
    image.pixels.resize(static_cast<size_t>(width) * static_cast<size_t>(height) *
                        image.channels.size());
    std::mt19937 random(seed);
    for (float& value : image.pixels)
        value = low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24F;
    return image;
}

} // namespace scree::test
