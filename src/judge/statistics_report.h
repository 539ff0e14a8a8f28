#pragma once

#include <vector>

#include "judge/statistics_check.h"
#include "report/table.h"

namespace scree {

/// The worst level of each figure of each texture.
report::Table statistics_table(const std::vector<StatisticsFigure>& figures);

} // namespace scree
