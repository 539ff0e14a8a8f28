#include "pipeline/measured_views.h"

#include <algorithm>
#include <cmath>

namespace scree {

MeasuredViews::MeasuredViews(double max_view_angle_deg)
{
    constexpr double kRadian = 0.017453292519943295769;
    constexpr double kLeastAngle = 0.01; // degrees; straight above a sweep has no direction
    for (const double share : {0.4, 0.65, 0.8, 0.9, 0.96, 1.0})
        elevations_deg.push_back(std::max(share * max_view_angle_deg, kLeastAngle));
    for (size_t e = 0; e < elevations_deg.size(); ++e)
        for (const double azimuth_deg : {33.75, 168.75, 213.75, 348.75}) {
            const double angle = elevations_deg[e] * kRadian, azimuth = azimuth_deg * kRadian;
            views.push_back({static_cast<int>(e), std::sin(angle) * std::cos(azimuth),
                             std::sin(angle) * std::sin(azimuth), std::cos(angle)});
            angles.push_back({elevations_deg[e], azimuth_deg});
        }
}

} // namespace scree
