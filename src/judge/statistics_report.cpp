#include "judge/statistics_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

report::Table statistics_table(const std::vector<StatisticsFigure>& figures)
{
    std::vector<const StatisticsFigure*> worst;
    for (const StatisticsFigure& figure : figures) {
        const auto same = std::find_if(worst.begin(), worst.end(), [&](const auto* other) {
            return other->map == figure.map && other->name == figure.name;
        });
        // A level that is nearest to its own tolerance is the worst.
        if (same == worst.end())
            worst.push_back(&figure);
        else if (figure.largest * (*same)->tolerance > (*same)->largest * figure.tolerance)
            *same = &figure;
    }
    report::Table table;
    table.title = "Statistics: the level of each that is nearest to its tolerance";
    table.headings = {"texture", "figure",   "level",    "largest error",
                      "rms",     "at texel", "tolerance"};
    for (const StatisticsFigure* figure : worst)
        table.rows.push_back(
            {map_info(figure->map).name, figure->name, fmt::format("{}", figure->level),
             fmt::format("{:.1e}", figure->largest), fmt::format("{:.1e}", figure->rms),
             fmt::format("{},{}", figure->x, figure->y), fmt::format("{:.1e}", figure->tolerance)});
    return table;
}

} // namespace scree
