#include "figures/mesh_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "figures/markdown.h"
#include "math/error.h"

namespace scree::test {
namespace {

/// A value and what it counts; area or texels.
struct Counted {
    double value = 0, weight = 1;
};

double quantile(std::vector<Counted> values, double share)
{
    std::sort(values.begin(), values.end(),
              [](const Counted& a, const Counted& b) { return a.value < b.value; });
    double all = 0, sum = 0;
    for (const Counted& one : values)
        all += one.weight;
    for (const Counted& one : values)
        if ((sum += one.weight) >= share * all)
            return one.value;
    throw Error("no texels to measure");
}

double share_above(const std::vector<Counted>& values, double bound)
{
    double all = 0, above = 0;
    for (const Counted& one : values) {
        all += one.weight;
        above += one.value > bound ? one.weight : 0;
    }
    return above / all;
}

void print_quantiles(const std::string& what, const std::vector<Counted>& values)
{
    std::vector<std::string> row = {what};
    for (const double share : {0.0, 0.05, 0.5, 0.95, 1.0})
        row.push_back(fmt::format("{:.3g}", quantile(values, share)));
    print_row(row);
}

double squared_norm(const TexelMetric& texel)
{
    const TextureJacobian j = texture_jacobian(texel.tangents);
    return j.xs * j.xs + j.xt * j.xt + j.yt * j.yt;
}

/// A texel of a coarser level, from both sets; a and b are the singular values of J.
struct CoarseTexel {
    double area = 0;            ///< mean world area per texture area
    double spread = 0;          ///< mean over the surface of (1 / a^2 + 1 / b^2) / 2
    double mesh = 0, plane = 0; ///< slope variance
};

/// Nothing where a part of the texel is outside of all charts: the plane's holds slopes then that
/// the mesh's does not.
std::optional<CoarseTexel> coarse_metric(const MetricGrid& grid, int x, int y, int side)
{
    CoarseTexel texel;
    for (int j = y * side; j < (y + 1) * side; ++j)
        for (int i = x * side; i < (x + 1) * side; ++i) {
            const TexelMetric& fine = grid.at(i, j);
            if (!(fine.area > 0))
                return std::nullopt;
            texel.area += fine.area / (side * side);
            // Their squares add up to |J|^2, their product is the area.
            texel.spread += squared_norm(fine) / (2 * fine.area) / (side * side);
        }
    texel.spread /= texel.area;
    return texel;
}

std::vector<CoarseTexel> coarse_texels(const MetricGrid& grid, const MeshAndPlane& sets, int level)
{
    const SetLevel mesh = sets.level(true, Map::slope, level);
    const SetLevel plane = sets.level(false, Map::slope, level);
    std::vector<CoarseTexel> texels;
    for (int y = 0; y < mesh.height(); ++y)
        for (int x = 0; x < mesh.width(); ++x) {
            auto texel = coarse_metric(grid, x, y, grid.size / mesh.width());
            if (!texel)
                continue;
            const Vec2 place((x + 0.5) / mesh.width(), (y + 0.5) / mesh.height());
            texel->mesh = slope_variance(mesh, place);
            texel->plane = slope_variance(plane, place);
            texels.push_back(*texel);
        }
    return texels;
}

} // namespace

const TexelMetric& MetricGrid::at(int x, int y) const
{
    return texels[static_cast<size_t>(y) * static_cast<size_t>(size) + static_cast<size_t>(x)];
}

const TexelMetric& MetricGrid::at(const Vec2& place) const
{
    const auto texel = [&](double along) {
        return std::clamp(static_cast<int>(along * size), 0, size - 1);
    };
    return at(texel(place.x), texel(place.y));
}

MetricGrid metric_grid(const LimitSurface& surface, int size)
{
    MetricGrid grid;
    grid.size = size;
    grid.texels.resize(static_cast<size_t>(size) * static_cast<size_t>(size));
    TexelMetrics(surface).rows({size, size}, 0, size, grid.texels.data());
    return grid;
}

double unit_length(const TexelMetric& texel) { return std::sqrt(texel.area); }

double anisotropy(const TexelMetric& texel)
{
    // Half of a / b + b / a, with a, b the singular values.
    const double mean = squared_norm(texel) / (2 * texel.area);
    return mean + std::sqrt(std::max(0.0, mean * mean - 1));
}

MeshAndPlane::MeshAndPlane(const std::string& mesh_set, const std::string& plane_set)
    : mesh(mesh_set), plane(plane_set), of_mesh(read_manifest(mesh_set)),
      of_plane(read_manifest(plane_set))
{
    if (!of_mesh.mesh || of_plane.mesh)
        throw Error("expected a set of a mesh and one of a plane: " + mesh + ", " + plane);
    if (of_mesh.width != of_plane.width || of_mesh.height != of_plane.height)
        throw Error(mesh + ", " + plane + ": not of one size");
}

SetLevel MeshAndPlane::level(bool on_mesh, Map map, int level) const
{
    for (const TextureRecord& texture : (on_mesh ? of_mesh : of_plane).textures)
        if (texture.map == map)
            return {std::filesystem::path(on_mesh ? mesh : plane) / texture.file, level};
    throw Error((on_mesh ? mesh : plane) + ": no texture " + map_info(map).name +
                ", which the picture needs");
}

double MeshAndPlane::plane_length() const { return of_plane.texel_width * of_plane.width; }

void print_metric(const MetricGrid& grid, const MeshAndPlane& sets)
{
    const SetLevel height = sets.level(true, Map::height, 0);
    const size_t h = height.channel("h");
    std::vector<Counted> lengths, ratios, displaced;
    for (int y = 0; y < grid.size; ++y)
        for (int x = 0; x < grid.size; ++x) {
            const TexelMetric& texel = grid.at(x, y);
            if (!(texel.area > 0))
                continue;
            lengths.push_back({unit_length(texel), 1});
            ratios.push_back({anisotropy(texel), 1});
            const Vec2 place((x + 0.5) / grid.size, (y + 0.5) / grid.size);
            const double world = sets.of_mesh.h0 + sets.of_mesh.h1 * height.at(place, h);
            displaced.push_back(
                {displacement_error(world, static_cast<double>(texel.curvature)), texel.area});
        }
    print_head({"of texels in charts", "least", "5 %", "median", "95 %", "largest"});
    print_quantiles("world units a texture unit, sqrt(xs yt)", lengths);
    print_quantiles("anisotropy of J", ratios);
    fmt::print("\nheight times curvature, by area: median {:.2g}, above 0.01 in {} %, above 0.1 in "
               "{} %\n\n",
               quantile(displaced, 0.5), percent(share_above(displaced, 0.01)),
               percent(share_above(displaced, 0.1)));
}

void print_spread(const MeshAndPlane& sets)
{
    fmt::print("rms slope: mesh {:.3f}, plane of {:.3g} units a side {:.3f}\n\n",
               sets.of_mesh.levels.front().rms_slope.value(), sets.plane_length(),
               sets.of_plane.levels.front().rms_slope.value());
    print_head({"level", "slope sigma inside texels, mesh", "plane"});
    constexpr size_t kLevels = 6; // above, nothing changes
    for (size_t i = 0; i < std::min(kLevels, sets.of_mesh.levels.size()); ++i)
        print_row({fmt::format("{}", i),
                   fmt::format("{:.3f}", sets.of_mesh.levels[i].slope_sigma.value()),
                   fmt::format("{:.3f}", sets.of_plane.levels.at(i).slope_sigma.value())});
    fmt::print("\n");
}

void print_ratios(const MetricGrid& grid, const MeshAndPlane& sets, int level)
{
    auto texels = coarse_texels(grid, sets, level);
    std::sort(texels.begin(), texels.end(),
              [](const CoarseTexel& a, const CoarseTexel& b) { return a.area < b.area; });
    constexpr size_t kGroups = 5;
    fmt::print("{} texels of level {} wholly in charts, by area; medians\n\n", texels.size(),
               level);
    print_head({"fifth", "world units a texture unit", "variance, mesh over plane",
                "from the metric alone"});
    for (size_t group = 0; group < kGroups; ++group) {
        std::vector<Counted> lengths, expected, ratios;
        for (size_t i = group * texels.size() / kGroups; i < (group + 1) * texels.size() / kGroups;
             ++i) {
            const CoarseTexel& one = texels[i];
            lengths.push_back({std::sqrt(one.area)});
            expected.push_back({sets.plane_length() * sets.plane_length() * one.spread});
            ratios.push_back({one.mesh / one.plane});
        }
        print_row({fmt::format("{}", group + 1), fmt::format("{:.2f}", quantile(lengths, 0.5)),
                   fmt::format("{:.2f}", quantile(ratios, 0.5)),
                   fmt::format("{:.2f}", quantile(expected, 0.5))});
    }
}

} // namespace scree::test
