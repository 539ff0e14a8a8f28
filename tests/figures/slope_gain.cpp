#include "figures/slope_gain.h"

namespace scree::test {
namespace {

using Covariance = filter::Covariance<double>;

double product(const Covariance& a, const Covariance& b)
{
    return a.ss * b.ss + 2 * a.st * b.st + a.tt * b.tt;
}

} // namespace

SeenSlopes unchanged(const filter::Slopes<double>& baked) { return {baked.mean, baked.covariance}; }

SeenSlopes closed_form(const Vec3& w, const filter::Slopes<double>& baked, double tau)
{
    filter::Slopes<double> slopes = baked;
    slopes.tau = tau;
    const auto visible = filter::visible_slopes(w, slopes);
    return {visible.mean, visible.covariance};
}

SlopeGain fitted_gain(const SlopesOfSize& size, const SlopeViews& views)
{
    double mean = 0, mean_all = 0, covariance = 0, covariance_all = 0;
    for (size_t i = 0; i < size.baked.size(); ++i)
        for (size_t v = 1; v < views.fitted.size(); ++v) {
            const reference::Seen& seen = size.fitted[i].all.seen[v];
            const SeenSlopes truth = seen_slopes(seen);
            const SeenSlopes closed =
                closed_form(views.fitted[v], size.baked[i], size.baked[i].tau);
            const Vec2 shift = closed.mean - size.baked[i].mean;
            mean += seen.area * shift.dot(truth.mean - size.baked[i].mean);
            mean_all += seen.area * shift.length2();
            covariance += seen.area * product(closed.covariance, truth.covariance);
            covariance_all += seen.area * product(closed.covariance, closed.covariance);
        }
    return {mean_all > 0 ? mean / mean_all : 1,
            covariance_all > 0 ? covariance / covariance_all : 1};
}

SeenSlopes gained(const Vec3& w, const filter::Slopes<double>& baked, const SlopeGain& gain)
{
    const SeenSlopes closed = closed_form(w, baked, baked.tau);
    const auto& [ss, st, tt] = closed.covariance;
    const double q = gain.covariance;
    return {baked.mean + (closed.mean - baked.mean) * gain.mean, {q * ss, q * st, q * tt}};
}

} // namespace scree::test
