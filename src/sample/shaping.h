#pragma once

#include <algorithm>

namespace scree {

inline float mix(float a, float b, float f) { return a + f * (b - a); }

/// 0 up to `from`, 1 beyond `to`, 3 f^2 - 2 f^3 between.
inline float smooth_step(float from, float to, float x)
{
    const float f = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return f * f * (3 - 2 * f);
}

} // namespace scree
