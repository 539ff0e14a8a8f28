#include "figures/light_pairs.h"

#include <cmath>

namespace scree::test {
namespace {

/// azimuth  of 16, and a part of one
Vec3 direction(double angle_deg, size_t azimuth, double offset)
{
    constexpr double kRadian = 0.017453292519943295769;
    const double angle = angle_deg * kRadian;
    const double around =
        (static_cast<double>(azimuth) + offset) * 360 / LightPairs::kAzimuths * kRadian;
    return {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
            std::cos(angle)};
}

LightPairs pairs(const std::vector<double>& view_angles_deg,
                 const std::vector<double>& light_angles_deg, size_t lights_of_angle, double offset)
{
    LightPairs all;
    all.view_angles_deg = view_angles_deg;
    all.light_angles_deg = light_angles_deg;
    all.lights_of_angle = lights_of_angle;
    all.views.emplace_back(0, 0, 1);
    constexpr size_t kQuarter = LightPairs::kAzimuths / LightPairs::kViewsOfAngle;
    for (size_t angle = 1; angle < view_angles_deg.size(); ++angle)
        for (size_t k = 0; k < LightPairs::kViewsOfAngle; ++k)
            all.views.push_back(
                direction(view_angles_deg[angle], angle - 1 + k * kQuarter, offset));
    const size_t step = LightPairs::kAzimuths / lights_of_angle;
    for (const double angle_deg : light_angles_deg)
        for (size_t k = 0; k < lights_of_angle; ++k)
            all.lights.push_back(direction(angle_deg, k * step, offset));
    return all;
}

} // namespace

size_t LightPairs::view_angle(size_t view) const
{
    return (view + kViewsOfAngle - 1) / kViewsOfAngle;
}

size_t LightPairs::light_angle(size_t light) const { return light / lights_of_angle; }

LightPairs judged_pairs()
{
    return pairs({0, 30, 60, 75, 83}, {30, 45, 60, 75, 80, 85}, LightPairs::kAzimuths, 0.25);
}

LightPairs fitted_pairs() { return pairs({0, 40, 68, 79, 85}, {40, 68, 79, 85}, 8, 0.75); }

} // namespace scree::test
