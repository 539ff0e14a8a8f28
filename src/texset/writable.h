#pragma once

#include <filesystem>

namespace scree {

/// The file to replace when `path` is written by renaming: what its links lead to.
/// Throws Error where that is there and no ordinary file (a device or a pipe would be replaced
/// too), and where its folder is missing or takes no files.
std::filesystem::path file_to_replace(const std::filesystem::path& path);

/// Throws Error as file_to_replace() does: to know before the work that its end can be written.
void expect_writable(const std::filesystem::path& path);

} // namespace scree
