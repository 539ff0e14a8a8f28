#include "judge/view_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace scree {

namespace {

std::string angle_of(const ViewErrors& errors)
{
    return errors.angle_deg < 0 ? "all" : fmt::format("{:g}", errors.angle_deg);
}

std::string number(double error) { return fmt::format("{:.4f}", error); }

void append(std::vector<std::string>& row, const ViewError& error)
{
    for (const double part : {error.set, error.plain, error.noise})
        row.push_back(number(part));
}

/// One figure over the view's angle.
report::Series over_angles(const ViewCheck& check, const std::string& name,
                           ViewError ViewErrors::*figure, double ViewError::*part)
{
    report::Series series{name, {}, true};
    for (const ViewErrors& errors : check.all)
        if (errors.angle_deg >= 0)
            series.points.push_back(
                {errors.angle_deg, errors.*figure.*part, "", part == &ViewError::set, 0, 0});
    return series;
}

report::Chart chart_of(const ViewCheck& check, const std::string& title,
                       ViewError ViewErrors::*figure)
{
    report::Chart chart;
    chart.title = title;
    chart.x.label = "view, degrees from the normal";
    chart.y.label = "rms error, relative";
    chart.series = {over_angles(check, "plain MIP", figure, &ViewError::plain),
                    over_angles(check, "set", figure, &ViewError::set),
                    over_angles(check, "noise of the reference", figure, &ViewError::noise)};
    return chart;
}

} // namespace

report::Table color_table(const ViewCheck& check)
{
    report::Table table;
    table.title = "What views see: rms errors against the reference, relative";
    table.headings = {"view deg",      "color: set", "plain MIP", "noise",
                      "radiance: set", "plain MIP",  "noise",     "footprints"};
    for (const ViewErrors& errors : check.all) {
        std::vector<std::string> row{angle_of(errors)};
        append(row, errors.color);
        append(row, errors.radiance);
        row.push_back(fmt::format("{}", errors.footprints));
        table.rows.push_back(std::move(row));
    }
    return table;
}

report::Table slope_table(const ViewCheck& check)
{
    report::Table table;
    table.title = "Masking G1, and the visible slopes over the map's rms slope: rms errors";
    table.headings = {"view deg",        "masking: set", "none",  "noise",
                      "mean slope: set", "as baked",     "noise", "slope covariance: set",
                      "as baked",        "noise"};
    for (const ViewErrors& errors : check.all) {
        std::vector<std::string> row{angle_of(errors)};
        append(row, errors.masking);
        append(row, errors.slope);
        append(row, errors.covariance);
        table.rows.push_back(std::move(row));
    }
    return table;
}

report::Table model_table(const ViewCheck& check)
{
    report::Table table;
    table.title =
        "Visible color by the set's models, with color by slope where it has it: rms errors";
    table.headings = {"view deg"};
    table.headings.insert(table.headings.end(), check.models.begin(), check.models.end());
    if (check.models.size() < 2)
        return table;
    for (const ViewErrors& errors : check.all) {
        table.rows.push_back({angle_of(errors)});
        for (const double model : errors.models)
            table.rows.back().push_back(number(model));
    }
    return table;
}

report::Table node_table(const NodeCheck& check)
{
    report::Table table;
    table.title = "Tables of visibility, means over the azimuth: rms errors of the area seen over "
                  "the plane's, and of color by it over the map's mean color";
    table.headings = {"node deg", "level", "area", "noise", "color", "noise", "footprints"};
    for (const auto* all : {&check.all, &check.levels})
        for (const NodeErrors& errors : *all)
            table.rows.push_back({fmt::format("{:g}", errors.angle_deg),
                                  errors.level < 0 ? "all" : fmt::format("{}", errors.level),
                                  number(errors.area.set), number(errors.area.noise),
                                  number(errors.color.set), number(errors.color.noise),
                                  fmt::format("{}", errors.footprints)});
    return table;
}

report::Table level_table(const ViewCheck& check, double ViewError::*part)
{
    report::Table table;
    table.title =
        fmt::format("Radiance level by level: rms errors of {}, relative, by degrees from "
                    "the normal",
                    part == &ViewError::plain ? "a plain MIP chain" : "the set");
    table.headings = {"level"};
    int levels = 0;
    for (const ViewErrors& errors : check.levels)
        levels = std::max(levels, errors.level + 1);
    for (int level = 0; level < levels; ++level)
        table.rows.push_back({fmt::format("{}", level)});
    for (const ViewErrors& errors : check.levels) {
        if (errors.level == 0)
            table.headings.push_back(angle_of(errors));
        table.rows[static_cast<size_t>(errors.level)].push_back(number(errors.radiance.*part));
    }
    return table;
}

std::vector<report::Chart> view_charts(const ViewCheck& check)
{
    return {chart_of(check, "Visible color", &ViewErrors::color),
            chart_of(check, "Radiance", &ViewErrors::radiance)};
}

} // namespace scree
