#pragma once

#include <optional>

#include "reference/grid_ray.h"

namespace scree::reference {

/// How rays go on beyond the edges of the relief: in grid coordinates it is
/// [0.5, width + 0.5] x [0.5, height + 0.5].
class Tiling {
public:
    explicit Tiling(const Relief& relief);

    /// Brings a ray that may start anywhere into the relief: an axis that goes on is folded (and
    /// turned, in a mirror image), one that does not is waited for.
    ///
    /// returns the step at which the ray, as it then is, enters; nothing if it never does
    [[nodiscard]] std::optional<double> enter(GridRay& ray) const;

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
    static void fold(const Axis& axis, double& place, double& direction);
    static bool cross(const Axis& axis, double& place, double& direction);

    Axis s_, t_;
};

} // namespace scree::reference
