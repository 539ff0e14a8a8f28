#include "visibility/visibility_plan.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

/// Of the last node's tangent, the most that the first may have.
constexpr double kMostOfLast = 0.5;

/// Degrees; nodes are moved to whole ones, to be read easily.
constexpr double kStep = 0.125;

} // namespace

std::vector<double> best_node_angles(int nodes)
{
    static const std::vector<double> kAngles[kMaxNodes] = {{80},
                                                           {70, 87},
                                                           {60, 80, 87},
                                                           {55, 74, 84, 87},
                                                           {55, 74, 80, 84, 87},
                                                           {50, 64, 74, 80, 84, 87}};
    return kAngles[std::clamp(nodes, 1, kMaxNodes) - 1];
}

std::vector<double> moved_node_angles(std::vector<double> angles_deg, double steepness)
{
    const double first = std::tan(angles_deg.front() * kRadian);
    const double last = std::tan(angles_deg.back() * kRadian);
    const double begin = std::min(1 / steepness, kMostOfLast * last);
    if (!(begin > first))
        return angles_deg;
    for (size_t i = 0; i + 1 < angles_deg.size(); ++i) {
        const double place =
            std::log(std::tan(angles_deg[i] * kRadian) / first) / std::log(last / first);
        const double moved = std::atan(begin * std::pow(last / begin, place)) / kRadian;
        angles_deg[i] = std::round(moved / kStep) * kStep;
    }
    return angles_deg;
}

} // namespace scree
