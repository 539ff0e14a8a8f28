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
/// Thread safe once made.
class DisplacedSurface {
public:
    /// Throws Error when Embree refuses (no memory).
    explicit DisplacedSurface(Relief relief);
    ~DisplacedSurface();
    DisplacedSurface(DisplacedSurface&&) noexcept;
    DisplacedSurface& operator=(DisplacedSurface&&) noexcept;

    [[nodiscard]] const Relief& relief() const;
    [[nodiscard]] double lowest() const;  ///< world units
    [[nodiscard]] double highest() const; ///< world units

    /// The surface at (s, t), texels, in [0, width) x [0, height).
    [[nodiscard]] SurfacePoint at(double s, double t) const;

    /// Whether nothing of the surface lies between the point at (s, t) and infinity along w.
    ///
    /// w  unit, away from the surface, w.z > 0; frame x along +s, y along +t (down), z out
    [[nodiscard]] bool is_open(double s, double t, const Vec3& w) const;

    /// The first meeting of a ray with the surface, from above or below.
    ///
    /// origin     world units, the relief's corner (s, t) = (0, 0) at x = y = 0
    /// direction  unit
    [[nodiscard]] std::optional<SurfaceHit> hit(const Vec3& origin, const Vec3& direction) const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

} // namespace scree::reference
