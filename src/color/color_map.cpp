#include "color/color_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace scree {

namespace {

[[maybe_unused]] bool is_sound(const std::vector<Knot>& knots)
{
    const auto finite = [](const Knot& k) {
        return std::isfinite(k.x) && std::all_of(k.color.begin(), k.color.end(),
                                                 [](double c) { return std::isfinite(c); });
    };
    return !knots.empty() && std::all_of(knots.begin(), knots.end(), finite) &&
           std::is_sorted(knots.begin(), knots.end(),
                          [](const Knot& a, const Knot& b) { return a.x < b.x; });
}

/// [from_low, from_high] to [low, high], monotone in x whatever the rounding.
double moved(double x, double from_low, double from_high, double low, double high)
{
    const double t = (x - from_low) / (from_high - from_low);
    return std::clamp(low + t * (high - low), low, high);
}

} // namespace

ColorMap::ColorMap(std::vector<Knot> knots)
{
    assert(is_sound(knots));
    for (auto begin = knots.begin(); begin != knots.end();) {
        const auto end =
            std::find_if(begin, knots.end(), [&](const Knot& k) { return k.x != begin->x; });
        knots_.push_back(*begin);
        if (std::prev(end)->color != begin->color)
            knots_.push_back(*std::prev(end));
        begin = end;
    }
}

Rgb ColorMap::at(double x) const
{
    const auto after = std::upper_bound(knots_.begin(), knots_.end(), x,
                                        [](double value, const Knot& k) { return value < k.x; });
    if (after == knots_.begin())
        return knots_.front().color;
    if (after == knots_.end()) {
        const auto inside = knots_.rbegin() + 1;
        const bool at_end = x == last() && first() < last() && inside->x == x;
        return at_end ? inside->color : knots_.back().color;
    }
    const Knot &a = *std::prev(after), &b = *after;
    const double t = (x - a.x) / (b.x - a.x);
    Rgb color;
    for (size_t c = 0; c < 3; ++c)
        color[c] = a.color[c] + t * (b.color[c] - a.color[c]);
    return color;
}

ColorMap ColorMap::stretched(double low, double high) const
{
    assert(low <= high);
    if (low == high || first() == last())
        return ColorMap({{low, at(first() + (last() - first()) / 2)}});
    std::vector<Knot> knots = knots_;
    for (Knot& k : knots)
        k.x = moved(k.x, first(), last(), low, high);
    return ColorMap(std::move(knots));
}

ColorMap ColorMap::stretched(double low, double high, const Hinge& hinge) const
{
    assert(low <= high && first() <= hinge.at && hinge.at <= last());
    const bool below = low < hinge.to, above = hinge.to < high;
    std::vector<Knot> lower, upper; // either ends at the hinge
    for (const Knot& k : knots_) {
        if (k.x < hinge.at && below)
            lower.push_back({moved(k.x, first(), hinge.at, low, hinge.to), k.color});
        else if (k.x > hinge.at && above)
            upper.push_back({moved(k.x, hinge.at, last(), hinge.to, high), k.color});
    }
    const auto at_hinge =
        std::find_if(knots_.begin(), knots_.end(), [&](const Knot& k) { return k.x == hinge.at; });
    if (below || !above)
        lower.push_back(
            {hinge.to, at_hinge != knots_.end() && below ? at_hinge->color : at(hinge.at)});
    if (above)
        lower.push_back({hinge.to, at(hinge.at)});
    lower.insert(lower.end(), upper.begin(), upper.end());
    return ColorMap(std::move(lower));
}

double color_span(const ColorMap& map, double low, double high)
{
    Rgb least = map.at(low), most = least;
    const auto widen = [&](const Rgb& color) {
        for (size_t c = 0; c < 3; ++c) {
            least[c] = std::min(least[c], color[c]);
            most[c] = std::max(most[c], color[c]);
        }
    };
    widen(map.at(high));
    for (const Knot& k : map.knots())
        if (k.x > low && k.x < high)
            widen(k.color);
    double span = 0;
    for (size_t c = 0; c < 3; ++c)
        span = std::max(span, most[c] - least[c]);
    return span;
}

} // namespace scree
