#pragma once

#include <array>
#include <vector>

#include "figures/slope_views.h"
#include "kernel/filter.h"
#include "reference/gather.h"

namespace scree::test {

/// Mean and covariance of slopes that are seen.
struct SeenSlopes {
    Vec2 mean{0, 0};
    filter::Covariance<double> covariance;
};

/// What a reference renderer's view sees; whose mean and covariance are 0 where nothing is seen.
SeenSlopes seen_slopes(const reference::Seen& seen);

/// Visible slopes and color of a footprint by a table as a bake could store it, made of the
/// reference's own views: the best that such a table can do.
///
/// With v = V W / cos theta it holds of the slope (x, y)
///
///   E[q (v - 1)],   q one of 1, x, y, xx, xy, yy, c
///
/// at the nodes, as a mean over the azimuth and its harmonics. All are linear moments that
/// textures filter, 0 straight above, and told between nodes linearly in tan theta. The first is
/// that of the tables of color, as is the last for each of R, G, B.
class SlopeTable {
public:
    /// What x and y are: along and across the view's azimuth, where a rough surface that is alike
    /// all around needs no harmonics; or s and t of the map.
    enum class Frame { view, map };

    /// straight  what is seen from straight above: the slopes and the color without visibility
    /// nodes     of SlopeViews::fitted from the second on, node by node
    /// harmonics 0, 1 or 2
    SlopeTable(const SlopeViews& views, const reference::Seen& straight,
               const std::vector<reference::Seen>& nodes, size_t harmonics, Frame frame);

    struct Told {
        SeenSlopes slopes;
        double color = 0; ///< G
    };

    /// baked  the slopes that the table is read with
    [[nodiscard]] Told at(const Vec3& w, const filter::Slopes<double>& baked) const;

private:
    static constexpr size_t kQuantities = 7;
    using Quantities = std::array<double, kQuantities>;

    /// E[q v] of all q, x along a unit vector.
    static Quantities moments(double v, const SeenSlopes& slopes, double color, const Vec2& along);
    [[nodiscard]] Vec2 x_axis(const Vec2& azimuth) const;
    [[nodiscard]] Quantities at_node(size_t node, const Vec2& azimuth) const;

    double color_ = 0;
    Frame frame_;
    std::vector<double> tangents_;               ///< of the nodes
    std::vector<std::vector<Quantities>> terms_; ///< node; 1, cos, sin, cos 2, sin 2 of azimuth
};

} // namespace scree::test
