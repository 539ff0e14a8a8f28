#include "figures/visibility_truth.h"

#include <cmath>
#include <functional>

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
    plan.grid = footprints.grid;
    return {footprints.name, reference::gather_all(surface, footprints.places, plan)};
}

SquaresOfAngles squares_of(const ColorOfView& model, const std::vector<SetTexel>& texels,
                           const SeenOfSize& seen, const AllViews& views, double mean_color)
{
    return mean_squares(seen, views, [&](size_t i, size_t view) {
        const Vec3& w = views.views[view];
        const Rgbf shown = model.color(texels[i], Vec3f(w));
        const reference::Rgb& truth = seen.truth[i].all.seen[view].color;
        double sum = 0;
        for (size_t c = 0; c < 3; ++c)
            sum += square((static_cast<double>(shown[c]) - truth[c]) / mean_color);
        return sum;
    });
}

SquaresOfAngles squares_of_noise(const SeenOfSize& seen, const AllViews& views, double mean_color)
{
    return mean_squares(seen, views, [&](size_t i, size_t view) {
        const auto& halves = seen.truth[i].halves;
        double sum = 0;
        for (size_t c = 0; c < 3; ++c)
            sum += square((halves[0].seen[view].color[c] - halves[1].seen[view].color[c]) / 2 /
                          mean_color);
        return sum;
    });
}

} // namespace scree::test
