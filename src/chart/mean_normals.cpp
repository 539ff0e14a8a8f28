#include "chart/mean_normals.h"

#include <algorithm>

#include <cmath>

#include "math/storage.h"

namespace scree {

namespace {

float as_half(double value)
{
    return static_cast<float>(StoreHalf::value(StoreHalf::nearest(value)));
}

} // namespace

MeanNormals::MeanNormals(const reference::Relief& relief,
                         const std::vector<filter::Vec2<float>>& slopes)
    : width_(relief.width)
{
    for (size_t i = 0; i < slopes.size(); ++i) {
        const float own = relief.weights.empty() ? 1 : relief.weights[i];
        weights_.push_back(std::isfinite(relief.heights[i]) ? own : 0);
        weighted_.push_back(filter::normal(slopes[i]) * weights_.back());
    }
}

Vec3f MeanNormals::over(const reference::Footprint& footprint) const
{
    Vec3 sum(0);
    double total = 0;
    for (size_t j = 0; j < footprint.t.share.size(); ++j)
        for (size_t i = 0; i < footprint.s.share.size(); ++i) {
            const size_t y = static_cast<size_t>(footprint.t.first) + j;
            const size_t texel =
                y * static_cast<size_t>(width_) + static_cast<size_t>(footprint.s.first) + i;
            const double share = footprint.t.share[j] * footprint.s.share[i];
            sum += Vec3(weighted_[texel]) * share;
            total += share * static_cast<double>(weights_[texel]);
        }
    if (!(total > 0))
        return {0, 0, 1};
    const Vec3 mean = sum / total;
    // Never level: the smallest half there is.
    return {as_half(mean.x), as_half(mean.y), std::max(as_half(mean.z), 0x1p-24F)};
}

} // namespace scree
