#include "figures/flat_places.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/facet.h"
#include "reference/jitter.h"

namespace scree::test {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFlat = 0.2;
constexpr uint64_t kGrid = 160;

} // namespace

FlatPlaces flat_places(const reference::DisplacedSurface& surface, double angle_deg)
{
    const reference::Relief& relief = surface.relief();
    std::vector<double> heights = relief.heights;
    std::sort(heights.begin(), heights.end());
    const auto rank_of = [&heights](double height) {
        const auto below = std::lower_bound(heights.begin(), heights.end(), height);
        return static_cast<double>(below - heights.begin()) / static_cast<double>(heights.size());
    };
    const double sine = std::sin(angle_deg * kPi / 180), cosine = std::cos(angle_deg * kPi / 180);
    FlatPlaces found;
    double count = 0, facing = 0;
    for (uint64_t n = 0; n < kGrid * kGrid; ++n) {
        const uint64_t column = n % kGrid, row = n / kGrid;
        const auto place = reference::jitter(1, 0, n);
        const double s = relief.width * (static_cast<double>(column) + place[0]) / kGrid;
        const double t = relief.height * (static_cast<double>(row) + place[1]) / kGrid;
        const reference::SurfacePoint point = surface.at(s, t);
        const double azimuth = 2 * kPi * reference::jitter(1, 1, n)[0];
        const Vec3 wo(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
        const Vec3 wi(-wo.x, -wo.y, wo.z);
        const double area = reference::towards(wo, point.slope);
        facing += std::max(area, 0.0);
        if (point.slope.length() > kFlat || !(area > 0) ||
            !(reference::towards(wi, point.slope) > 0))
            continue;
        ++count;
        found.height_rank += rank_of(point.height);
        if (!surface.is_open(s, t, wo))
            continue;
        ++found.open;
        found.open_both += surface.is_open(s, t, wi) ? 1 : 0;
    }
    const double lambda = facing / static_cast<double>(kGrid * kGrid) / cosine - 1;
    for (double* mean : {&found.open, &found.open_both, &found.height_rank})
        *mean /= std::max(count, 1.0);
    found.smith_both = 1 / (1 + 2 * lambda);
    return found;
}

} // namespace scree::test
