#include "figures/slope_two_scales.h"

#include <cmath>

#include "figures/slope_shading.h"
#include "reference/facet.h"

namespace scree::test {
namespace {

/// Specular radiance over irradiance, without Fresnel, of rough facets:
///
///   G2 integral of P(m) p(slope of h - m) g2(m) dm / (4 h.z^4 a)
///
/// over the slopes m that face view and light. P is the Gaussian of the facets, G2 its masking and
/// a the projected area of its mean plane; p and g2 are the lobe and the masking of a facet
/// (reference/facet.h).
double specular_of_two_scales(const Vec3& wo, const Vec3& wi, const filter::Slopes<double>& facets,
                              double base_alpha)
{
    constexpr int kSteps = 60; // to each side, over 6 deviations
    const auto& [ss, st, tt] = facets.covariance;
    const double step_s = std::sqrt(ss) * 6 / kSteps, step_t = std::sqrt(tt) * 6 / kSteps;
    const reference::MirrorLobe lobe(wo, wi, base_alpha);
    const reference::OwnMasking of_view(wo, base_alpha), of_light(wi, base_alpha);
    double sum = 0;
    for (int j = -kSteps; j <= kSteps; ++j)
        for (int i = -kSteps; i <= kSteps; ++i) {
            const Vec2 m = facets.mean + Vec2(i * step_s, j * step_t);
            const double shown = reference::towards(wo, m), lit = reference::towards(wi, m);
            if (!(shown > 0 && lit > 0))
                continue;
            sum += kernel::scree_slope_pdf(m.x, m.y, facets.mean.x, facets.mean.y, ss, st, tt) *
                   lobe.at(m, of_view.lambda(shown), of_light.lambda(lit));
        }
    const double g2 = filter::g2(filter::masking(wo, facets), filter::masking(wi, facets));
    return sum * step_s * step_t * g2 / reference::towards(wo, facets.mean);
}

} // namespace

ScoresOfAngles kernel_on_two_scales(double rms_slope, double base_alpha, const SlopeViews& views,
                                    bool base_masks)
{
    filter::Slopes<double> facets;
    facets.covariance.ss = facets.covariance.tt = rms_slope * rms_slope / 2;
    ScoresOfAngles scores;
    for (size_t view = 0; view < SlopeViews::kNodes * SlopeViews::kAzimuths; ++view)
        for (const Vec3& wi : views.lights) {
            const Vec3& wo = views.judged[view];
            const double truth = specular_of_two_scales(wo, wi, facets, base_alpha);
            const double told = base_masks
                                    ? filter::specular(wo, wi, facets, base_alpha)
                                    : specular_without_base_masking(wo, wi, facets, base_alpha);
            scores[view / SlopeViews::kAzimuths].add(1, told - truth, truth);
        }
    return scores;
}

} // namespace scree::test
