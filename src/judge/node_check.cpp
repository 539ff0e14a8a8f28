#include "judge/node_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "judge/picked_texels.h"

namespace scree {

namespace {

/// Area and R, G, B of a table's mean over the azimuth at a node.
using Moments = std::array<double, 4>;

/// The views of a table, straight above first.
std::vector<Vec3> node_views(const VisibilityRecord& table)
{
    std::vector<Vec3> views{{0, 0, 1}};
    for (const double angle_deg : table.node_angles_deg)
        for (int j = 0; j < table.azimuths; ++j)
            views.push_back(direction(angle_deg, (j + 0.25) * 360 / table.azimuths));
    return views;
}

/// What the table of a footprint should hold at a node.
Moments true_moments(const reference::Gathered& seen, const std::vector<Vec3>& views,
                     const VisibilityRecord& table, size_t node)
{
    const auto azimuths = static_cast<size_t>(table.azimuths);
    // E[c] of the same samples: its noise is no error of the difference.
    const reference::Rgb& mean = seen.seen.front().color;
    Moments moments{};
    for (size_t j = 0; j < azimuths; ++j) {
        const size_t view = 1 + node * azimuths + j;
        const reference::Seen& at = seen.seen[view];
        const double v = at.area / views[view].z;
        moments[0] += v - 1;
        for (size_t c = 0; c < 3; ++c)
            moments[1 + c] += at.color[c] * v - mean[c];
    }
    for (double& moment : moments)
        moment /= static_cast<double>(azimuths);
    return moments;
}

Moments stored_moments(const SetTexel& texel, const SetColors& colors,
                       const std::vector<Vec3>& views, size_t azimuths, size_t node)
{
    Moments moments{};
    for (size_t j = 0; j < azimuths; ++j) {
        const Vec3& w = views[1 + node * azimuths + j];
        const auto told = visibility_of(texel, colors, Vec3f(w));
        moments[0] += static_cast<double>(told.a);
        for (int c = 0; c < 3; ++c)
            moments[1 + static_cast<size_t>(c)] += static_cast<double>(told.beta[c]);
    }
    for (double& moment : moments)
        moment /= static_cast<double>(azimuths);
    return moments;
}

/// Sums of squares over footprints.
struct Sums {
    int footprints = 0;
    double area = 0, area_noise = 0, color = 0, color_noise = 0;

    void add(const Moments& stored, const Moments& truth, const Moments& half0,
             const Moments& half1)
    {
        ++footprints;
        for (size_t i = 0; i < stored.size(); ++i) {
            const double error = stored[i] - truth[i], noise = (half0[i] - half1[i]) / 2;
            (i == 0 ? area : color) += error * error;
            (i == 0 ? area_noise : color_noise) += noise * noise;
        }
    }
    void add(const Sums& other)
    {
        footprints += other.footprints;
        area += other.area;
        area_noise += other.area_noise;
        color += other.color;
        color_noise += other.color_noise;
    }
};

/// color  that errors of color are relative to
NodeErrors errors_of(const Sums& sums, int level, double angle_deg, double color)
{
    const double count = std::max(sums.footprints, 1);
    const double of_color = color > 0 ? 3 * count * color * color : 3 * count;
    return {level,
            angle_deg,
            sums.footprints,
            {std::sqrt(sums.area / count), std::sqrt(sums.area_noise / count)},
            {std::sqrt(sums.color / of_color), std::sqrt(sums.color_noise / of_color)}};
}

/// Rms of R, G, B of the map's mean color; 0 where it is not told.
double color_size(const Manifest& manifest)
{
    const auto color = manifest.levels.back().mean_color.value_or(std::array<double, 3>{});
    return std::sqrt((color[0] * color[0] + color[1] * color[1] + color[2] * color[2]) / 3);
}

} // namespace

bool has_tables(const SetReader& set) { return set.colors().best() == ColorModel::visible; }

NodeCheck check_nodes(SetReader& set, const reference::DisplacedSurface& surface,
                      const ViewPlan& plan, const std::function<void(double)>& progress)
{
    const VisibilityRecord table = *set.manifest().visibility;
    const std::vector<PickedTexel> picked = pick_texels(
        set, kFirstSeenLevel, std::min(plan.footprints, kMostNodeFootprints), plan.seed);
    reference::GatherPlan gathering;
    gathering.views = node_views(table);
    gathering.grid = plan.grid;
    gathering.seed = plan.seed;
    const GatheredTexels gathered = gather_texels(surface, picked, gathering, progress);
    const auto& truths = gathered.truths;
    NodeCheck check;
    check.samples = gathered.samples;
    check.rays = gathered.rays;
    check.seconds = gathered.seconds;

    const size_t nodes = table.node_angles_deg.size();
    std::vector<std::vector<Sums>> sums(set.manifest().levels.size(), std::vector<Sums>(nodes));
    for (size_t i = 0; i < picked.size(); ++i) {
        for (size_t node = 0; node < nodes; ++node) {
            const auto of = [&](const reference::Gathered& seen) {
                return true_moments(seen, gathering.views, table, node);
            };
            sums[static_cast<size_t>(picked[i].level)][node].add(
                stored_moments(picked[i].texel, set.colors(), gathering.views,
                               static_cast<size_t>(table.azimuths), node),
                of(truths[i].all), of(truths[i].halves[0]), of(truths[i].halves[1]));
        }
    }
    const double color = color_size(set.manifest());
    for (size_t node = 0; node < nodes; ++node) {
        const double angle_deg = table.node_angles_deg[node];
        Sums of_node;
        for (size_t level = 0; level < sums.size(); ++level) {
            of_node.add(sums[level][node]);
            check.levels.push_back(
                errors_of(sums[level][node], static_cast<int>(level), angle_deg, color));
        }
        check.all.push_back(errors_of(of_node, -1, angle_deg, color));
    }
    return check;
}

} // namespace scree
