#include "figures/visibility_truth.h"

#include <cmath>
#include <functional>
#include <utility>

namespace scree::test {
namespace {

double square(double x) { return x * x; }

/// error  squared error of R, G, B together, of a footprint and a view
SquaresOfAngles mean_squares(const SeenOfSize& seen, const AllViews& views,
                             const std::function<double(size_t footprint, size_t view)>& error)
{
    SquaresOfAngles squares;
    for (size_t angle = 0; angle < views.angles_deg.size(); ++angle) {
        double sum = 0, area = 0;
        for (size_t i = 0; i < seen.truth.size(); ++i)
            for (size_t j = 0; j < AllViews::kAzimuths; ++j) {
                const size_t view = angle * AllViews::kAzimuths + j;
                const double of_view = seen.truth[i].all.seen[view].area;
                sum += of_view * error(i, view) / 3;
                area += of_view;
            }
        squares.push_back(sum / area);
    }
    return squares;
}

} // namespace

reference::Rgb mean_color_of(const reference::Relief& relief, const reference::Footprint& place)
{
    reference::Rgb sum{};
    for (size_t j = 0; j < place.t.share.size(); ++j)
        for (size_t i = 0; i < place.s.share.size(); ++i) {
            const size_t row = static_cast<size_t>(place.t.first) + j;
            const size_t column = static_cast<size_t>(place.s.first) + i;
            const reference::Rgb& color =
                relief.colors[row * static_cast<size_t>(relief.width) + column];
            for (size_t c = 0; c < 3; ++c)
                sum[c] += place.t.share[j] * place.s.share[i] * color[c];
        }
    return sum;
}

reference::Rgb SeenOfSize::color(size_t footprint, const reference::Gathered& of_samples,
                                 size_t view) const
{
    reference::Rgb color = of_samples.seen[view].color;
    for (size_t c = 0; c < 3; ++c) // views begin with one from straight above
        color[c] += mean_color[footprint][c] - of_samples.seen.front().color[c];
    return color;
}

AllViews::AllViews() : angles_deg{0, 30, 45, 60, 70, 75, 80, 83, 85, 87}
{
    constexpr double kRadian = 0.017453292519943295769;
    for (const double angle_deg : angles_deg)
        for (size_t j = 0; j < kAzimuths; ++j) {
            const double angle = angle_deg * kRadian;
            const double azimuth = (static_cast<double>(j) + 0.25) * 360 / kAzimuths * kRadian;
            views.emplace_back(std::sin(angle) * std::cos(azimuth),
                               std::sin(angle) * std::sin(azimuth), std::cos(angle));
        }
}

SeenOfSize see(const reference::DisplacedSurface& surface, const FootprintsOfSize& footprints,
               const AllViews& views)
{
    reference::GatherPlan plan;
    plan.views = views.views;
    return see(surface, footprints, std::move(plan));
}

SeenOfSize see(const reference::DisplacedSurface& surface, const FootprintsOfSize& footprints,
               reference::GatherPlan plan)
{
    plan.grid = footprints.grid;
    SeenOfSize seen{footprints.name, reference::gather_all(surface, footprints.places, plan), {}};
    for (const reference::Footprint& place : footprints.places)
        seen.mean_color.push_back(mean_color_of(surface.relief(), place));
    return seen;
}

SquaresOfAngles squares_of(const ColorOfView& model, const std::vector<SetTexel>& texels,
                           const SeenOfSize& seen, const AllViews& views, double mean_color)
{
    return mean_squares(seen, views, [&](size_t i, size_t view) {
        const Vec3& w = views.views[view];
        const Rgbf shown = model.color(texels[i], Vec3f(w));
        const reference::Rgb truth = seen.color(i, seen.truth[i].all, view);
        double sum = 0;
        for (size_t c = 0; c < 3; ++c)
            sum += square((static_cast<double>(shown[c]) - truth[c]) / mean_color);
        return sum;
    });
}

SquaresOfAngles squares_of_noise(const SeenOfSize& seen, const AllViews& views, double mean_color)
{
    return mean_squares(seen, views, [&](size_t i, size_t view) {
        const reference::Rgb one = seen.color(i, seen.truth[i].halves[0], view);
        const reference::Rgb other = seen.color(i, seen.truth[i].halves[1], view);
        double sum = 0;
        for (size_t c = 0; c < 3; ++c)
            sum += square((one[c] - other[c]) / 2 / mean_color);
        return sum;
    });
}

} // namespace scree::test
