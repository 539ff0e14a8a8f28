#pragma once

namespace scree {

/// How many threads OpenImageIO and OpenEXR may use to read images.
void set_image_threads(int threads);

} // namespace scree
