// The example of docs/filtering.md.

#include <kernel/filter.h>

using Imath::V3f;
using namespace scree;

// One filtered lookup in each texture; directions in the tangent frame, y down the image.
V3f shade(const filter::SlopeMoments<float>& slope, float tau, const V3f& color, float h, float hh,
          const V3f& color_height, const V3f& to_viewer, const V3f& to_light, float base_alpha)
{
    const auto slopes = filter::slopes(slope, tau);
    const float exponent =
        filter::masking(to_viewer, slopes).lambda + filter::masking(to_light, slopes).lambda;
    const V3f visible =
        filter::color_by_height(color, color_height, h, hh, filter::visible_height(exponent));
    return visible * (filter::diffuse(to_viewer, to_light, slopes) / 3.14159265f) +
           V3f(0.04f) * filter::specular(to_viewer, to_light, slopes, base_alpha);
}
