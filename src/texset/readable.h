#pragma once

#include <filesystem>
#include <string>

namespace scree {

/// Throws Error, naming the file, when it is missing, a folder, empty, or may not be read.
/// expected  what it should have been: "an image"
void expect_readable(const std::filesystem::path& path, const std::string& expected);

} // namespace scree
