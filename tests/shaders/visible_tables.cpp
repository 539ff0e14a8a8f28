#include "shaders/visible_tables.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "shaders/mip_image.h"
#include "support/random_image.h"

namespace scree::test {

std::vector<float> VisibleTables::values(size_t level, int x, int y) const
{
    const Image& image = levels.at(level);
    std::vector<float> out;
    for (const std::string& name : visible_channels(static_cast<int>(cosines.size()), harmonics)) {
        const auto at = std::find(image.channels.begin(), image.channels.end(), name);
        EXPECT_NE(at, image.channels.end()) << "no channel " << name;
        out.push_back(image.at(x, y, static_cast<int>(at - image.channels.begin())));
    }
    return out;
}

filter::VisibilityTable<float> VisibleTables::table(const std::vector<float>& values) const
{
    const bool axes = harmonics < 0;
    return {
        values.data(), cosines.data(), static_cast<int>(cosines.size()), axes ? 0 : harmonics, axes,
        axis_cosine,   axis_sine};
}

std::vector<std::string> visible_channels(int nodes, int harmonics)
{
    std::vector<std::string> names;
    const auto add = [&](const std::string& component) {
        for (const char channel : {'A', 'B', 'G', 'R'})
            names.push_back(component + channel);
    };
    for (int node = 1; node <= nodes; ++node) {
        add(std::to_string(node));
        for (const char* kind : {"xn", "xp", "yn", "yp"})
            if (harmonics < 0)
                add(std::to_string(node) + kind);
        for (const char kind : {'c', 's'})
            for (int h = 1; h <= harmonics; ++h)
                add(fmt::format("{}{}{}", node, kind, h));
    }
    return names;
}

VisibleTables random_visible_tables(int width, int height, const std::vector<float>& cosines,
                                    int harmonics)
{
    VisibleTables tables;
    tables.cosines = cosines;
    tables.harmonics = harmonics;
    const auto channels = visible_channels(static_cast<int>(cosines.size()), harmonics);
    for (unsigned seed = 71;; ++seed) {
        Image level = random_image(width, height, channels, seed);
        for (size_t i = 0; i < level.pixels.size(); ++i) {
            const bool mean = channels[i % channels.size()].size() == 2;
            level.pixels[i] = (level.pixels[i] - 0.5F) * (mean ? 0.6F : 0.2F);
        }
        tables.levels.push_back(std::move(level));
        if (width == 1 && height == 1)
            return tables;
        width = std::max(width / 2, 1);
        height = std::max(height / 2, 1);
    }
}

void write_visible_tables(const std::filesystem::path& file, const VisibleTables& tables)
{
    write_mip_image(file, tables.levels, [&](OIIO::ImageSpec& spec) {
        spec.attribute("scree:nodes", static_cast<int>(tables.cosines.size()));
        if (tables.harmonics < 0) {
            spec.attribute("scree:axisCosine", tables.axis_cosine);
            spec.attribute("scree:axisSine", tables.axis_sine);
        } else {
            spec.attribute("scree:harmonics", tables.harmonics);
        }
        for (size_t k = 0; k < tables.cosines.size(); ++k)
            spec.attribute(fmt::format("scree:nodeCosine{}", k + 1), tables.cosines[k]);
    });
}

VisibleTables read_visible_tables(const std::filesystem::path& file)
{
    VisibleTables tables;
    tables.levels = read_levels(file);
    const auto in = OIIO::ImageInput::open(file.string());
    if (!in) {
        ADD_FAILURE() << file << ": " << OIIO::geterror();
        return tables;
    }
    tables.harmonics = in->spec().get_int_attribute("scree:harmonics", -1);
    tables.axis_cosine = in->spec().get_float_attribute("scree:axisCosine");
    tables.axis_sine = in->spec().get_float_attribute("scree:axisSine");
    for (int k = 1; k <= in->spec().get_int_attribute("scree:nodes"); ++k)
        tables.cosines.push_back(
            in->spec().get_float_attribute(fmt::format("scree:nodeCosine{}", k)));
    return tables;
}

} // namespace scree::test
