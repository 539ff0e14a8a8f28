#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pipeline/options.h"
#include "support/random_image.h"

namespace scree::test {

constexpr int kSize = 96; // two strips of rows

/// Part of an image.
inline Image cut(const Image& from, int x0, int y0, int width, int height)
{
    Image part{width, height, from.channels, {}};
    for (int y = y0; y < y0 + height; ++y)
        for (int x = x0; x < x0 + width; ++x)
            for (size_t c = 0; c < from.channels.size(); ++c)
                part.pixels.push_back(from.at(x, y, static_cast<int>(c)));
    return part;
}

/// Random heights and colors, as one map and as tiles, and how they are baked.
class TiledFiles : public ::testing::Test {
protected:
    /// Writes a map of 2 x 2 tiles as one file and as tiles 1001, 1002, 1011 and 1012.
    void write(const std::string& name, const Image& whole) const
    {
        write_image(temp_ / (name + ".exr"), whole);
        for (int v = 0; v < 2; ++v)
            for (int u = 0; u < 2; ++u)
                write_image(temp_ / (name + "." + std::to_string(1001 + u + 10 * v) + ".exr"),
                            cut(whole, u * kSize, (1 - v) * kSize, kSize, kSize));
    }

    void SetUp() override
    {
        write("h", random_image(2 * kSize, 2 * kSize, {"Y"}, 5));
        write("c", random_image(2 * kSize, 2 * kSize, {"R", "G", "B"}, 6));
    }

    BakeOptions options(const std::string& files, const std::string& output) const
    {
        BakeOptions options;
        options.name = "test";
        options.height_file = temp_ / ("h" + files + ".exr");
        options.color_file = temp_ / ("c" + files + ".exr");
        options.height_scale = 0.01;
        options.texel_size = {{1.0 / kSize, 1.0 / kSize}};
        options.wrap_s = options.wrap_t = Wrap::clamp;
        options.pixel_type = PixelTypeChoice::float32;
        options.output = temp_ / output;
        return options;
    }
    BakeOptions tiles(const std::string& output) const { return options(".<UDIM>", output); }

    std::vector<Image> levels(const std::string& set, const std::string& map) const
    {
        return read_levels(temp_ / set / ("test." + map + ".exr"));
    }

    TempFolder temp_;
};

} // namespace scree::test
