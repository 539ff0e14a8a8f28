#pragma once

// What NAME.visible.exr tells of a view or of a light, for renderers in C++. Header only, as
// filter.h; ranges, limits and sources of the formulas stand in scree_filter.h.

#include "kernel/filter.h"

#include <cassert>

namespace scree::filter {

/// One filtered lookup in NAME.visible.exr, and what its header says of the nodes.
template <typename Real>
struct VisibilityTable {
    /// nodes x terms x 4, in the order of the file's channels: of each node A B G R of the mean
    /// over the azimuth, then of its harmonics c1 [c2] s1 [s2]; or of all sides, then of xn xp yn
    /// yp
    const Real* values = nullptr;
    const Real* cosines = nullptr;       ///< of the nodes' angles from the normal: falling, below 1
    int nodes = 0;                       ///< 1 to 6
    int harmonics = 0;                   ///< 0 to 2
    bool axes = false;                   ///< along axes instead of harmonics
    Real axis_cosine = 1, axis_sine = 0; ///< of the first axis' angle from +s towards +t
};

/// The moments a table holds, of one direction: a = v - 1 and E[c (v - 1)], v the visible area per
/// area that the texture plane shows.
template <typename Real>
struct Visibility {
    Real a = 0;
    Vec3<Real> beta{0, 0, 0};
};

/// The nodes on both sides of a direction: linear in scree_node_coordinate in between, from the
/// last one on that node.
template <typename Real>
struct NodeShares {
    /// z  cosine of the angle that nodes are looked up with
    NodeShares(const VisibilityTable<Real>& table, Real z)
    {
        while (outer + 1 < table.nodes && z < table.cosines[outer])
            ++outer;
        const bool first = outer == 0; // the node before it is straight above: 0, and in no file
        const Real z_near = first ? Real(1) : table.cosines[outer - 1];
        share = kernel::scree_node_share(z, z_near, table.cosines[outer]);
        inner = first ? 0 : outer - 1;
        rest = first ? Real(0) : 1 - share;
    }

    int inner = 0, outer = 0;
    Real rest = 0, share = 0;
};

/// Adds the table's numbers of one term, times a weight.
///
/// terms  of a node
/// sum    A B G R
template <typename Real>
void add_term(const VisibilityTable<Real>& table, const NodeShares<Real>& at, int term, int terms,
              Real weight, Real* sum)
{
    const Real* inner = table.values + 4 * (terms * at.inner + term);
    const Real* outer = table.values + 4 * (terms * at.outer + term);
    for (int i = 0; i < 4; ++i)
        sum[i] += weight * (at.rest * inner[i] + at.share * outer[i]);
}

/// w  unit, away from the surface, to the viewer or to a light
template <typename Real>
Visibility<Real> visibility(const VisibilityTable<Real>& table, const Vec3<Real>& w)
{
    assert(table.nodes >= 1 && table.nodes <= 6);
    assert(table.harmonics >= 0 && table.harmonics <= 2);
    Real sum[4] = {0, 0, 0, 0}; // A B G R
    if (table.axes) {
        const Real x = w.x * table.axis_cosine + w.y * table.axis_sine;
        const Real y = w.y * table.axis_cosine - w.x * table.axis_sine;
        const NodeShares<Real> along_x(table, kernel::scree_axis_cosine(x, w.z));
        const NodeShares<Real> along_y(table, kernel::scree_axis_cosine(y, w.z));
        add_term(table, {table, w.z}, 0, 5, Real(1), sum);
        add_term(table, along_x, x < 0 ? 1 : 2, 5, Real(1), sum);
        add_term(table, along_y, y < 0 ? 3 : 4, 5, Real(1), sum);
    } else {
        Real c1, c2, s1, s2;
        kernel::scree_azimuth_harmonics(w.x, w.y, c1, c2, s1, s2);
        const bool twice = table.harmonics == 2;
        const Real azimuth[5] = {1, c1, twice ? c2 : s1, s1, s2};
        const NodeShares<Real> at(table, w.z);
        const int terms = 1 + 2 * table.harmonics;
        for (int j = 0; j < terms; ++j)
            add_term(table, at, j, terms, azimuth[j], sum);
    }
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
