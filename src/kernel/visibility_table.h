#pragma once

// What NAME.visible.exr tells of a view or of a light, for renderers in C++. Header only, as
// filter.h; ranges, limits and sources of the formulas stand in scree_filter.h.

#include "kernel/filter.h"

#include <cassert>

namespace scree::filter {

/// One filtered lookup in NAME.visible.exr, and what its header says of the nodes.
template <typename Real>
struct VisibilityTable {
    /// nodes x (1 + 2 harmonics) x 4, in the order of the file's channels: of each node A B G R of
    /// the mean over the azimuth, then of its harmonics c1 [c2] s1 [s2]
    const Real* values = nullptr;
    const Real* cosines = nullptr; ///< of the nodes' angles from the normal: falling, below 1
    int nodes = 0;                 ///< 1 to 6
    int harmonics = 0;             ///< 0 to 2
};

/// The moments a table holds, of one direction: a = v - 1 and E[c (v - 1)], v the visible area per
/// area that the texture plane shows.
template <typename Real>
struct Visibility {
    Real a = 0;
    Vec3<Real> beta{0, 0, 0};
};

/// Between the nodes linear in scree_node_coordinate; from the last one on that node.
///
/// w  unit, away from the surface, to the viewer or to a light
template <typename Real>
Visibility<Real> visibility(const VisibilityTable<Real>& table, const Vec3<Real>& w)
{
    assert(table.nodes >= 1 && table.nodes <= 6);
    assert(table.harmonics >= 0 && table.harmonics <= 2);
    int outer = 0;
    while (outer + 1 < table.nodes && w.z < table.cosines[outer])
        ++outer;
    const bool first = outer == 0; // the node before it is straight above: 0, and in no file
    const Real z_near = first ? Real(1) : table.cosines[outer - 1];
    const Real share = kernel::scree_node_share(w.z, z_near, table.cosines[outer]);
    const Real rest = first ? Real(0) : 1 - share;

    Real c1, c2, s1, s2;
    kernel::scree_azimuth_harmonics(w.x, w.y, c1, c2, s1, s2);
    const bool twice = table.harmonics == 2;
    const Real azimuth[5] = {1, c1, twice ? c2 : s1, s1, s2};
    const int components = 1 + 2 * table.harmonics;
    const Real* outer_values = table.values + 4 * components * outer;
    const Real* inner_values = first ? outer_values : outer_values - 4 * components;
    Real sum[4] = {0, 0, 0, 0}; // A B G R
    for (int j = 0; j < components; ++j)
        for (int i = 0; i < 4; ++i)
            sum[i] +=
                azimuth[j] * (rest * inner_values[4 * j + i] + share * outer_values[4 * j + i]);
    return {sum[0], {sum[3], sum[2], sum[1]}};
}

/// Visible color of a set with tables: color E[c], looked up alike.
template <typename Real>
Vec3<Real> visible_color(const Vec3<Real>& color, const Visibility<Real>& visibility)
{
    Vec3<Real> out;
    for (int i = 0; i < 3; ++i)
        out[i] = kernel::scree_color_by_visibility(color[i], visibility.beta[i], visibility.a);
    return out;
}

template <typename Real>
Vec3<Real> visible_color(const Vec3<Real>& color, const VisibilityTable<Real>& table,
                         const Vec3<Real>& w)
{
    return visible_color(color, visibility(table, w));
}

/// E[V W]: area that w sees, projected, per area of the texture plane.
template <typename Real>
Real visible_area(const VisibilityTable<Real>& table, const Vec3<Real>& w)
{
    return kernel::scree_visible_area(w.z, visibility(table, w).a);
}

/// Color of what is both seen and lit.
///
/// seen, lit  visible_color() of the view and of the light;  wo, wi  the two directions
template <typename Real>
Vec3<Real> color_seen_and_lit(const Vec3<Real>& color, const Vec3<Real>& seen,
                              const Vec3<Real>& lit, const Vec3<Real>& wo, const Vec3<Real>& wi)
{
    const Real together = kernel::scree_view_light_overlap(wo.x, wo.y, wi.x, wi.y);
    Vec3<Real> out;
    for (int i = 0; i < 3; ++i)
        out[i] = kernel::scree_color_seen_and_lit(color[i], seen[i], lit[i], together);
    return out;
}

} // namespace scree::filter
