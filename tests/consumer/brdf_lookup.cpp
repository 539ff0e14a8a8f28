// The example of docs/brdf-parametrizations.md.

#include <kernel/brdf_coordinates.h>

#include <algorithm>
#include <array>
#include <cstddef>

using Imath::V3f;
using namespace scree;

// The BRDF of two directions: texels is brdf-hybrid.exr, row by row, size its axes' sizes.
V3f brdf(const V3f* texels, const std::array<int, 3>& size, const V3f& wo, const V3f& wi)
{
    const V3f at = filter::hybrid_place(filter::Directions<float>{wo, wi});
    V3f sum(0);
    int low[3];
    float part[3];
    for (int i = 0; i < 3; ++i) {
        const int last = size[static_cast<std::size_t>(i)] - 1;
        const float place = at[i] * static_cast<float>(last);
        low[i] = std::min(static_cast<int>(place), last - 1);
        part[i] = place - static_cast<float>(low[i]);
    }
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
        const int row = (low[2] + z) * size[1] + low[1] + y;
        sum += texels[row * size[0] + low[0] + x] *
               ((x == 1 ? part[0] : 1 - part[0]) * (y == 1 ? part[1] : 1 - part[1]) *
                (z == 1 ? part[2] : 1 - part[2]));
    }
    return sum;
}
