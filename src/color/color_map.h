#pragma once

#include <array>
#include <vector>

namespace scree {

/// Red, green, blue; scene-linear, unless the passage says otherwise.
using Rgb = std::array<double, 3>;

/// Where two straight pieces of a color map meet.
struct Knot {
    double x = 0;
    Rgb color{};
};

/// A color as a function of one number (a height, a slope): straight lines between knots.
///
/// Two knots of the same x are a jump, and the map takes the right one's color there. Before the
/// first knot and after the last it is constant; a jump at an end gives what lies outside a color
/// of its own, and the end itself the color inside.
class ColorMap {
public:
    /// knots  at least one, finite, x not decreasing; of several at one x the first and last count
    explicit ColorMap(std::vector<Knot> knots);

    [[nodiscard]] Rgb at(double x) const;

    [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }
    [[nodiscard]] double first() const { return knots_.front().x; }
    [[nodiscard]] double last() const { return knots_.back().x; }

    /// The map with its first knot at `low` and its last at `high`. Where there is no room
    /// (low = high), or nothing to stretch, a constant: the color of its middle.
    [[nodiscard]] ColorMap stretched(double low, double high) const;

    /// A place the map must keep: sea level, say, whatever the range of the heights.
    struct Hinge {
        double at = 0; ///< in this map, from first() to last()
        double to = 0; ///< in the stretched map
    };

    /// The map with its halves on either side of the hinge stretched separately, to [low, hinge.to]
    /// and [hinge.to, high]. Where the hinge is not inside (low, high) the half beyond it is left
    /// out: heights that are all above the sea do not see the colors below it.
    [[nodiscard]] ColorMap stretched(double low, double high, const Hinge& hinge) const;

private:
    std::vector<Knot> knots_;
};

/// The largest difference between two colors of the map in one channel, for x in [low, high].
double color_span(const ColorMap& map, double low, double high);

} // namespace scree
