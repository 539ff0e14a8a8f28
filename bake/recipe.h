#pragma once

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace scree::tool {

/// Gives the options of a command the values a recipe holds, unless the command line gave them.
///
/// A recipe is a TOML file whose keys are the command's long options without their dashes:
///   height = "brick.exr"
///   texel-size = [0.001, 0.001]
///   alpha-weight = true
/// Paths in it are relative to the recipe. Throws UsageError, naming the file and the key, for
/// unknown keys, tables, and values an option does not take. A table [validate] is left for
/// `scree validate`.
///
/// path_keys  options whose values are paths, comma separated
void apply_recipe(CLI::App& command, const std::filesystem::path& file,
                  const std::string& path_keys);

/// The same for the keys of the recipe's table [validate]; UsageError where it has none.
void apply_validate_table(CLI::App& command, const std::filesystem::path& file,
                          const std::string& path_keys);

} // namespace scree::tool
