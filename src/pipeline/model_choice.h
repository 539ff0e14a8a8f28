#pragma once

#include <vector>

#include "pipeline/model_errors.h"
#include "pipeline/options.h"
#include "texset/manifest.h"

namespace scree {

/// Which models a set needs so that no view loses more than the tolerance: of the ways to show
/// color by height the one of fewest channels that is within it, or where none is, within it of the
/// most accurate; and color-slope and tail where more is lost without them.
///
/// A surface colored by slope needs no way to show color by height: its table sees the slope.
///
/// maps  all that the inputs allow
ModelChoice choose_models(const MeasuredModels& measured, const std::vector<Map>& maps,
                          const BakeOptions& options);

/// The maps that a choice reads. Slope, color and coverage stay in any case; a color map by slope
/// stays in place of color-slope, its first order.
std::vector<Map> maps_of(const ModelChoice& choice, const std::vector<Map>& maps,
                         const BakeOptions& options);

/// Terms of the rank table that a choice reads; 0 for none.
int rank_terms_of(const ModelChoice& choice);

/// The table of visibility that a choice reads; without nodes where it has none.
VisibilityPlan table_of(const ModelChoice& choice, const MeasuredModels& measured);

} // namespace scree
