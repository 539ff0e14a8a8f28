#pragma once

#include <vector>

#include "pipeline/moment_pyramid.h"
#include "texset/manifest.h"

namespace scree {

/// Sums up every level for the manifest.
///
/// Each block of columns keeps its own sums and they are added in the order of the blocks, so the
/// result does not depend on the number of threads.
class LevelStatistics : public TexelVisitor {
public:
    LevelStatistics(const MomentLayout& layout, int width, int height, double h1);

    void texels(int level, int y, int x0, int count, MomentRow row) override;

    [[nodiscard]] std::vector<LevelSummary> summaries() const;

private:
    struct Sums {
        double weight = 0, texels = 0;
        double slope_weight = 0, kurtosis = 0, tau = 0;
        std::vector<double> planes; ///< weighted sum of each moment
        double mean_square = 0;     ///< weighted sum of s^2 + t^2 of the mean slopes
        double steepest_s = 0, steepest_t = 0;
    };
    [[nodiscard]] Sums total(const std::vector<Sums>& blocks) const;

    MomentLayout layout_;
    int width_, height_;
    double h1_;
    std::vector<std::vector<Sums>> blocks_; ///< [level][block]
};

} // namespace scree
