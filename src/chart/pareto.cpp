#include "chart/pareto.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

bool is_comparable(const CostAndError& way)
{
    return std::isfinite(way.cost) && std::isfinite(way.error);
}

bool beats(const CostAndError& a, const CostAndError& b)
{
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

} // namespace

std::vector<bool> pareto_front(const std::vector<CostAndError>& ways)
{
    const auto is_on_front = [&ways](const CostAndError& way) {
        return is_comparable(way) &&
               std::none_of(ways.begin(), ways.end(), [&way](const CostAndError& other) {
                   return is_comparable(other) && beats(other, way);
               });
    };
    std::vector<bool> on_front(ways.size());
    std::transform(ways.begin(), ways.end(), on_front.begin(), is_on_front);
    return on_front;
}

} // namespace scree
