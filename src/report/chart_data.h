#pragma once

#include <string>
#include <vector>

#include "report/chart.h"

namespace scree::report {

/// Whether a point has a place: both its numbers are finite.
bool is_shown(const ChartPoint& p);
bool has_spread(const ChartPoint& p);

/// What the axes have to reach: numbers of points that are shown, their spreads included.
std::vector<double> shown_x(const Chart& chart);
std::vector<double> shown_y(const Chart& chart);

/// On what a chart cannot show, or shows in a place that is not its own.
std::vector<std::string> remarks_on(const Chart& chart);

/// "1 point", "3 points"
std::string counted(int count, const char* noun);

} // namespace scree::report
