#pragma once

#include <filesystem>
#include <vector>

#include "support/files.h"

namespace scree::test {

/// NAME.exponent.exr of a set of that size: gain, power, threshold, alike all over a level and
/// different on every one.
std::vector<Image> exponent_levels(int width, int height);

void write_exponent_levels(const std::filesystem::path& file, const std::vector<Image>& levels);

} // namespace scree::test
