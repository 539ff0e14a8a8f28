#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bake/mesh_words.h"
#include "judge/inputs.h"
#include "pipeline/options.h"
#include "texset/manifest.h"

namespace CLI {
class App;
}

namespace scree::tool {

/// The words of the command line, before they become BakeOptions.
struct BakeWords {
    BakeOptions options;
    std::string recipe;
    std::vector<double> texel_size, world_size, map_range;
    std::optional<double> map_azimuth;
    std::string map_by = "height";
    std::vector<std::string> wrap, maps;
    std::string input = "height", normal_range = "auto", reconstruction = "bilinear";
    std::string pixel_type = "auto", compression = "zip", layout = "scree";
    std::string visibility;    ///< empty: not given
    std::vector<double> nodes; ///< how many, or their angles
    std::optional<int> harmonics;
    std::string axes;
    MeshWords mesh;
    bool quiet = false;
};

/// Gives a command the options of a bake, all but the recipe's name; `words` gets what they say.
void add_bake_options(CLI::App& command, BakeWords& words);

/// Applies the recipe, if one is named, and makes BakeOptions of the words, all but the output.
///
/// Throws UsageError for words that mean nothing or contradict each other, and without a height
/// map.
void interpret(CLI::App& command, BakeWords& words);

/// What a recipe of `scree bake` says, as if it were run without other options; no output is
/// needed.
///
/// Throws UsageError as interpret() does.
BakeOptions options_of_recipe(const std::filesystem::path& recipe);

/// The options a set was baked with, from its manifest; the files are given, since a manifest names
/// no folders.
///
/// Throws Error where the manifest's options are none that this version knows, or damaged.
BakeOptions options_of_manifest(const Manifest& manifest, const InputFiles& files);

} // namespace scree::tool
