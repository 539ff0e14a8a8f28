#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "judge/original.h"
#include "pipeline/options.h"
#include "reference/displaced_surface.h"
#include "texset/manifest.h"

namespace CLI {
class App;
}

namespace scree::tool {

/// What the command line says of a set and of the files it was baked from.
struct SetWords {
    std::filesystem::path path;                ///< folder or manifest
    std::vector<std::filesystem::path> inputs; ///< folders to look for the files in
    std::string ocio_config;                   ///< empty: none was named
    int tile = 0;                              ///< UDIM number; 0: the set is one map
};

/// Gives a command the argument `set`, and its group of files --udim, --inputs and --ocio-config.
void add_set_options(CLI::App& command, CLI::App& files, SetWords& words);

/// --udim: which tile of a set of tiles is meant.
void add_tile_option(CLI::App& files, int& tile);

/// --inputs and --ocio-config alone.
void add_input_options(CLI::App& files, SetWords& words);

/// What a set was baked from, and how.
struct SetInputs {
    BakeOptions options;
    Original original;
};

/// Finds the files a set was baked from and reads them as its bake did. The supervisor is told of
/// them.
///
/// Throws Error where a file is missing, has changed or cannot be read, and where the manifest's
/// options are none that this version knows; Cancelled when asked to stop.
SetInputs read_set_inputs(const Manifest& manifest, const SetWords& words,
                          const BakeMonitor& monitor);

/// The surface a set was baked from, for rays.
///
/// without  what to do where there is none, for the error's words: "leave it out with ..."
/// Throws Error for a normal map, and for heights too high for rays (judge/ray_reach.h).
reference::DisplacedSurface surface_for_rays(reference::Relief relief, const SetWords& words,
                                             const std::string& without);

} // namespace scree::tool
