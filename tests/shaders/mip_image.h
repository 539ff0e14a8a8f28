#pragma once

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <functional>
#include <vector>

#include "support/files.h"

namespace scree::test {

/// Writes all MIP levels of a texture as a set's files are: tiled float32 OpenEXR, periodic.
///
/// describe  adds to the header
void write_mip_image(const std::filesystem::path& file, const std::vector<Image>& levels,
                     const std::function<void(OIIO::ImageSpec&)>& describe);

} // namespace scree::test
