#include "shaders/packed_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "pipeline/bake.h"
#include "support/sample_source.h"

namespace scree::test {

namespace {

struct From {
    const std::vector<Image>* map;
    std::string channel;
};

std::vector<Image> packed(const std::array<From, 4>& channels)
{
    std::vector<Image> levels;
    for (size_t l = 0; l < channels[0].map->size(); ++l) {
        const Image& first = (*channels[0].map)[l];
        Image level{first.width, first.height, {"R", "G", "B", "A"}, {}};
        for (int y = 0; y < level.height; ++y)
            for (int x = 0; x < level.width; ++x)
                for (const From& from : channels)
                    level.pixels.push_back(
                        from.channel.empty() ? 0 : value((*from.map)[l], x, y, from.channel));
        levels.push_back(std::move(level));
    }
    return levels;
}

} // namespace

SampleSet bake_sample(const std::string& kind, int width, int height)
{
    const auto field = make_sample(kind, width, height);
    MemorySource source = sample_source(*field, width, height);
    TempFolder temp;
    BakeOptions options;
    options.output = temp / "set";
    options.pixel_type = PixelTypeChoice::float32;
    options.texel_size = {field->info().world_width / width, field->info().world_height / height};
    Manifest manifest;
    manifest.name = "test";
    bake(source, options, manifest);
    const auto levels = [&](const std::string& map) {
        return read_levels(temp / "set" / ("test." + map + ".exr"));
    };
    return {static_cast<float>(field->info().world_width),
            static_cast<float>(field->info().world_height),
            levels("slope"),
            levels("height"),
            levels("color"),
            levels("colorheight"),
            levels("tail")};
}

float value(const Image& image, int x, int y, const std::string& channel)
{
    const auto at = std::find(image.channels.begin(), image.channels.end(), channel);
    if (at == image.channels.end()) {
        ADD_FAILURE() << "no channel " << channel;
        return 0;
    }
    return image.at(x, y, static_cast<int>(at - image.channels.begin()));
}

PackedSet pack(const SampleSet& set)
{
    const auto rgb = [](const std::vector<Image>& map) {
        return packed({From{&map, "R"}, From{&map, "G"}, From{&map, "B"}, From{&map, ""}});
    };
    return {packed({From{&set.slope, "s"}, From{&set.slope, "t"}, From{&set.slope, "ss"},
                    From{&set.slope, "tt"}}),
            packed({From{&set.slope, "st"}, From{&set.height, "h"}, From{&set.height, "hh"},
                    From{&set.tail, "tau"}}),
            rgb(set.color), rgb(set.colorheight)};
}

} // namespace scree::test
