#include "bake/set_inputs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bake/bake_words.h"
#include "bake/checks.h"
#include "bake/supervisor.h"
#include "judge/inputs.h"
#include "judge/ray_reach.h"
#include "math/error.h"
#include "texset/udim.h"

namespace scree::tool {

void add_set_options(CLI::App& command, CLI::App& files, SetWords& words)
{
    command.add_option("set", words.path, "folder or manifest of a texture set")->required();
    add_tile_option(files, words.tile);
    add_input_options(files, words);
}

void add_tile_option(CLI::App& files, int& tile)
{
    files.add_option("--udim", tile, "the tile that is meant, of a set of tiles: its number")
        ->check(whole_number_from_to(kFirstUdim, kLastUdim));
}

void add_input_options(CLI::App& files, SetWords& words)
{
    files
        .add_option("--inputs", words.inputs,
                    "folders with the files the set was baked from [beside the set, the current "
                    "folder]")
        ->delimiter(',')
        ->allow_extra_args(false);
    files.add_option("--ocio-config", words.ocio_config,
                     "OpenColorIO config of the bake, where it named one");
}

SetInputs read_set_inputs(const Manifest& manifest, const SetWords& words,
                          const BakeMonitor& monitor)
{
    if (manifest.mesh)
        throw Error(
            fmt::format("{}: was baked for a mesh, and brute force and rays know planes only; "
                        "bake the same heights without --mesh to check them",
                        words.path.string()));
    if (manifest.options.count("udim-wrap") > 0)
        throw Error(fmt::format("{}: its tiles see each other's heights, and brute force and rays "
                                "know single maps only; bake the tiles without --udim-wrap to "
                                "check them",
                                words.path.string()));
    const InputFiles files = find_inputs(manifest, words.path, words.inputs);
    BakeOptions options = options_of_manifest(manifest, files);
    options.ocio_config = words.ocio_config;
    note_for_supervisor({files.height.string(), files.color.string(), files.colormap.string()}, "");
    std::optional<HeightScale> scale;
    if (words.tile != 0)
        scale = {manifest.h0, manifest.h1, manifest.height_min, manifest.height_max};
    Original original = read_original(options, monitor, scale);
    return {std::move(options), std::move(original)};
}

reference::DisplacedSurface surface_for_rays(reference::Relief relief, const SetWords& words,
                                             const std::string& without)
{
    if (relief.heights.empty())
        throw Error(
            fmt::format("{}: was baked from a normal map, which has no surface to trace; {}",
                        words.path.string(), without));
    reference::DisplacedSurface surface(std::move(relief));
    const std::string too_high = too_high_for_rays(surface);
    if (!too_high.empty())
        throw Error(fmt::format("{}: {}, or {}", words.path.string(), too_high, without));
    return surface;
}

} // namespace scree::tool
