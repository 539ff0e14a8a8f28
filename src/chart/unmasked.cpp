#include "chart/unmasked.h"

#include <algorithm>

namespace scree {

namespace {

constexpr float kPerPi = 0.318309886F;

} // namespace

Rgbf unmasked_radiance(const filter::Slopes<float>& slopes, const Rgbf& color,
                       const Material& material, const Vec3f& wo, const Vec3f& wi)
{
    const float diffuse = kPerPi * std::max(filter::normal(slopes.mean).dot(wi), 0.0F);
    const float specular = material.f0 * filter::specular(wo, wi, slopes, material.base_alpha);
    return {color[0] * diffuse + specular, color[1] * diffuse + specular,
            color[2] * diffuse + specular};
}

filter::Slopes<float> toksvig_slopes(const Vec3f& normal, float base_alpha)
{
    const float length = std::min(normal.length(), 1.0F);
    const float square = base_alpha * base_alpha;
    const float power = 2 / square - 2;
    const float lowered = power * length / (length + power * (1 - length));
    filter::Slopes<float> slopes;
    slopes.mean = {-normal.x / normal.z, -normal.y / normal.z};
    const float more = std::max((2 / (lowered + 2) - square) / 2, 0.0F);
    slopes.covariance = {more, 0, more};
    return slopes;
}

} // namespace scree
