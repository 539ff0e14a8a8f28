#include "color/map_table.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// Place among `count` centres: index of the one before and how far towards the next.
struct Place {
    int index;
    double share;
};

Place place(double from_0_to_1, int count)
{
    const double at = std::clamp(from_0_to_1, 0.0, 1.0) * (count - 1);
    const int index = std::min(static_cast<int>(at), std::max(count - 2, 0));
    return {index, at - index};
}

} // namespace

Rgb lookup(const MapTable& table, double mean, double deviation)
{
    const double x = table.high > table.low ? (mean - table.low) / (table.high - table.low) : 0;
    const double y = table.widest > 0 ? std::sqrt(std::max(deviation / table.widest, 0.0)) : 0;
    const Place s = place(x, table.columns), t = place(y, table.rows);
    const int right = std::min(s.index + 1, table.columns - 1);
    const int below = std::min(t.index + 1, table.rows - 1);
    const Rgb &a = table.at(s.index, t.index), &b = table.at(right, t.index);
    const Rgb &c = table.at(s.index, below), &d = table.at(right, below);
    Rgb color;
    for (size_t i = 0; i < 3; ++i) {
        const double upper = a[i] + s.share * (b[i] - a[i]);
        const double lower = c[i] + s.share * (d[i] - c[i]);
        color[i] = upper + t.share * (lower - upper);
    }
    return color;
}

} // namespace scree
