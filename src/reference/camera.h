#pragma once

#include <optional>

#include "math/vec.h"

namespace scree::reference {

/// A ray in world units: the relief's corner (s, t) = (0, 0) at x = y = 0.
struct Ray {
    Vec3 origin{0, 0, 0}, direction{0, 0, -1}; ///< direction is unit
};

/// What a pixel sees of a level plane.
struct PlaneView {
    Vec2 place{0, 0};                  ///< x, y, world units
    Vec2 along_x{0, 0}, along_y{0, 0}; ///< d place / d pixel, to the right and down
    Vec3 to_viewer{0, 0, 1};           ///< unit
};

/// Where a picture is seen from, how far, and how wide it is; x along +s, y along +t, z out of the
/// surface.
struct Aim {
    Vec2 target{0, 0};         ///< x, y in the middle of the picture, world units
    double plane = 0;          ///< height of the target, world units
    double angle_rad = 0;      ///< of the way to the viewer, from the normal, below pi / 2
    double azimuth_rad = 0;    ///< of that way, from +s towards +t
    double width = 1;          ///< that the picture shows at the target, world units
    int columns = 1, rows = 1; ///< pixels, square
};

/// From places in a picture to rays. Pixel (i, j) is [i, i + 1) x [j, j + 1), row 0 at the top; the
/// picture's right is level, its top is up or, straight from above, away from the viewer's azimuth.
class Camera {
public:
    /// A pinhole with a field of view of that height, in (0, pi).
    static Camera pinhole(const Aim& aim, double field_of_view_rad);

    /// From infinitely far away: all rays are parallel.
    ///
    /// clear_of  height above all that is to be seen, world units: there rays start
    static Camera distant(const Aim& aim, double clear_of);

    [[nodiscard]] Ray ray(double x, double y) const;

    /// The level plane at a height, as the middle of a pixel's surroundings; nothing where the ray
    /// does not go down to it.
    [[nodiscard]] std::optional<PlaneView> view_of_plane(double height, double x, double y) const;

private:
    struct Moving { ///< at(x, y) = start + x right + y down, of pixels
        Vec3 start, right, down;

        [[nodiscard]] Vec3 at(double x, double y) const { return start + x * right + y * down; }
    };

    Camera(const Moving& origin, const Moving& direction) : origin_(origin), direction_(direction)
    {}

    Moving origin_, direction_; ///< the direction not unit
};

} // namespace scree::reference
