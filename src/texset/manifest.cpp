#include "texset/manifest.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/error.h"
#include "texset/manifest_file.h"
#include "texset/manifest_json.h"
#include "texset/udim.h"

namespace scree {

namespace fs = std::filesystem;
namespace {

constexpr const char* kSuffix = ".scree.json";

} // namespace

void write_manifest(const Manifest& manifest, const fs::path& folder)
{
    const fs::path path = folder / (manifest.name + kSuffix);
    write_manifest_file(path, to_json(manifest));
}

Manifest read_manifest(const fs::path& set)
{
    const fs::path path = find_manifest(set, kSuffix, "texture set");
    const std::string text = read_manifest_file(path);
    try {
        return manifest_of(text);
    } catch (const Error& e) {
        throw Error(fmt::format("{}: {}", path.string(), e.what()));
    }
}

Manifest manifest_of_map(const Manifest& set, int tile)
{
    std::vector<int> numbers;
    for (const TileRecord& record : set.tiles)
        numbers.push_back(record.number);
    if (set.tiles.empty()) {
        if (tile == 0)
            return set;
        throw Error(fmt::format("{}: has no tiles; leave out the number {}", set.name, tile));
    }
    const auto own = std::find_if(set.tiles.begin(), set.tiles.end(),
                                  [tile](const TileRecord& t) { return t.number == tile; });
    if (own == set.tiles.end())
        throw Error(tile == 0 ? fmt::format("{}: is a set of tiles; name one with --udim, of {}",
                                            set.name, tile_list(numbers))
                              : fmt::format("{}: has no tile {}, but {}", set.name, tile,
                                            tile_list(numbers)));
    Manifest map = set;
    map.tiles.clear();
    map.width = own->width;
    map.height = own->height;
    map.texel_width = own->texel_width;
    map.texel_height = own->texel_height;
    map.no_data_texels = own->no_data_texels;
    map.mesh = own->mesh;
    map.levels = own->levels;
    for (TextureRecord& texture : map.textures)
        texture.file = file_of_tile(texture.file, tile).string();
    map.inputs.erase(std::remove_if(map.inputs.begin(), map.inputs.end(),
                                    [tile](const InputRecord& input) {
                                        return input.tile != 0 && input.tile != tile;
                                    }),
                     map.inputs.end());
    return map;
}

std::vector<std::string> files_of(const TextureRecord& texture, const Manifest& manifest)
{
    if (!is_tiled(texture.file))
        return {texture.file};
    std::vector<std::string> files;
    for (const TileRecord& tile : manifest.tiles)
        files.push_back(file_of_tile(texture.file, tile.number).string());
    return files;
}

std::set<std::string> files_of_set(const fs::path& folder)
{
    std::set<std::string> files;
    try {
        const fs::path path = find_manifest(folder, kSuffix, "texture set");
        const Manifest manifest = read_manifest(path);
        for (const auto& texture : manifest.textures)
            for (auto& file : files_of(texture, manifest))
                files.insert(std::move(file));
        files.insert(path.filename().string());
    } catch (const Error&) {
        return {}; // no set, or none we can read: not ours to replace
    }
    return files;
}

} // namespace scree
