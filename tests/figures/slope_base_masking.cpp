#include "figures/slope_base_masking.h"

#include <cmath>

#include "figures/slope_shading.h"
#include "judge/view_check.h"
#include "reference/facet.h"
#include "reference/jitter.h"

namespace scree::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr size_t kGrid = 96; ///< samples along a side of the map
constexpr uint64_t kSeed = 7;
constexpr size_t kJudged = SlopeViews::kNodes * SlopeViews::kAzimuths;

/// Smith's Lambda of a facet's own Gaussian slopes, variance base_alpha^2 / 2, about a slope that
/// faces w.
double own_lambda(const Vec3& w, const Vec2& slope, double base_alpha)
{
    const double spread = base_alpha * std::sqrt((w.x * w.x + w.y * w.y) / 2);
    if (!(spread > 0))
        return 0;
    const double z = reference::towards(w, slope) / spread;
    return std::exp(-z * z / 2) / (std::sqrt(2 * kPi) * z) - std::erfc(z / std::sqrt(2.0)) / 2;
}

/// Sums of one view and light: radiance without and with the facets' own masking.
struct Sums {
    double bare = 0, masked = 0;
};

class Gatherer {
public:
    Gatherer(const reference::DisplacedSurface& surface, const SlopeViews& views)
        : surface_(surface), views_(views), area_(kJudged)
    {
        for (std::vector<Sums>& sums : sums_)
            sums.resize(kJudged * views.lights.size());
        for (size_t view = 0; view < kJudged; ++view)
            for (const Vec3& light : views.lights)
                for (size_t base = 0; base < kBaseAlphas.size(); ++base)
                    lobes_[base].emplace_back(views.judged[view], light, kBaseAlphas[base]);
    }

    void add(double s, double t);
    [[nodiscard]] double area(size_t view) const { return area_[view]; }
    [[nodiscard]] Sums radiance(size_t base, size_t view, size_t light) const
    {
        const Sums& sums = sums_[base][view * views_.lights.size() + light];
        return {sums.bare / area_[view], sums.masked / area_[view]};
    }

private:
    bool sees(const Vec3& w, double s, double t, const Vec2& slope) const
    {
        return reference::towards(w, slope) > 0 && surface_.is_open(s, t, w);
    }
    void add_pair(size_t view, size_t light, const Vec2& slope, double weight);

    const reference::DisplacedSurface& surface_;
    const SlopeViews& views_;
    std::array<std::vector<reference::MirrorLobe>, kBaseAlphas.size()> lobes_;
    std::array<std::vector<Sums>, kBaseAlphas.size()> sums_;
    std::vector<double> area_;
};

void Gatherer::add_pair(size_t view, size_t light, const Vec2& slope, double weight)
{
    const size_t pair = view * views_.lights.size() + light;
    for (size_t base = 0; base < kBaseAlphas.size(); ++base) {
        const double bare = weight * lobes_[base][pair].at(slope);
        const double lambda = own_lambda(views_.judged[view], slope, kBaseAlphas[base]) +
                              own_lambda(views_.lights[light], slope, kBaseAlphas[base]);
        sums_[base][pair].bare += bare;
        sums_[base][pair].masked += bare / (1 + lambda);
    }
}

void Gatherer::add(double s, double t)
{
    const reference::SurfacePoint point = surface_.at(s, t);
    if (!(point.weight > 0))
        return;
    std::vector<size_t> lights;
    for (size_t light = 0; light < views_.lights.size(); ++light)
        if (sees(views_.lights[light], s, t, point.slope))
            lights.push_back(light);
    for (size_t view = 0; view < kJudged; ++view) {
        const Vec3& wo = views_.judged[view];
        if (!sees(wo, s, t, point.slope))
            continue;
        area_[view] += point.weight * reference::towards(wo, point.slope);
        for (const size_t light : lights)
            add_pair(view, light, point.slope, point.weight);
    }
}

} // namespace

BaseMaskingFigures measure_base_masking(const reference::DisplacedSurface& surface,
                                        const SlopesOfSize& map, const SlopeViews& views)
{
    Gatherer gatherer(surface, views);
    const reference::SharePositions along_s(map.places.front().s), along_t(map.places.front().t);
    for (size_t j = 0; j < kGrid; ++j)
        for (size_t i = 0; i < kGrid; ++i) {
            const auto inside = reference::jitter(kSeed, 0, j * kGrid + i);
            gatherer.add(along_s.at((static_cast<double>(i) + inside[0]) / kGrid),
                         along_t.at((static_cast<double>(j) + inside[1]) / kGrid));
        }

    BaseMaskingFigures figures;
    const filter::Slopes<double>& baked = map.baked.front();
    for (size_t view = 0; view < kJudged; ++view)
        for (size_t light = 0; gatherer.area(view) > 0 && light < views.lights.size(); ++light)
            for (size_t base = 0; base < kBaseAlphas.size(); ++base) {
                const Vec3 &wo = views.judged[view], &wi = views.lights[light];
                const auto [bare, masked] = gatherer.radiance(base, view, light);
                const double kernel = filter::specular(wo, wi, baked, kBaseAlphas[base]);
                const double kernel_bare =
                    specular_without_base_masking(wo, wi, baked, kBaseAlphas[base]);
                const size_t angle = view / SlopeViews::kAzimuths;
                const double area = gatherer.area(view);
                auto& of_base = figures.bases[base];
                of_base.kernel[angle].add(area, kernel - bare, bare);
                of_base.kernel_bare[angle].add(area, kernel_bare - bare, bare);
                of_base.kernel_masked[angle].add(area, kernel - masked, masked);
                of_base.kernel_bare_masked[angle].add(area, kernel_bare - masked, masked);
            }
    return figures;
}

double plane_albedo(double angle_deg, double base_alpha, bool masked)
{
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
