#include "texset/table_file.h"

#include <cassert>

#include "texset/image_file.h"

namespace scree {

void write_table(const TableManifest& manifest, const std::vector<float>& values,
                 const std::filesystem::path& folder)
{
    std::vector<std::string> channels;
    for (const TableChannel& channel : manifest.channels)
        channels.push_back(channel.name);
    const auto width = static_cast<size_t>(manifest.width());
    const auto height = static_cast<size_t>(manifest.height());
    assert(values.size() == width * height * channels.size());

    Attributes attributes = {{"scree:kind", manifest.kind},
                             {"ImageDescription", manifest.description}};
    for (size_t i = 0; i < manifest.axes.size(); ++i)
        attributes.emplace_back("scree:axis" + std::to_string(i + 1), manifest.axes[i].name);
    for (const TableChannel& channel : manifest.channels)
        attributes.emplace_back("scree:" + channel.name, channel.quantity);
    ImageFile file(folder / manifest.texture_file(), manifest.width(), manifest.height(), channels,
                   attributes);
    for (size_t y = 0; y < height; ++y)
        file.write_row(values.data() + y * width * channels.size());
    file.close();
    write_table_manifest(manifest, folder);
}

} // namespace scree
