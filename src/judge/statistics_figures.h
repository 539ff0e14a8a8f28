#pragma once

#include <string>
#include <vector>

#include "judge/set_texel.h"
#include "reference/statistics.h"
#include "texset/manifest.h"

namespace scree {

/// Errors of one figure over the texels of a level.
class ErrorSums {
public:
    /// The texel that the next numbers belong to.
    void at(int x, int y)
    {
        x_ = x;
        y_ = y;
    }
    /// magnitude  of the largest stored number that `recovered` is made of
    void note(double recovered, double truth, double magnitude);

    [[nodiscard]] double largest() const { return largest_; } ///< infinite where a number is none
    [[nodiscard]] double rms() const;
    [[nodiscard]] double magnitude() const { return magnitude_; }
    [[nodiscard]] int worst_x() const { return worst_x_; }
    [[nodiscard]] int worst_y() const { return worst_y_; }

private:
    int x_ = 0, y_ = 0, worst_x_ = 0, worst_y_ = 0;
    double largest_ = 0, squares_ = 0, count_ = 0, magnitude_ = 0;
};

/// What an error is relative to: the yardsticks of pipeline/storage_error.h, taken of the truth.
enum class Yardstick {
    one,
    slope,           ///< largest mean slope of the level, or the map's rms slope where that is more
    variance,        ///< largest slope variance of the level or of the next, see StorageError
    color,           ///< largest mean color of the level
    color_deviation, ///< the map's deviation of color, at least a tenth of its largest mean color
    color_slope,     ///< that times the map's deviation of the slope
    height,          ///< the map's deviation of the height, world units
};

/// Of the whole map, by brute force.
struct MapTruth {
    double h0 = 0, h1 = 1;
    bool has_height = true;
};

/// A figure of a texture that a reader recovers from its numbers.
struct Figure {
    Map map;
    PixelType type;
    std::string name;
    Yardstick yardstick;
    void (*compare)(const SetTexel&, const reference::Texel&, const MapTruth&, ErrorSums&);
};

/// All figures of a set, texture by texture.
///
/// Products with another texture's mean are held against the truth's mean: its rounding is that
/// texture's error. Only of the coverage texels without data are told anything.
std::vector<Figure> figures_of(const Manifest& manifest);

} // namespace scree
