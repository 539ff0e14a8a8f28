#pragma once

#include <vector>

#include "visibility/axes_fit.h"
#include "visibility/height_grid.h"
#include "visibility/sweep.h"
#include "visibility/visibility_plan.h"

namespace scree {

/// Which sweeps the components of tables, and single views, are made of.
///
/// With v(view) = E[V W] / cos theta as of sweep(), a component is a sum over views of v - 1, the
/// excess over a plane, times factors:
///   the mean at a node          1 / N of each azimuth
///   cos h phi, sin h phi there  2 cos(h phi_j) / N, 2 sin(h phi_j) / N
///   along axes                  those of AxesFit
///   a single view               1
class ViewComponents {
public:
    /// Throws nothing; the numbers must be in the ranges of VisibilityPlan.
    ViewComponents(const std::vector<VisibilityPlan>& tables, const std::vector<ViewAngles>& views);

    /// Those of the tables, node by node, then the views.
    [[nodiscard]] int count() const { return count_; }

    /// The components of a block's texels.
    ///
    /// excess  a component: width x height numbers, row by row; those of a view are >= -1
    void see(const HeightGrid& heights, const TexelBlock& block, float* const* excess) const;

private:
    struct Term {
        int elevation, component;
        float factor;
    };
    struct Sweep {
        double azimuth_rad;
        std::vector<double> cotangents;
        std::vector<Term> terms;
    };
    /// Sums that a matrix makes a table of.
    struct Solve {
        int first, count; ///< components
        std::vector<float> matrix;
    };
    void add_harmonics(const VisibilityPlan& table);
    void add_axes(const VisibilityPlan& table);
    void add(const ViewAngles& view, int component, double factor);
    Sweep& sweep_at(double azimuth_deg);
    static int elevation_of(Sweep& sweep, double angle_deg);

    int count_ = 0;
    std::vector<Sweep> sweeps_;
    std::vector<Solve> solves_;
};

} // namespace scree
