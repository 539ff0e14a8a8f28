#pragma once

#include <vector>

#include "visibility/visibility_plan.h"

namespace scree {

/// A direction: degrees.
struct ViewAngles {
    double angle_deg = 0;   ///< from the normal, in (0, 90)
    double azimuth_deg = 0; ///< from +s towards +t
};

/// How much a view weighs a number of a table.
struct TableShare {
    int component; ///< node by node, in the order of VisibilityPlan::terms()
    double weight;
};

/// How a table along axes is made of sweeps: by least squares.
///
/// Of a view at theta and azimuth phi, with p = tan theta (cos, sin)(phi - axis), it tells
///
///   f = g(|p|) + a(p_x) + b(p_y)
///
/// g, a, b linear between the nodes x_k = tan theta_k, 0 at 0, and constant beyond the last; a and
/// b on either side of 0. Of a node it holds g(x_k), a(-x_k), a(x_k), b(-x_k), b(x_k). A wall along
/// an axis hides by the component of p across it alone, from the angle on where it begins to: a
/// bend that is sharp in p and smeared out in a series of the azimuth. Derived in
/// docs/visibility.md.
///
/// With A the shares of the sampled views, V what they see, the numbers are (A^T A + r)^-1 A^T V:
/// the ridge r keeps apart what g and a + b could both tell.
class AxesFit {
public:
    /// plan  along axes, with nodes
    explicit AxesFit(const VisibilityPlan& plan);

    /// Of the views that are sampled, every azimuth of the plan at each: the nodes, and one before
    /// each.
    [[nodiscard]] const std::vector<double>& angles_deg() const { return angles_deg_; }

    /// What the table tells of a view is the sum of its numbers by these.
    [[nodiscard]] std::vector<TableShare> shares(const ViewAngles& view) const;

    /// (A^T A + r)^-1, row by row.
    [[nodiscard]] const std::vector<float>& inverse() const { return inverse_; }

private:
    void add_shares(double tangent, int term, std::vector<TableShare>& shares) const;

    VisibilityPlan plan_;
    std::vector<double> tangents_; ///< of the nodes
    std::vector<double> angles_deg_;
    std::vector<float> inverse_;
};

} // namespace scree
