#pragma once

#include <string>
#include <vector>

#include "figures/set_level.h"
#include "surface/texel_metric.h"
#include "texset/manifest.h"

namespace scree::test {

/// What a mesh says about square textures, by rows.
struct MetricGrid {
    int size = 1;
    std::vector<TexelMetric> texels;

    [[nodiscard]] const TexelMetric& at(int x, int y) const;
    /// The texel that (s, t) in [0, 1) lies in.
    [[nodiscard]] const TexelMetric& at(const Vec2& place) const;
};

MetricGrid metric_grid(const LimitSurface& surface, int size);

/// How long a texture unit is on the surface, both directions together: sqrt(area).
double unit_length(const TexelMetric& texel);

/// The larger over the smaller singular value of J (surface/metric.h): 1 where nothing is
/// stretched more in one direction than in the other.
double anisotropy(const TexelMetric& texel);

/// A heights-only set of a mesh and the same baked on a plane.
struct MeshAndPlane {
    std::string mesh, plane; ///< folders
    Manifest of_mesh, of_plane;

    MeshAndPlane(const std::string& mesh_set, const std::string& plane_set);
    /// A texture of one of the two. throws Error where the set has none such
    [[nodiscard]] SetLevel level(bool on_mesh, Map map, int level) const;
    /// World units a texture unit of the plane.
    [[nodiscard]] double plane_length() const;
};

/// Tables for docs/surfaces.md, on stdout: the metric, the sets' spread of slopes by level, and
/// what one has to do with the other at a level: variance on the mesh over that on the plane, and
/// what it would be of slopes alike in all directions.
void print_metric(const MetricGrid& grid, const MeshAndPlane& sets);
void print_spread(const MeshAndPlane& sets);
void print_ratios(const MetricGrid& grid, const MeshAndPlane& sets, int level);

} // namespace scree::test
