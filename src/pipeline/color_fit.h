#pragma once

#include <optional>
#include <vector>

#include "pipeline/moment_pyramid.h"
#include "texset/manifest.h"

namespace scree {

/// Measures, level by level, how much of the color inside texels each color model accounts for.
///
/// R^2 is the variance a model explains over all there is, both summed over texels (weighted with
/// coverage) and over R, G, B:
///   height       cov(c, h)^2 / var(h)           the line of scree_color_by_height
///   slope        cov(c, p)' C^-1 cov(c, p)      the plane of scree_color_by_slope
///   rank K       sum over n <= K of a_n^2 / (2 n + 1)   the Legendre series, orthogonal on ranks
/// A color that does not go with height is explained by no function of height or rank; what is
/// left of a shuffled color in a footprint of few texels is chance: 1 / (texels - 1) a term.
///
/// Each block of columns keeps its own sums and they are added in order, so the result does not
/// depend on the number of threads.
class ColorFitStatistics : public TexelVisitor {
public:
    /// layout  with color and its variance
    ColorFitStatistics(const MomentLayout& layout, int width, int height);

    void texels(int level, int y, int x0, int count, MomentRow row) override;

    /// Of all levels; empty where the color does not vary inside texels, as on level 0.
    [[nodiscard]] std::vector<std::optional<ColorFit>> fits() const;

private:
    struct Sums {
        double weight = 0;
        std::array<double, 3> variance{}, by_height{}, by_slope{};
        std::array<double, 3> with_height{}; ///< covariance with the height
        double height_variance = 0;
        std::array<double, kMaxRankTerms> by_rank{}; ///< a term each, all channels
        void add(const Sums& other);
    };
    void add_heights(MomentRow row, int count, Sums& sums) const;
    void add_slopes(MomentRow row, int count, Sums& sums) const;
    [[nodiscard]] ColorFit fit_of(const Sums& sums) const;

    MomentLayout layout_;
    std::vector<std::vector<Sums>> blocks_; ///< [level][block]
};

} // namespace scree
