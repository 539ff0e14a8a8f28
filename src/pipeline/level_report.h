#pragma once

#include <optional>

#include "pipeline/color_fit.h"
#include "pipeline/level_statistics.h"

namespace scree {

/// What the manifest says of every level: statistics, and how well the color models fit.
class LevelReport {
public:
    LevelReport(const MomentLayout& layout, int width, int height, double h1);

    /// To be given to a MomentPyramid.
    std::vector<TexelVisitor*> visitors();

    [[nodiscard]] std::vector<LevelSummary> summaries() const;

private:
    LevelStatistics statistics_;
    std::optional<ColorFitStatistics> color_fit_;
};

} // namespace scree
