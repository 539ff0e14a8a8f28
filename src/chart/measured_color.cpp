#include "chart/measured_color.h"

#include <cassert>
#include <cmath>

namespace scree {

namespace {

constexpr double kRadian = 3.14159265358979323846 / 180;

std::array<float, 4> cosines_of(const VisibilityRecord& record)
{
    std::array<float, 4> cosines{};
    assert(record.node_angles_deg.size() == cosines.size());
    for (size_t i = 0; i < cosines.size(); ++i)
        cosines[i] = static_cast<float>(std::cos(record.node_angles_deg[i] * kRadian));
    return cosines;
}

} // namespace

VisibilityNodes nodes_of(const VisibilityRecord& harmonics, const VisibilityRecord& axes)
{
    VisibilityNodes nodes;
    nodes.four = cosines_of(harmonics);
    nodes.two = {nodes.four[1], nodes.four[3]};
    nodes.along_axes = cosines_of(axes);
    const double axis = axes.axis_deg.value() * kRadian;
    nodes.axis_cosine = static_cast<float>(std::cos(axis));
    nodes.axis_sine = static_cast<float>(std::sin(axis));
    return nodes;
}

} // namespace scree
