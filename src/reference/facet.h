#pragma once

#include <cmath>

#include "math/normal.h"
#include "math/vec.h"

namespace scree::reference {

/// Projected area towards w of a face, per area of the mean plane; negative where it is turned
/// away.
inline double towards(const Vec3& w, const Vec2& slope)
{
    return w.z - w.x * slope.x - w.y * slope.y;
}

/// What rough faces hide of themselves towards w: Smith's Lambda, by which a face shows the share
/// 1 / (1 + Lambda) of its own slopes' facing area.
///
///   Lambda = E[max(0, -A)] / E[A] = phi(z) / z - Phi(-z),   z = a / b
///
/// A is the projected area of what has one of the face's Gaussian slopes, of mean a = towards(w,
/// slope) and deviation b = base_alpha sqrt((w.x^2 + w.y^2) / 2). Derived in docs/validation.md.
class OwnMasking {
public:
    /// w           unit, z > 0
    /// base_alpha  Beckmann roughness of the faces, > 0: Gaussian slopes about a face's own, of
    ///             variance base_alpha^2 / 2 along s and t
    OwnMasking(const Vec3& w, double base_alpha)
        : spread_(base_alpha * std::sqrt((w.x * w.x + w.y * w.y) / 2))
    {}

    /// area  towards(w, slope) of a face, > 0
    [[nodiscard]] double lambda(double area) const
    {
        if (!(spread_ > 0))
            return 0;
        const double z = area / spread_;
        return normal_pdf(z) / z - normal_cdf(-z);
    }

private:
    double spread_;
};

/// The mirror limit of a rough face: how much of its slopes mirror a light into a view and are
/// seen and lit.
///
///   p(slope of h - slope) / (4 h.z^4 (1 + Lambda_o + Lambda_i))
///
/// per area of the mean plane and unit irradiance; over the projected area that a view sees it is
/// radiance. p is the Gaussian of the face's slopes, Lambda what OwnMasking has of view and light.
/// Derived in docs/validation.md.
class MirrorLobe {
public:
    /// wo, wi      unit, z > 0
    /// base_alpha  as of OwnMasking
    MirrorLobe(const Vec3& wo, const Vec3& wi, double base_alpha)
        : precision_(1 / (base_alpha * base_alpha))
    {
        constexpr double kPi = 3.14159265358979323846;
        const Vec3 h = (wo + wi).normalized();
        slope_ = {-h.x / h.z, -h.y / h.z};
        peak_ = precision_ / kPi / (4 * h.z * h.z * h.z * h.z);
    }

    [[nodiscard]] double at(const Vec2& slope, double lambda_o, double lambda_i) const
    {
        const double mirrored = peak_ * std::exp(-precision_ * (slope_ - slope).length2());
        return mirrored / (1 + lambda_o + lambda_i);
    }

private:
    double precision_; ///< 1 / (2 variance)
    Vec2 slope_{0, 0}; ///< of the half vector
    double peak_ = 0;
};

} // namespace scree::reference
