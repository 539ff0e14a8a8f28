#pragma once

#include <filesystem>
#include <functional>

namespace scree::test {

/// Changes one number of a texture of a set and writes the file anew, all else as it was.
void rewrite_texture(const std::filesystem::path& file, int level, int x, int y, int channel,
                     const std::function<float(float)>& change);

} // namespace scree::test
