#include "failures/seen.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scree::test {
namespace {

constexpr int kMapGrid = 724;
constexpr int kMostTexels = 16; // along a side

Vec3 view_at(double angle_deg, double azimuth_deg)
{
    const double degree = std::acos(-1.0) / 180;
    const double theta = angle_deg * degree, phi = azimuth_deg * degree;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

} // namespace

reference::DisplacedSurface displaced(const MemorySource& map)
{
    reference::Relief relief;
    relief.width = map.map_width;
    relief.height = map.map_height;
    relief.heights = map.heights;
    relief.colors = map.colors;
    return reference::DisplacedSurface(std::move(relief));
}

reference::Seen seen_of_map(const reference::DisplacedSurface& surface, double angle_deg,
                            double azimuth_deg)
{
    const int width = surface.relief().width, height = surface.relief().height;
    const int level = reference::level_count(width, height) - 1;
    reference::GatherPlan plan;
    plan.views = {view_at(angle_deg, azimuth_deg)};
    plan.grid = kMapGrid;
    const auto footprint = reference::footprint_of(width, height, level, 0, 0);
    return reference::gather(surface, footprint, plan, 0).all.seen[0];
}

std::vector<SeenTexel> seen_of_level(const reference::DisplacedSurface& surface, int level,
                                     double angle_deg, double azimuth_deg)
{
    const int width = surface.relief().width, height = surface.relief().height;
    const int columns = reference::level_size(width, level);
    const int rows = reference::level_size(height, level);
    const int across = std::min(columns, kMostTexels), down = std::min(rows, kMostTexels);
    std::vector<SeenTexel> texels;
    std::vector<reference::Footprint> footprints;
    for (int j = 0; j < down; ++j)
        for (int i = 0; i < across; ++i) {
            texels.push_back({i * columns / across, j * rows / down, {}});
            footprints.push_back(
                reference::footprint_of(width, height, level, texels.back().x, texels.back().y));
        }
    reference::GatherPlan plan;
    plan.views = {view_at(angle_deg, azimuth_deg)};
    const auto estimates = reference::gather_all(surface, footprints, plan);
    for (size_t i = 0; i < texels.size(); ++i)
        texels[i].seen = estimates[i].all.seen[0];
    return texels;
}

} // namespace scree::test
