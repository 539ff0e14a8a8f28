#pragma once

#include <string>
#include <vector>

#include "chart/chart.h"
#include "report/chart.h"
#include "report/page.h"
#include "report/table.h"

namespace scree {

/// A picture with a name that a file may have: "fractal-75-85-radiance-time".
struct NamedChart {
    std::string name;
    report::Chart chart;
};

/// Errors against costs, of every band: radiance and visible color, over time and over bytes.
/// What no other beats in both is drawn full.
std::vector<NamedChart> error_charts(const AssetChart& chart);

/// Errors of an asset, a row for each method: for readers.
report::Table chart_table(const AssetChart& chart);

/// Every number of all assets, a line for each method and band: for spreadsheets. Empty where there
/// is none.
report::Table chart_numbers(const std::vector<AssetChart>& charts, const ChartOptions& options);

/// Everything on one page, with how it was measured.
///
/// charts  at least one
report::Page chart_page(const std::vector<AssetChart>& charts, const ChartOptions& options);

/// "radiance", "color"; "time", "bytes".
std::string name_of(ErrorKind kind);
std::string name_of(CostAxis axis);

} // namespace scree
