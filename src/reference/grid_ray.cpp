#include "reference/grid_ray.h"

namespace scree::reference {
namespace {

/// The least root in [0, length] of a parabola that has one there, else `length`.
double least_root(const Clearance& c, double length)
{
    const double inside = std::max(0.0, c.slope * c.slope - 4 * c.curve * c.value);
    // The sum of what has one sign: no digits are lost; the other root is the quotient.
    const double sum = -(c.slope + std::copysign(std::sqrt(inside), c.slope)) / 2;
    double least = length;
    for (const double root : {sum / c.curve, c.value / sum}) // NaN and infinity are no roots
        if (root >= 0 && root < least)
            least = root;
    return least;
}

} // namespace

std::optional<double> Clearance::first_zero(double length, double tolerance) const
{
    if (std::abs(value) <= tolerance)
        return 0;
    const double sign = value > 0 ? 1 : -1;
    const Clearance above{sign * value, sign * slope, sign * curve};
    if (above.least(length) < 0)
        return least_root(*this, length);
    if (above.at(length) <= tolerance)
        return length;
    return {};
}

} // namespace scree::reference
