#pragma once

#include <vector>

namespace scree {

/// What a way costs, and how wrong it is.
struct CostAndError {
    double cost = 0, error = 0;
};

/// For each way whether no other is at least as good in both and better in one. Ways with a number
/// that is not finite are not on the front, and keep no other from it.
std::vector<bool> pareto_front(const std::vector<CostAndError>& ways);

} // namespace scree
