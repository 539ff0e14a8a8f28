#pragma once

#include <filesystem>
#include <string>

namespace scree {

/// The file of a folder that ends in `suffix` (".scree.json"), or `place` itself where it is a
/// file.
///
/// what  that it describes, for errors: "texture set"
/// Throws Error when there is none, or several.
std::filesystem::path find_manifest(const std::filesystem::path& place, const std::string& suffix,
                                    const std::string& what);

/// Throws Error when the file cannot be written whole.
void write_manifest_file(const std::filesystem::path& file, const std::string& text);

/// Throws Error when the file cannot be opened.
std::string read_manifest_file(const std::filesystem::path& file);

} // namespace scree
