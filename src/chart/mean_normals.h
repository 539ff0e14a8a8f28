#pragma once

#include <vector>

#include "judge/shading.h"
#include "reference/footprint.h"
#include "reference/relief.h"

namespace scree {

/// Unit normals of texels, as a normal map holds them, averaged as its MIP chain would.
class MeanNormals {
public:
    /// slopes  mean slope of every texel of the relief, which says where there is data
    MeanNormals(const reference::Relief& relief, const std::vector<filter::Vec2<float>>& slopes);

    /// E[n] over a footprint, rounded to half floats; its length is at most 1 (to rounding).
    /// Where there is no data: straight up.
    [[nodiscard]] Vec3f over(const reference::Footprint& footprint) const;

private:
    int width_;
    std::vector<Vec3f> weighted_; ///< normal times weight
    std::vector<float> weights_;
};

} // namespace scree
