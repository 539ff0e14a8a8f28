#include "judge/ray_reach.h"

#include <fmt/format.h>

namespace scree {

namespace {

constexpr double kMostWidths = 100;

bool goes_on(reference::Beyond beyond)
{
    return beyond == reference::Beyond::repeats || beyond == reference::Beyond::mirrors;
}

} // namespace

std::string too_high_for_rays(const reference::DisplacedSurface& surface)
{
    const reference::Relief& relief = surface.relief();
    const double range = surface.highest() - surface.lowest();
    struct Axis {
        const char* name;
        double width;
        reference::Beyond beyond;
    };
    for (const Axis& axis : {Axis{"s", relief.width * relief.texel_width, relief.beyond_s},
                             Axis{"t", relief.height * relief.texel_height, relief.beyond_t}})
        if (goes_on(axis.beyond) && !(range <= kMostWidths * axis.width))
            return fmt::format("heights range over {:.3g}, {:.0f} times the width of the map along "
                               "{}, in which it goes on: rays would cross too many images of it; "
                               "check --height-scale and --texel-size",
                               range, range / axis.width, axis.name);
    return "";
}

} // namespace scree
