#include "chart/truth.h"

namespace scree {

namespace {

std::vector<reference::Estimate> gather(const reference::DisplacedSurface& surface,
                                        const std::vector<reference::Footprint>& places,
                                        const TruthPlan& plan,
                                        const std::function<void(double)>& progress)
{
    reference::GatherPlan what;
    what.views = plan.views.views;
    what.lights = plan.views.lights;
    what.base_alpha = static_cast<double>(plan.material.base_alpha);
    what.grid = plan.grid;
    what.seed = plan.seed;
    return gather_all(surface, places, what, progress);
}

/// `of` picks the whole or a half of an estimate.
template <class Of>
std::vector<Appearance> appearances(const std::vector<reference::Estimate>& estimates,
                                    const Material& material, Of of)
{
    std::vector<Appearance> all(estimates.size());
    for (size_t i = 0; i < all.size(); ++i)
        all[i] = appearance_of(of(estimates[i]), material.f0);
    return all;
}

std::vector<RelativeErrors> noise_of(const ErrorScale& yardstick, const Material& material,
                                     const std::vector<reference::Estimate>& estimates)
{
    const auto half = [&](size_t i) {
        return appearances(estimates, material,
                           [i](const reference::Estimate& e) { return e.halves[i]; });
    };
    std::vector<RelativeErrors> noise = rms_differences(yardstick, half(0), half(1));
    for (RelativeErrors& of_band : noise) {
        of_band.color /= 2;
        of_band.radiance /= 2;
    }
    return noise;
}

} // namespace

ChartTruth gather_truth(const reference::DisplacedSurface& surface,
                        const std::vector<reference::Footprint>& places, const TruthPlan& plan,
                        const BakeMonitor& monitor)
{
    const auto estimates =
        gather(surface, places, plan, [&monitor](double done) { monitor.report("truth", done); });
    ChartTruth truth;
    truth.yardstick = {
        plan.views,
        appearances(estimates, plan.material, [](const reference::Estimate& e) { return e.all; }),
        {}};
    for (const reference::Estimate& estimate : estimates) {
        std::vector<double>& areas = truth.yardstick.area.emplace_back();
        for (const reference::Seen& seen : estimate.all.seen)
            areas.push_back(seen.area);
        truth.rays += estimate.rays;
    }
    truth.noise = noise_of(truth.yardstick, plan.material, estimates);
    return truth;
}

std::vector<Appearance> supersample(const reference::DisplacedSurface& surface,
                                    const std::vector<reference::Footprint>& places,
                                    const TruthPlan& plan,
                                    const std::function<void(double)>& progress)
{
    return appearances(gather(surface, places, plan, progress), plan.material,
                       [](const reference::Estimate& e) { return e.all; });
}

} // namespace scree
