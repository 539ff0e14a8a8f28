#include "tables/traced_brdf.h"

#include <algorithm>
#include <cmath>

#include "reference/facet.h"
#include "reference/jitter.h"
#include "tables/schlick.h"

namespace scree {

namespace {

using reference::OwnMasking;
using reference::towards;

constexpr double kPi = 3.14159265358979323846;
constexpr double kLeastCosine = 0.02;

Vec3 raised(const Vec3& w)
{
    if (w.z >= kLeastCosine)
        return w;
    const double scale =
        std::sqrt((1 - kLeastCosine * kLeastCosine) / std::max(w.x * w.x + w.y * w.y, 1e-300));
    return {scale * w.x, scale * w.y, kLeastCosine};
}

} // namespace

TracedBrdf::TracedBrdf(const reference::DisplacedSurface& surface, const TracedBrdfOptions& options)
    : surface_(surface), options_(options)
{
    const reference::Relief& relief = surface.relief();
    const auto grid = static_cast<uint64_t>(options.grid);
    for (uint64_t n = 0; n < grid * grid; ++n) {
        const uint64_t column = n % grid, row = n / grid;
        const auto place = reference::jitter(options.seed, 0, n);
        const auto turn = reference::jitter(options.seed, 1, n);
        const double s = relief.width * (static_cast<double>(column) + place[0]) / options.grid;
        const double t = relief.height * (static_cast<double>(row) + place[1]) / options.grid;
        const reference::SurfacePoint point = surface.at(s, t);
        if (!(point.weight > 0))
            continue;
        const double angle = 2 * kPi * turn[0];
        samples_.push_back({s, t, point, std::cos(angle), std::sin(angle), turn[1] < 0.5});
        weight_ += point.weight;
    }
}

Rgbf TracedBrdf::operator()(const filter::Directions<double>& w) const
{
    const Vec3 view = raised(w.wo), light = raised(w.wi);
    const double fresnel =
        schlick(options_.f0, std::sqrt(std::max(0.5 * (1 + view.dot(light)), 0.0)));
    reference::Rgb sum{};
    for (const Sample& sample : samples_) {
        const auto turned = [&sample](const Vec3& v) {
            const double y = sample.mirrored ? -v.y : v.y;
            return Vec3(sample.cosine * v.x - sample.sine * y,
                        sample.sine * v.x + sample.cosine * y, v.z);
        };
        const Vec3 wo = turned(view), wi = turned(light);
        const reference::SurfacePoint& point = sample.point;
        const double facing_o = towards(wo, point.slope), facing_i = towards(wi, point.slope);
        // A face turned away is in its own shadow.
        if (!(facing_o > 0 && facing_i > 0) || !surface_.is_open(sample.s, sample.t, wo) ||
            !surface_.is_open(sample.s, sample.t, wi))
            continue;
        const double lobe =
            reference::MirrorLobe(wo, wi, options_.base_alpha)
                .at(point.slope, OwnMasking(wo, options_.base_alpha).lambda(facing_o),
                    OwnMasking(wi, options_.base_alpha).lambda(facing_i));
        const double white = facing_o * facing_i / (kPi * std::sqrt(1 + point.slope.length2()));
        for (size_t c = 0; c < 3; ++c)
            sum[c] += point.weight * (point.color[c] * white + fresnel * lobe);
    }
    const double per = 1 / std::max(weight_ * view.z * light.z, 1e-300);
    return {static_cast<float>(sum[0] * per), static_cast<float>(sum[1] * per),
            static_cast<float>(sum[2] * per)};
}

} // namespace scree
