#pragma once

#include <filesystem>
#include <string>

#include "support/files.h"
#include "texset/color_map_file.h"

namespace scree::test {

/// A text as a file of a temporary folder.
std::filesystem::path written(const TempFolder& folder, const std::string& name,
                              const std::string& text);

/// The map of a text: its name's ending says what it is.
ColorMapFile map_of(const std::string& name, const std::string& text);

/// What reading fails with, without the folder's path; empty, and a failed test, when it does not.
std::string error_of(const std::string& name, const std::string& text);
std::string error_of(const std::filesystem::path& file);

/// Whether the message has all the parts; a failed test prints it.
void expect_parts(const std::string& message, std::initializer_list<const char*> parts);

void expect_color(const Rgb& got, const Rgb& want, double tolerance = 1e-12);

} // namespace scree::test
