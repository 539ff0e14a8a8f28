#pragma once

#include "kernel/filter.h"
#include "support/files.h"

namespace scree::test {

/// Slopes of a texel of NAME.slope.exr, as a renderer makes them of its moments.
inline filter::Slopes<double> slopes_at(const Image& slope, int x, int y, double tau = 0)
{
    auto value = [&](int channel) { return static_cast<double>(slope.at(x, y, channel)); };
    return filter::slopes<double>({value(0), value(1), value(2), value(3), value(4)}, tau);
}

} // namespace scree::test
