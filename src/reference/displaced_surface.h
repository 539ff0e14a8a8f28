#pragma once

#include <memory>
#include <optional>

#include "math/vec.h"
#include "reference/relief.h"

namespace scree::reference {

/// A place on the surface.
struct SurfacePoint {
    double height = 0; ///< world units
    Vec2 slope{0, 0};  ///< (dh/ds, dh/dt), world over world
    Rgb color{};       ///< of the texel
    double weight = 0; ///< of the texel; 0: no data, and the rest is not defined
};

/// Where a ray meets the surface.
struct SurfaceHit {
    double s = 0, t = 0; ///< texels, brought back into [0, width) x [0, height)
    double distance = 0; ///< world units
};

/// The surface that the statistics are of: heights bilinear between the texel centres, color and
/// weight constant over a texel; with rays cast against it.
///
/// A texel of weight 0, or whose height or color is NaN or infinite, has no data. Beside such a
/// texel the heights it lacks are made up, for each neighbour alone, so that a plane stays a plane
/// (patch.h); so the surface has slopes there, the statistics', but may be torn. What hides and is
/// hit are the bilinear cells between four texels that all have data: rays pass through the rest.
///
/// Rays end where a relief that `extends` or `ends` does; in one that goes on they are followed
/// through a million images of it, which only rays level with the mean plane outlast: they are
/// free then.
///
/// error  of a ray's height above the surface: below 2^-50 of the relief's range of heights times
///        its size in texels, so 1e-12 of the range at 1024^2; the surface is solved in double, by
///        cells, and is not made of triangles
///
/// Thread safe once made.
class DisplacedSurface {
public:
    /// relief  texels > 0, texel sizes > 0, grids of width x height or, where it says so, empty
    /// Throws Error when Embree refuses (no memory).
    explicit DisplacedSurface(Relief relief);
    ~DisplacedSurface();
    DisplacedSurface(DisplacedSurface&&) noexcept;
    DisplacedSurface& operator=(DisplacedSurface&&) noexcept;

    [[nodiscard]] const Relief& relief() const;

    /// All that rays can meet lies between these, world units; not always up to them, as texels
    /// beyond the edge count whole. 0 where there is no data.
    [[nodiscard]] double lowest() const;
    [[nodiscard]] double highest() const;

    /// The surface at (s, t), texels, in [0, width) x [0, height).
    [[nodiscard]] SurfacePoint at(double s, double t) const;

    /// Whether nothing of the surface lies between the point at (s, t) and infinity along w.
    ///
    /// The ray starts on the surface, where the height of ray minus surface is 0. The point is
    /// hidden where that difference becomes negative, beyond the error above, anywhere along the
    /// ray: no offset is needed, so nothing leaks and nothing shadows itself, and a face that is
    /// turned away hides itself.
    ///
    /// s, t  texels, in [0, width) x [0, height); false where there is no data
    /// w     unit, away from the surface, w.z > 0; frame x along +s, y along +t (down), z out
    [[nodiscard]] bool is_open(double s, double t, const Vec3& w) const;

    /// The first meeting of a ray with the surface, from above or below; one that starts on the
    /// surface meets it there.
    ///
    /// origin     world units, the relief's corner (s, t) = (0, 0) at x = y = 0; anywhere
    /// direction  unit
    [[nodiscard]] std::optional<SurfaceHit> hit(const Vec3& origin, const Vec3& direction) const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

} // namespace scree::reference
