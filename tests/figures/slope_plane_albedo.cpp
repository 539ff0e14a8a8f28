#include "figures/slope_plane_albedo.h"

#include <cmath>

#include "figures/slope_shading.h"
#include "judge/view_check.h"

namespace scree::test {

double plane_albedo(double angle_deg, double base_alpha, bool masked)
{
    constexpr double kPi = 3.14159265358979323846;
    constexpr int kSteps = 720;
    const Vec3 wo = direction(angle_deg, 0);
    const filter::Slopes<double> flat;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double theta = 90 * (i + 0.5) / kSteps, phi = 180 * (j + 0.5) / kSteps;
            const Vec3 wi = direction(theta, phi);
            const double area = kPi / 2 / kSteps * (2 * kPi / kSteps) * // of both sides
                                std::sin(theta * kPi / 180);
            sum += area * (masked ? filter::specular(wo, wi, flat, base_alpha)
                                  : specular_without_base_masking(wo, wi, flat, base_alpha));
        }
    return sum;
}

} // namespace scree::test
