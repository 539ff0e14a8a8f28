// The example of docs/k0.md.

#include <kernel/k0.h>

using Imath::V3f;
using namespace scree;

// A direction that K0 facets mirror wo to, of five random numbers, and its density per solid angle.
V3f mirrored(const V3f& wo, const filter::Slopes<float>& slopes, const float (&u)[5], float& pdf)
{
    const V3f m = filter::normal(k0::sample_visible(u, wo, slopes));
    pdf = k0::ndf(m, slopes) / (4 * k0::projected_area(wo, slopes));
    return 2 * wo.dot(m) * m - wo; // may be below the surface
}
