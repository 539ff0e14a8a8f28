#include "figures/slope_shading.h"

#include <algorithm>
#include <cmath>

#include "reference/facet.h"

namespace scree::test {
namespace {

constexpr double kPerPi = 0.31830988618379067154;

double facing(const Vec3& w, const Vec2& slope) { return w.z - w.x * slope.x - w.y * slope.y; }

/// The slope that mirrors, and what a density of slopes there is radiance by.
struct Mirror {
    Mirror(const Vec3& wo, const Vec3& wi)
    {
        const Vec3 h = (wo + wi).normalized();
        slope = {-h.x / h.z, -h.y / h.z};
        per_density = 1 / (4 * h.z * h.z * h.z * h.z);
    }
    Vec2 slope;
    double per_density = 0;
};

filter::Covariance<double> roughened(filter::Covariance<double> of, double base_alpha)
{
    of.ss += base_alpha * base_alpha / 2;
    of.tt += base_alpha * base_alpha / 2;
    return of;
}

double density(const Vec2& at, const Vec2& mean, const filter::Covariance<double>& of)
{
    return kernel::scree_slope_pdf(at.x, at.y, mean.x, mean.y, of.ss, of.st, of.tt);
}

double mean_cosine(const filter::VisibleSlopes<double>& lit)
{
    const auto& [ss, st, tt] = lit.covariance;
    return kernel::scree_mean_cosine(lit.mean.x, lit.mean.y, ss, st, tt);
}

} // namespace

double shadowing(const Vec3& wo, const Vec3& wi, const filter::Slopes<double>& baked)
{
    const auto of_view = filter::masking(wo, baked), of_light = filter::masking(wi, baked);
    return (1 + of_view.lambda) * filter::g2(of_view, of_light);
}

double diffuse_of(const SeenSlopes& seen, double open, const Vec3& wi)
{
    const auto lit = filter::visible_slopes<double>(wi, {seen.mean, seen.covariance, 0});
    return kPerPi * std::min(open * lit.area * mean_cosine(lit), 1.0);
}

double specular_of(const SeenSlopes& seen, double open, const Vec3& wo, const Vec3& wi,
                   double base_alpha)
{
    const Mirror mirror(wo, wi);
    const auto rough = roughened(seen.covariance, base_alpha);
    const double det = rough.ss * rough.tt - rough.st * rough.st;
    const Vec2 away = mirror.slope - seen.mean;
    const Vec2 solved((rough.tt * away.x - rough.st * away.y) / det,
                      (rough.ss * away.y - rough.st * away.x) / det);
    const auto& [ss, st, tt] = seen.covariance;
    const Vec2 facet =
        seen.mean + Vec2(ss * solved.x + st * solved.y, st * solved.x + tt * solved.y);
    const auto shown = [&](const Vec3& w) {
        return std::max(facing(w, facet), facing(w, seen.mean) / 4);
    };
    if (!(shown(wo) > 0 && shown(wi) > 0))
        return 0;
    const double own_g2 = 1 / (1 + reference::OwnMasking(wo, base_alpha).lambda(shown(wo)) +
                               reference::OwnMasking(wi, base_alpha).lambda(shown(wi)));
    return open * own_g2 * density(mirror.slope, seen.mean, rough) * mirror.per_density / shown(wo);
}

double specular_without_base_masking(const Vec3& wo, const Vec3& wi,
                                     const filter::Slopes<double>& baked, double base_alpha)
{
    filter::Slopes<double> gaussian = baked;
    gaussian.tau = 0;
    const Mirror mirror(wo, wi);
    const double mean_plane = std::max(facing(wo, baked.mean), 0.0);
    const double seen =
        filter::projected_area(wo, gaussian) + mean_plane * filter::masking(wi, gaussian).lambda;
    return density(mirror.slope, baked.mean, roughened(baked.covariance, base_alpha)) *
           mirror.per_density / std::max(seen, 1e-12);
}

} // namespace scree::test
