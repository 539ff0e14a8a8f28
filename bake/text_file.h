#pragma once

#include <filesystem>
#include <string>

namespace scree::tool {

/// Writes a text file; it appears under its name when it is complete, or not at all.
/// Links are followed. Throws Error, naming the file, when it cannot be written, or is a device.
void write_text(const std::string& text, const std::filesystem::path& file);

} // namespace scree::tool
