// The example of docs/linear-lights.md.

#include <kernel/linear_light.h>

using Imath::V3f;
using namespace scree;

// What a footprint reflects of a tube of radiance 1 and width 1: times its radiance and width,
// Fresnel, transmittance and visibility. Ends from the point, in the frame of the set.
float tube(const filter::LinearLight<float>& light, const V3f& to_viewer,
           const filter::Slopes<float>& slopes, float base_alpha)
{
    const auto view = filter::linear_view(light, filter::normal(slopes.mean), to_viewer);
    const auto peak = filter::linear_peak(view.viewer, view.normal, 4);
    const float sigma2 = filter::ward_sigma2(slopes.covariance, base_alpha);
    return sigma2 < 0.01f ? filter::linear_reflection(view, peak, sigma2)
                          : filter::linear_quadrature(view, peak, sigma2, 2);
}
