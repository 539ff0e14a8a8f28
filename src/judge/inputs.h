#pragma once

#include <filesystem>
#include <vector>

#include "texset/manifest.h"

namespace scree {

/// Input files of a bake; empty: none.
struct InputFiles {
    std::filesystem::path height; ///< or the normal map
    std::filesystem::path color, colormap;
};

/// The files a set was baked from, by the names and SHA-256 sums in its manifest.
///
/// Looked for in `folders` and the folders in them, then beside the set, in the set's parent folder
/// and in the current one.
///
/// Throws Error naming the file that is missing, or that has changed since, and where it was looked
/// for; also for a set that was not baked from files.
InputFiles find_inputs(const Manifest& manifest, const std::filesystem::path& set,
                       const std::vector<std::filesystem::path>& folders);

} // namespace scree
