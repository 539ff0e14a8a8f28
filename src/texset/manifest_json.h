#pragma once

#include <string>

#include "texset/manifest.h"

namespace scree {

inline constexpr const char* kManifestFormat = "scree texture set";
inline constexpr const char* kManifestProgram = "scree "; ///< goes before the version

/// A manifest from the text that to_json() makes of it.
/// Throws Error, without a file's name, when it is damaged, not Scree's or of a later format.
Manifest manifest_of(const std::string& json);

} // namespace scree
