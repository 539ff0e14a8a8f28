#include "reference/tiling.h"

namespace scree::reference {
namespace {

constexpr double kStart = 0.5; // of the relief, in grid coordinates

double step_to_end(double size, double place, double direction)
{
    return RayAxis(place, direction).step_to(direction > 0 ? kStart + size : kStart);
}

} // namespace

Tiling::Tiling(const Relief& relief)
    : s_{static_cast<double>(relief.width), relief.beyond_s}, t_{static_cast<double>(relief.height),
                                                                 relief.beyond_t}
{}

Span Tiling::within(const Axis& axis, double place, double direction, Span span)
{
    return goes_on(axis.beyond)
               ? span
               : RayAxis(place, direction).within(kStart, kStart + axis.size, span);
}

Span Tiling::inside(const GridRay& ray, Span span) const
{
    return within(t_, ray.y, ray.dy, within(s_, ray.x, ray.dx, span));
}

void Tiling::fold(const Axis& axis, double& place, double& direction)
{
    if (goes_on(axis.beyond)) {
        const double image = std::floor((place - kStart) / axis.size);
        place -= image * axis.size;
        if (axis.beyond == Beyond::mirrors && std::fmod(image, 2) != 0) {
            place = 2 * kStart + axis.size - place;
            direction = -direction;
        }
    }
    place = std::clamp(place, kStart, kStart + axis.size); // what is left is rounding
}

void Tiling::fold(GridRay& ray) const
{
    fold(s_, ray.x, ray.dx);
    fold(t_, ray.y, ray.dy);
}

double Tiling::leaves(const GridRay& ray) const
{
    return std::min(step_to_end(s_.size, ray.x, ray.dx), step_to_end(t_.size, ray.y, ray.dy));
}

bool Tiling::cross(const Axis& axis, double& place, double& direction)
{
    const bool upper = direction > 0;
    switch (axis.beyond) {
    case Beyond::repeats:
        place = upper ? kStart : kStart + axis.size;
        return true;
    case Beyond::mirrors:
        place = upper ? kStart + axis.size : kStart;
        direction = -direction;
        return true;
    case Beyond::extends:
    case Beyond::ends:
        break;
    }
    return false;
}

bool Tiling::go_on(GridRay& ray) const
{
    const double s = step_to_end(s_.size, ray.x, ray.dx);
    const double t = step_to_end(t_.size, ray.y, ray.dy);
    ray.advance(std::min(s, t));
    // The other axis may have been carried over its border by rounding.
    ray.x = std::clamp(ray.x, kStart, kStart + s_.size);
    ray.y = std::clamp(ray.y, kStart, kStart + t_.size);
    return s <= t ? cross(s_, ray.x, ray.dx) : cross(t_, ray.y, ray.dy);
}

} // namespace scree::reference
