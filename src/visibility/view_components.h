#pragma once

#include <vector>

#include "visibility/height_grid.h"
#include "visibility/sweep.h"

namespace scree {

/// What a table of visibility holds of every texel: at some angles from the normal (its nodes) the
/// mean over the azimuth, and terms of a Fourier series in it.
struct VisibilityPlan {
    std::vector<double> node_angles_deg; ///< rising, in (0, 90); 1 to kMaxNodes
    int harmonics = 0;                   ///< 0 to kMaxHarmonics
    int azimuths = 8;                    ///< swept, equally spaced; more than 2 harmonics

    /// Of a node: the mean, then cos phi, cos 2 phi, sin phi, sin 2 phi as far as there are any.
    [[nodiscard]] int terms() const { return 1 + 2 * harmonics; }
    /// As of ViewComponents.
    [[nodiscard]] int components() const
    {
        return static_cast<int>(node_angles_deg.size()) * terms();
    }
};

/// The angles that served best for a number of nodes, 1 to kMaxNodes; figures in
/// docs/visibility.md.
std::vector<double> best_node_angles(int nodes);

constexpr int kMaxNodes = 6;
constexpr int kMaxHarmonics = 2;
constexpr int kMaxAzimuths = 64;

/// A single direction to see from.
struct ViewAngles {
    double angle_deg = 0;   ///< from the normal, in (0, 90)
    double azimuth_deg = 0; ///< from +s towards +t
};

/// Which sweeps the components of a table, and single views, are made of.
///
/// With v(view) = E[V W] / cos theta as of sweep(), a component is a sum over views of v - 1, the
/// excess over a plane, times factors:
///   the mean at a node          1 / N of each azimuth
///   cos h phi, sin h phi there  2 cos(h phi_j) / N, 2 sin(h phi_j) / N
///   a single view               1
/// Azimuths are (j + 1/4) 360 / N degrees: for N = 8 none of them lies along an axis of the map or
/// a diagonal, where a line passes all texels at the same place.
class ViewComponents {
public:
    /// Throws nothing; the numbers must be in the ranges above.
    ViewComponents(const VisibilityPlan& table, const std::vector<ViewAngles>& views);

    /// Those of the table, node by node, then the views.
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
    Sweep& sweep_at(double azimuth_deg);
    static int elevation_of(Sweep& sweep, double angle_deg);

    int count_ = 0;
    std::vector<Sweep> sweeps_;
};

} // namespace scree
