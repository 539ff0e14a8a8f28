#pragma once

#include "reference/grid_ray.h"

namespace scree::reference {

/// How rays go on beyond the edges of the relief: in grid coordinates it is
/// [0.5, width + 0.5] x [0.5, height + 0.5].
class Tiling {
public:
    explicit Tiling(const Relief& relief);

    /// The part of a span in which the relief is there: all of it along an axis that goes on.
    [[nodiscard]] Span inside(const GridRay& ray, Span span) const;

    /// Brings a ray that starts in an image of the relief into the relief, turned where the image
    /// is mirrored.
    void fold(GridRay& ray) const;

    /// The step at which a ray from inside leaves; infinity for one that runs straight up or down.
    [[nodiscard]] double leaves(const GridRay& ray) const;

    /// Moves a ray to where it leaves and from there into the next image of the relief; returns
    /// false where there is none.
    bool go_on(GridRay& ray) const;

private:
    struct Axis {
        double size;
        Beyond beyond;
    };
    static bool goes_on(Beyond beyond)
    {
        return beyond == Beyond::repeats || beyond == Beyond::mirrors;
    }
    static Span within(const Axis& axis, double place, double direction, Span span);
    static void fold(const Axis& axis, double& place, double& direction);
    static bool cross(const Axis& axis, double& place, double& direction);

    Axis s_, t_;
};

} // namespace scree::reference
