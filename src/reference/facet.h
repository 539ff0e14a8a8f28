#pragma once

#include <cmath>

#include "math/vec.h"

namespace scree::reference {

/// Projected area towards w of a face, per area of the mean plane; negative where it is turned
/// away.
inline double towards(const Vec3& w, const Vec2& slope)
{
    return w.z - w.x * slope.x - w.y * slope.y;
}

/// The mirror limit of a rough face: how much of its slopes mirror a light into a view.
///
///   p(slope of h - slope) / (4 h.z^4),   p Gaussian, variance base_alpha^2 / 2 along s and t
///
/// per area of the mean plane and unit irradiance; over the projected area that a view sees it is
/// radiance. Derived in docs/validation.md.
class MirrorLobe {
public:
    /// wo, wi      unit, z > 0
    /// base_alpha  Beckmann roughness of the faces, > 0
    MirrorLobe(const Vec3& wo, const Vec3& wi, double base_alpha)
        : precision_(1 / (base_alpha * base_alpha))
    {
        constexpr double kPi = 3.14159265358979323846;
        const Vec3 h = (wo + wi).normalized();
        slope_ = {-h.x / h.z, -h.y / h.z};
        peak_ = precision_ / kPi / (4 * h.z * h.z * h.z * h.z);
    }

    [[nodiscard]] double at(const Vec2& slope) const
    {
        return peak_ * std::exp(-precision_ * (slope_ - slope).length2());
    }

private:
    double precision_; ///< 1 / (2 variance)
    Vec2 slope_{0, 0}; ///< of the half vector
    double peak_ = 0;
};

} // namespace scree::reference
