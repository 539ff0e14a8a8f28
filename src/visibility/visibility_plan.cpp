#include "visibility/visibility_plan.h"

#include <algorithm>

namespace scree {

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

} // namespace scree
