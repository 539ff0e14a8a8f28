#pragma once

#include <vector>

#include "judge/node_check.h"
#include "judge/view_check.h"
#include "report/chart.h"
#include "report/table.h"

namespace scree {

/// Errors of visible color and radiance, angle by angle, all levels together.
report::Table color_table(const ViewCheck& check);

/// The same of masking, and of mean and covariance of the visible slopes.
report::Table slope_table(const ViewCheck& check);

/// The visible color's error by every model that the set has; no rows where it has but the mean.
report::Table model_table(const ViewCheck& check);

/// Errors of the tables of visibility, node by node: all levels together, then each.
report::Table node_table(const NodeCheck& check);

/// Error of the radiance level by level, a column an angle: the set's, or a plain MIP chain's.
report::Table level_table(const ViewCheck& check, double ViewError::*part);

/// Errors of color and radiance over the view's angle: a plain MIP chain, the set, and the
/// reference's own noise.
std::vector<report::Chart> view_charts(const ViewCheck& check);

} // namespace scree
