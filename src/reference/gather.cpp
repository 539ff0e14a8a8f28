#include "reference/gather.h"

#include <cassert>
#include <cmath>
#include <mutex>

#include <tbb/parallel_for.h>

#include "reference/facet.h"
#include "reference/jitter.h"
#include "reference/view_sums.h"

namespace scree::reference {
namespace {

class Gatherer {
public:
    Gatherer(const DisplacedSurface& surface, const GatherPlan& plan);

    Estimate run(const Footprint& footprint, uint64_t index);

private:
    void add(GatherSums& sums, double s, double t, const SurfacePoint& point);
    bool add_views(GatherSums& sums, double s, double t, const SurfacePoint& point);
    void add_light(GatherSums& sums, size_t light, const SurfacePoint& point);
    bool is_open(double s, double t, const Vec3& w)
    {
        ++rays_;
        return surface_.is_open(s, t, w);
    }

    const DisplacedSurface& surface_;
    const GatherPlan& plan_;
    std::vector<OwnMasking> masking_of_views_, masking_of_lights_;
    std::vector<MirrorLobe> lobes_; ///< views x lights
    std::vector<double> visible_;   ///< of each view at this sample: V W weight
    std::vector<double> lambdas_;   ///< of each view that sees this sample
    long long rays_ = 0;
};

Gatherer::Gatherer(const DisplacedSurface& surface, const GatherPlan& plan)
    : surface_(surface), plan_(plan), visible_(plan.views.size()), lambdas_(plan.views.size())
{
    for (const Vec3& light : plan.lights)
        masking_of_lights_.emplace_back(light, plan.base_alpha);
    for (const Vec3& view : plan.views) {
        masking_of_views_.emplace_back(view, plan.base_alpha);
        for (const Vec3& light : plan.lights)
            lobes_.emplace_back(view, light, plan.base_alpha);
    }
}

bool Gatherer::add_views(GatherSums& sums, double s, double t, const SurfacePoint& point)
{
    bool any = false;
    for (size_t v = 0; v < plan_.views.size(); ++v) {
        const double facing = towards(plan_.views[v], point.slope);
        const double area = point.weight * facing;
        visible_[v] = 0;
        if (!(area > 0))
            continue;
        SeenSums& seen = sums.seen[v];
        seen.facing += area;
        if (!is_open(s, t, plan_.views[v]))
            continue;
        visible_[v] = area;
        lambdas_[v] = masking_of_views_[v].lambda(facing);
        any = true;
        seen.area += area;
        for (size_t c = 0; c < 3; ++c)
            seen.color[c] += area * point.color[c];
        seen.slopes.add(area, point.slope);
    }
    return any;
}

/// Adds what a light, which reaches the point, shows of it to every view.
void Gatherer::add_light(GatherSums& sums, size_t light, const SurfacePoint& point)
{
    const double facing = towards(plan_.lights[light], point.slope);
    const double cosine = facing / std::sqrt(1 + point.slope.length2());
    const double lambda = masking_of_lights_[light].lambda(facing);
    for (size_t v = 0; v < plan_.views.size(); ++v) {
        if (!(visible_[v] > 0))
            continue;
        const size_t pair = v * plan_.lights.size() + light;
        LitSums& lit = sums.lit[pair];
        lit.open += visible_[v];
        for (size_t c = 0; c < 3; ++c) {
            lit.color[c] += visible_[v] * point.color[c];
            lit.diffuse[c] += visible_[v] * point.color[c] * cosine;
        }
        lit.white += visible_[v] * cosine;
        lit.specular += point.weight * lobes_[pair].at(point.slope, lambdas_[v], lambda);
    }
}

void Gatherer::add(GatherSums& sums, double s, double t, const SurfacePoint& point)
{
    sums.weight += point.weight;
    if (!add_views(sums, s, t, point))
        return;
    for (size_t l = 0; l < plan_.lights.size(); ++l) {
        // A face turned away from the light is in its own shadow.
        const Vec3& light = plan_.lights[l];
        if (towards(light, point.slope) > 0 && is_open(s, t, light))
            add_light(sums, l, point);
    }
}

Estimate Gatherer::run(const Footprint& footprint, uint64_t index)
{
    const SharePositions along_s(footprint.s), along_t(footprint.t);
    const size_t views = plan_.views.size(), lights = plan_.lights.size();
    std::array<GatherSums, 2> halves{GatherSums(views, lights), GatherSums(views, lights)};
    Estimate estimate;
    rays_ = 0;
    const auto grid = static_cast<uint64_t>(plan_.grid);
    for (uint64_t j = 0; j < grid; ++j)
        for (uint64_t i = 0; i < grid; ++i) {
            const auto inside = jitter(plan_.seed, index, j * grid + i);
            const double s = along_s.at((static_cast<double>(i) + inside[0]) / plan_.grid);
            const double t = along_t.at((static_cast<double>(j) + inside[1]) / plan_.grid);
            const SurfacePoint point = surface_.at(s, t);
            if (!(point.weight > 0))
                continue;
            ++estimate.samples;
            add(halves[half_of(plan_.seed, index, i, j)], s, t, point);
        }
    estimate.rays = rays_;
    for (size_t half = 0; half < 2; ++half)
        estimate.halves[half] = halves[half].mean();
    halves[0].add(halves[1]);
    estimate.all = halves[0].mean();
    return estimate;
}

} // namespace

Rgb radiance_of(const Lit& lit, double f0)
{
    Rgb radiance = lit.diffuse;
    for (double& c : radiance)
        c += f0 * lit.specular;
    return radiance;
}

Estimate gather(const DisplacedSurface& surface, const Footprint& footprint, const GatherPlan& plan,
                uint64_t index)
{
    assert(plan.grid > 0 && plan.base_alpha > 0);
    return Gatherer(surface, plan).run(footprint, index);
}

std::vector<Estimate> gather_all(const DisplacedSurface& surface,
                                 const std::vector<Footprint>& footprints, const GatherPlan& plan,
                                 const std::function<void(double)>& progress)
{
    std::vector<Estimate> estimates(footprints.size());
    std::mutex telling;
    size_t done = 0;
    tbb::parallel_for(size_t{0}, footprints.size(), [&](size_t i) {
        estimates[i] = gather(surface, footprints[i], plan, i);
        if (!progress)
            return;
        const std::lock_guard<std::mutex> lock(telling);
        progress(static_cast<double>(++done) / static_cast<double>(footprints.size()));
    });
    return estimates;
}

} // namespace scree::reference
