#pragma once

#include <filesystem>
#include <string>

namespace scree {

/// SHA-256 of a file's bytes in hex, as `sha256sum` prints it.
/// Throws Error when the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

} // namespace scree
