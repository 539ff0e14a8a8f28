#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reference/node_grid.h"

namespace scree::reference {

/// A ray in the coordinates of NodeGrid: x and y in texels, z in world units above its base.
///
/// A place on it is origin + step * (dx, dy, dz); what a step is worth is up to who made it.
struct GridRay {
    double x = 0, y = 0, z = 0;
    double dx = 0, dy = 0, dz = 0;

    [[nodiscard]] double x_at(double step) const { return x + step * dx; }
    [[nodiscard]] double y_at(double step) const { return y + step * dy; }
    [[nodiscard]] double z_at(double step) const { return z + step * dz; }

    void advance(double step)
    {
        x = x_at(step);
        y = y_at(step);
        z = z_at(step);
    }
};

/// A part of a ray, in steps; empty where from > to.
struct Span {
    double from = 0, to = 0;
};

/// One coordinate of a ray.
class RayAxis {
public:
    RayAxis(double origin, double direction)
        : origin_(origin), direction_(direction), inverse_(1 / direction)
    {}

    [[nodiscard]] bool forward() const { return direction_ > 0; }

    /// The step at which it reaches a place; infinity where it never moves.
    [[nodiscard]] double step_to(double place) const
    {
        return direction_ != 0 ? (place - origin_) * inverse_
                               : std::numeric_limits<double>::infinity();
    }

    /// The part of a span in which it lies in [low, high].
    [[nodiscard]] Span within(double low, double high, Span span) const
    {
        if (direction_ == 0)
            return origin_ >= low && origin_ <= high ? span : Span{1, 0};
        const double enters = step_to(forward() ? low : high);
        const double leaves = step_to(forward() ? high : low);
        return {std::max(span.from, enters), std::min(span.to, leaves)};
    }

private:
    double origin_, direction_, inverse_;
};

/// Height of a ray above a bilinear cell, by steps from where it was taken: a parabola.
struct Clearance {
    double value, slope, curve;

    [[nodiscard]] double at(double step) const { return value + step * (slope + step * curve); }

    /// The least of it over [0, length].
    [[nodiscard]] double least(double length) const
    {
        double least = std::min(value, at(length));
        if (curve > 0 && slope < 0 && slope + 2 * curve * length > 0)
            least = std::min(least, value - slope * slope / (4 * curve));
        return least;
    }

    /// The first step in [0, length] at which it is zero: within `tolerance` at either end, so that
    /// rounding cannot lose a zero between two cells, or changing its sign.
    [[nodiscard]] std::optional<double> first_zero(double length, double tolerance) const;
};

/// The clearance over cell (i, j) from `step` on; NaN where a corner has no data.
///
/// The position is taken relative to the cell's corner: its digits are not lost to the distance
/// from the grid's.
inline Clearance clearance(const NodeGrid& grid, int i, int j, const GridRay& ray, double step)
{
    const double* upper = grid.row(j) + i;
    const double* lower = grid.row(j + 1) + i;
    const double along_x = upper[1] - upper[0];
    const double along_y = lower[0] - upper[0];
    const double twist = (lower[1] - lower[0]) - along_x;
    const double u = ray.x_at(step) - i, v = ray.y_at(step) - j;
    return {ray.z_at(step) - (upper[0] + u * along_x + v * (along_y + u * twist)),
            ray.dz - ray.dx * (along_x + v * twist) - ray.dy * (along_y + u * twist),
            -twist * ray.dx * ray.dy};
}

/// Cells [first_i, end_i) x [first_j, end_j).
struct CellBlock {
    int first_i, first_j, end_i, end_j;
};

/// Visits the cells of a block under the first `length` steps of a ray, in its order, until
/// visit(i, j, from, to) returns true; returns whether it did.
///
/// Each cell gets the part of the ray over it, to rounding; the parts leave no gap between them.
template <class Visit>
bool march(const CellBlock& block, const GridRay& ray, double length, const Visit& visit)
{
    Span span{0, length};
    const RayAxis along_x(ray.x, ray.dx), along_y(ray.y, ray.dy);
    span = along_x.within(block.first_i, block.end_i, span);
    span = along_y.within(block.first_j, block.end_j, span);
    if (!(span.from <= span.to))
        return false;
    auto cell_of = [](double place, int first, int end) {
        return std::clamp(static_cast<int>(std::floor(place)), first, end - 1);
    };
    int i = cell_of(ray.x_at(span.from), block.first_i, block.end_i);
    int j = cell_of(ray.y_at(span.from), block.first_j, block.end_j);
    const int forward_x = along_x.forward(), forward_y = along_y.forward();
    double leaves_x = along_x.step_to(i + forward_x);
    double leaves_y = along_y.step_to(j + forward_y);
    for (double from = span.from;;) {
        // Rounding may put the border just behind: then the cell gets nothing of the ray.
        const double to = std::max(from, std::min({leaves_x, leaves_y, span.to}));
        if (visit(i, j, from, to))
            return true;
        if (to >= span.to)
            return false;
        from = to;
        if (leaves_x <= leaves_y) {
            i += 2 * forward_x - 1;
            if (i < block.first_i || i >= block.end_i)
                return false;
            leaves_x = along_x.step_to(i + forward_x);
        } else {
            j += 2 * forward_y - 1;
            if (j < block.first_j || j >= block.end_j)
                return false;
            leaves_y = along_y.step_to(j + forward_y);
        }
    }
}

} // namespace scree::reference
