#include "pipeline/map_inputs.h"

#include <fmt/format.h>

#include "math/error.h"
#include "pipeline/map_lanes.h"
#include "pipeline/map_survey.h"
#include "pipeline/tile_files.h"
#include "pipeline/warnings.h"

namespace scree {

namespace {

/// What the files of a map tell of themselves.
void describe_files(const BakedMap& map, Manifest& manifest)
{
    const FileSource& files = *map.files();
    for (InputRecord& record : files.records()) {
        record.tile = map.number();
        manifest.inputs.push_back(std::move(record));
    }
    manifest.working_space = files.working_space();
    warn(manifest, files.notes());
    if (files.quantum() >= manifest.quantum) { // of tiles that of the coarsest
        manifest.quantum = files.quantum();
        manifest.integer_bits = files.integer_bits();
    }
}

std::unique_ptr<BakedMap> open_map(const BakeOptions& options, int tile, Manifest& manifest)
{
    auto map = std::make_unique<BakedMap>(options, tile);
    describe_files(*map, manifest);
    map->source().rest(); // there may be hundreds
    return map;
}

std::string size_of(const BakedMap& map)
{
    return fmt::format("{} is {}x{}", map.name(), map.source().width(), map.source().height());
}

/// On a plane tiles are of one size in the world, whatever their resolutions.
void expect_one_size(const BakedMaps& maps, const BakeOptions& options)
{
    if (!options.mesh_file.empty())
        return;
    const BakedMap& first = *maps.front();
    const auto width = first.source().width(), height = first.source().height();
    const bool both_given = options.world_size && options.world_height_given;
    for (const auto& map : maps) {
        const auto w = map->source().width(), h = map->source().height();
        if (options.texel_size && (w != width || h != height))
            throw Error(fmt::format("{}, {}: with one --texel-size tiles would differ in size; "
                                    "give --world-size, that of a tile",
                                    size_of(first), size_of(*map)));
        if (!both_given && static_cast<long long>(w) * height != static_cast<long long>(h) * width)
            throw Error(fmt::format("{}, {}: tiles of square texels would differ in size; give "
                                    "--world-size W H, that of a tile",
                                    size_of(first), size_of(*map)));
    }
}

std::string nothing_covered(const BakedMesh& mesh)
{
    std::string words = fmt::format("{}: no texel of the texture lies in a UV chart", mesh.name());
    const std::vector<int> reached = mesh.tiles();
    if (!reached.empty())
        words += fmt::format("; faces reach into tiles {} (maps of tiles have <UDIM> in their "
                             "names, any other is for 1001)",
                             tile_list(reached));
    for (const std::string& warning : mesh.warnings())
        words += "; " + warning;
    return words;
}

} // namespace

BakedMaps open_maps(const BakeOptions& options, const BakedMesh* mesh, Manifest& manifest)
{
    manifest.name = options.name.empty() ? stem_of(options.height_file) : options.name;
    if (manifest.name.empty())
        throw Error(fmt::format("{}: leaves no name for the set; give --name",
                                options.height_file.string()));
    BakedMaps maps;
    if (is_tiled(options.height_file)) {
        TileFiles tiles = find_tiles(options, mesh);
        warn(manifest, std::move(tiles.warnings));
        for (const int number : tiles.numbers)
            maps.push_back(open_map(options, number, manifest));
    } else {
        maps.push_back(open_map(options, 0, manifest));
    }
    expect_one_size(maps, options);
    return maps;
}

void lay_on(const BakedMesh& mesh, BakedMaps& maps, const std::filesystem::path& folder,
            Manifest& manifest, const BakeMonitor& monitor)
{
    const MapMonitors monitors(monitor, maps.size());
    for_each_map(widths_of(maps),
                 [&](size_t map) { maps[map]->lay_on(mesh, folder, monitors.of(map)); });
    BakedMaps covered;
    for (auto& map : maps)
        if (map->mesh()->largest_area() > 0)
            covered.push_back(std::move(map));
        else if (map->number() != 0)
            warn(manifest, {fmt::format("tile {}: no texel lies in a UV chart of {}; left out",
                                        map->number(), mesh.name())});
    maps = std::move(covered);
    if (maps.empty())
        throw Error(nothing_covered(mesh));
    manifest.inputs.push_back(mesh.input());
    warn(manifest, mesh.warnings());
    const std::vector<int> reached = mesh.tiles();
    if (maps.front()->number() == 0 && reached != std::vector<int>{kFirstUdim})
        warn(manifest,
             {fmt::format(
                 "{}: faces reach into tiles {}; one map was given, for 1001: name tiles by <UDIM>",
                 mesh.name(), tile_list(reached))});
}

} // namespace scree
