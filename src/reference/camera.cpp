#include "reference/camera.h"

#include <cmath>

namespace scree::reference {
namespace {

/// The picture's axes in the world, unit.
struct Axes {
    Vec3 right, down, back; ///< back: from the target to the viewer
};

Axes axes_of(const Aim& aim)
{
    const double sine = std::sin(aim.angle_rad), cosine = std::cos(aim.angle_rad);
    const double s = std::cos(aim.azimuth_rad), t = std::sin(aim.azimuth_rad);
    // x to the right, y towards the viewer, z up: seen from +t the map lies as its image does.
    return {{t, -s, 0}, {cosine * s, cosine * t, -sine}, {sine * s, sine * t, cosine}};
}

} // namespace

Camera Camera::pinhole(const Aim& aim, double field_of_view_rad)
{
    const Axes axes = axes_of(aim);
    const double pixel = 2 * std::tan(field_of_view_rad / 2) / aim.rows; // at distance 1
    const double distance = aim.width / (pixel * aim.columns);
    const Vec3 target(aim.target.x, aim.target.y, aim.plane);
    const Vec3 still(0, 0, 0);
    return {{target + distance * axes.back, still, still},
            {-axes.back - pixel * (aim.columns / 2.0 * axes.right + aim.rows / 2.0 * axes.down),
             pixel * axes.right, pixel * axes.down}};
}

Camera Camera::distant(const Aim& aim, double clear_of)
{
    const Axes axes = axes_of(aim);
    const double pixel = aim.width / aim.columns;
    // Each ray is moved along itself until it starts at the height of clear_of.
    auto raised = [&axes](const Vec3& place, double height) {
        return place + (height - place.z) / axes.back.z * axes.back;
    };
    const Vec3 corner = Vec3(aim.target.x, aim.target.y, aim.plane) -
                        pixel * (aim.columns / 2.0 * axes.right + aim.rows / 2.0 * axes.down);
    const Vec3 still(0, 0, 0);
    return {{raised(corner, clear_of), pixel * axes.right, raised(pixel * axes.down, 0)},
            {-axes.back, still, still}};
}

Ray Camera::ray(double x, double y) const
{
    return {origin_.at(x, y), direction_.at(x, y).normalized()};
}

std::optional<PlaneView> Camera::view_of_plane(double height, double x, double y) const
{
    const Vec3 origin = origin_.at(x, y), direction = direction_.at(x, y);
    if (!(direction.z < 0) || !(origin.z > height))
        return {};
    const double steps = (height - origin.z) / direction.z;
    auto change = [&](const Vec3& of_origin, const Vec3& of_direction) {
        const double of_steps = -(of_origin.z + steps * of_direction.z) / direction.z;
        const Vec3 moved = of_origin + steps * of_direction + of_steps * direction;
        return Vec2(moved.x, moved.y);
    };
    const Vec3 place = origin + steps * direction;
    return PlaneView{{place.x, place.y},
                     change(origin_.right, direction_.right),
                     change(origin_.down, direction_.down),
                     -direction.normalized()};
}

} // namespace scree::reference
