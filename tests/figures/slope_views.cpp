#include "figures/slope_views.h"

#include "judge/view_check.h"

namespace scree::test {
namespace {

/// The azimuths (j + offset) 360 / count degrees.
void add_around(std::vector<Vec3>& directions, double angle_deg, size_t count, double offset)
{
    for (size_t j = 0; j < count; ++j)
        directions.push_back(direction(angle_deg, (static_cast<double>(j) + offset) * 360 /
                                                      static_cast<double>(count)));
}

} // namespace

SlopeViews::SlopeViews() : angles_deg{55, 74, 84, 87, 65, 80}, fitted{direction(0, 0)}
{
    for (size_t node = 0; node < kNodes; ++node)
        add_around(fitted, angles_deg[node], kAzimuths, 0.125);
    for (const double angle_deg : angles_deg)
        add_around(judged, angle_deg, kAzimuths, 0.625);
    for (const double angle_deg : {30, 60, 80})
        add_around(lights, angle_deg, 4, 1.0 / 3);
}

} // namespace scree::test
