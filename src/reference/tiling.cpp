#include "reference/tiling.h"

namespace scree::reference {
namespace {

constexpr double kStart = 0.5; // of the relief, in grid coordinates

double step_to_end(double size, double place, double direction)
{
    return step_to(direction > 0 ? kStart + size : kStart, place, direction);
}

} // namespace

Tiling::Tiling(const Relief& relief)
    : s_{static_cast<double>(relief.width), relief.beyond_s}, t_{static_cast<double>(relief.height),
                                                                 relief.beyond_t}
{}

void Tiling::fold(const Axis& axis, double& place, double& direction)
{
    const double image = std::floor((place - kStart) / axis.size);
    if (image == 0 || !goes_on(axis.beyond))
        return;
    place -= image * axis.size;
    if (axis.beyond == Beyond::mirrors && std::fmod(image, 2) != 0) {
        place = 2 * kStart + axis.size - place;
        direction = -direction;
    }
    place = std::clamp(place, kStart, kStart + axis.size);
}

std::optional<double> Tiling::enter(GridRay& ray) const
{
    fold(s_, ray.x, ray.dx);
    fold(t_, ray.y, ray.dy);
    // Folded axes are inside and stay so until `leaves`.
    Span inside{0, std::numeric_limits<double>::infinity()};
    inside = clipped(inside, kStart, kStart + s_.size, ray.x, ray.dx);
    inside = clipped(inside, kStart, kStart + t_.size, ray.y, ray.dy);
    if (!(inside.from <= inside.to))
        return {};
    return inside.from;
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
