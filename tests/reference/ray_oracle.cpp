#include "reference/ray_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::oracle {
namespace {

using reference::Beyond;
using reference::Relief;
using Real = long double;

constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();

bool goes_on(Beyond beyond) { return beyond == Beyond::repeats || beyond == Beyond::mirrors; }

/// Height of a texel, wherever in the plane, by the definition of Beyond; NaN: none.
Real height_at(const Relief& r, long column, long row)
{
    // One line at a time: get(i) for the texels of it, i any whole number.
    auto along = [](Beyond beyond, long n, long i, const auto& get) -> Real {
        if (beyond == Beyond::repeats)
            return get(((i % n) + n) % n);
        if (beyond == Beyond::mirrors) {
            const long folded = ((i % (2 * n)) + 2 * n) % (2 * n);
            return get(folded < n ? folded : 2 * n - 1 - folded);
        }
        if (i >= 0 && i < n)
            return get(i);
        if (beyond == Beyond::ends)
            return 0;
        if (n == 1)
            return get(0);
        return i < 0 ? 2 * get(0) - get(1) : 2 * get(n - 1) - get(n - 2);
    };
    auto texel = [&](long x, long y) -> Real {
        const auto i = static_cast<size_t>(y * r.width + x);
        const bool weighs = r.weights.empty() || r.weights[i] > 0;
        bool colored = true;
        if (!r.colors.empty())
            for (const double c : r.colors[i])
                colored = colored && std::isfinite(c);
        return weighs && colored && std::isfinite(r.heights[i]) ? Real(r.heights[i]) : kNone;
    };
    return along(r.beyond_t, r.height, row, [&](long y) {
        return along(r.beyond_s, r.width, column, [&](long x) { return texel(x, y); });
    });
}

/// Steps at which a coordinate passes the borders of cells, texel centres, up to `reach`.
void add_borders(Real place, Real direction, Real reach, std::vector<Real>& steps)
{
    if (direction == 0)
        return;
    const Real end = place + direction * reach;
    const Real low = std::min(place, end), high = std::max(place, end);
    for (Real k = std::ceil(low - Real(0.5)); k + Real(0.5) <= high; ++k)
        steps.push_back((k + Real(0.5) - place) / direction);
}

/// The step up to which the axis is there.
Real end_of(Beyond beyond, Real place, Real direction, long n)
{
    if (goes_on(beyond) || direction == 0)
        return std::numeric_limits<Real>::infinity();
    return ((direction > 0 ? Real(n) : Real(0)) - place) / direction;
}

} // namespace

double above_all(const Relief& relief)
{
    Real high = -std::numeric_limits<Real>::infinity();
    for (long y = -1; y <= relief.height; ++y)
        for (long x = -1; x <= relief.width; ++x) {
            const Real h = height_at(relief, x, y);
            high = h > high ? h : high;
        }
    return static_cast<double>(high);
}

RayClearance follow(const Relief& relief, double s, double t, double z, const Vec3& direction,
                    double reach)
{
    const Real ds = Real(direction.x) / relief.texel_width;
    const Real dt = Real(direction.y) / relief.texel_height;
    Real length = reach;
    length = std::min(length, end_of(relief.beyond_s, s, ds, relief.width));
    length = std::min(length, end_of(relief.beyond_t, t, dt, relief.height));
    std::vector<Real> steps{0, length};
    add_borders(s, ds, length, steps);
    add_borders(t, dt, length, steps);
    std::sort(steps.begin(), steps.end());

    RayClearance result{std::numeric_limits<Real>::infinity(), {}};
    for (size_t k = 0; k + 1 < steps.size(); ++k) {
        const Real from = steps[k], to = steps[k + 1], middle = (from + to) / 2;
        const auto i = static_cast<long>(std::floor(s + middle * ds - Real(0.5)));
        const auto j = static_cast<long>(std::floor(t + middle * dt - Real(0.5)));
        auto clear = [&](Real step) { // corners weighted by the areas opposite
            const Real u = s + step * ds - Real(0.5) - i, v = t + step * dt - Real(0.5) - j;
            return z + step * direction.z - (1 - u) * (1 - v) * height_at(relief, i, j) -
                   u * (1 - v) * height_at(relief, i + 1, j) -
                   (1 - u) * v * height_at(relief, i, j + 1) -
                   u * v * height_at(relief, i + 1, j + 1);
        };
        // A parabola through three points; its turning point splits it into two monotone parts.
        const Real a = clear(from), b = clear(middle), c = clear(to);
        if (std::isnan(a + b + c) || !(from < to))
            continue;
        const Real bend = a - 2 * b + c;
        Real turn = bend != 0 ? middle + (a - c) / (4 * bend) * (to - from) : middle;
        turn = std::clamp(turn, from, to);
        const Real part[3] = {from, turn, to};
        for (int p = 0; p < 2; ++p) {
            Real low = part[p], high = part[p + 1];
            const Real at_low = clear(low);
            result.least = std::min({result.least, at_low, clear(high)});
            if (result.crossing || (at_low < 0) == (clear(high) < 0))
                continue;
            for (int halving = 0; halving < 80; ++halving) {
                const Real mid = (low + high) / 2;
                ((clear(mid) < 0) == (at_low < 0) ? low : high) = mid;
            }
            result.crossing = low;
        }
    }
    return result;
}

} // namespace scree::oracle
