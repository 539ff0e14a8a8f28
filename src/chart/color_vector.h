#pragma once

#include "judge/shading.h"

namespace scree {

/// A color as the kernel has it, and as an array.
inline Vec3f vector_of(const Rgbf& color) { return {color[0], color[1], color[2]}; }
inline Rgbf color_of(const Vec3f& vector) { return {vector.x, vector.y, vector.z}; }

} // namespace scree
