#include "chart/views.h"

#include <fmt/format.h>

#include <array>

#include "judge/view_check.h"

namespace scree {

std::string ViewBand::name() const { return fmt::format("{:g}-{:g}", from_deg, to_deg); }

ChartViews chart_views()
{
    ChartViews all;
    constexpr std::array<double, 5> kEnds = {0, 30, 60, 75, 85};
    for (size_t b = 0; b + 1 < kEnds.size(); ++b) {
        const double width = kEnds[b + 1] - kEnds[b];
        all.bands.push_back({kEnds[b], kEnds[b + 1], all.views.size(), 8});
        for (const double part : {0.25, 0.75})
            for (int quarter = 0; quarter < 4; ++quarter)
                all.views.push_back(
                    direction(kEnds[b] + part * width, 90 * quarter + (part < 0.5 ? 20 : 65)));
    }
    all.lights = {direction(20, 35), direction(50, 160), direction(70, 280)};
    return all;
}

} // namespace scree
