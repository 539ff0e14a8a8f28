#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/color_models.h"
#include "pipeline/exponent_fit.h"
#include "pipeline/measured_views.h"
#include "pipeline/moment_pyramid.h"
#include "pipeline/texture_values.h"
#include "texset/manifest.h"

namespace scree {

/// What was measured of the models of color, cheapest first.
struct MeasuredModels {
    std::vector<ModelRecord> models;
    std::vector<VisibilityPlan> tables;          ///< of each model; without nodes where it has none
    std::vector<std::vector<LevelError>> levels; ///< what the models leave of each level
    std::vector<std::optional<ExponentFit>> exponents; ///< a level; absent without heights
    double without_colorslope = 0, without_tail = 0;   ///< what is lost without a map
};

/// Measures what every way to show the visible color (pipeline/color_models.h) costs, over the
/// views a recipe allows.
///
/// Truth is what the views see of the heights themselves: E[c V W] / E[V W] of the footprint, from
/// sweeps (visibility/sweep.h). The error of a model at a level and elevation is the rms over
/// texels, azimuths and R, G, B, relative to the rms of the map's mean color; texels count by the
/// area a view sees of them, as in a picture, and by coverage. Of a model at a level it is that of
/// the worst elevation, of a model as a whole the rms over the levels above the finest: each is as
/// likely to be looked up. The models stop at black, as the kernel does: of negative colors that is
/// part of their error.
///
/// Two maps are judged by what the view loses without them: color-slope by the color it would
/// add, likewise relative; tail by how much it changes the projected area, relative, and the
/// visible mean slope.
///
/// Texels are picked by a hash of their place, about 2^18 level-0 texels' worth a level, 64 texels
/// at least; the same ones for any number of threads.
class ModelErrors : public TexelVisitor {
public:
    /// layout  with slope; with color, height and views, in the order of `views`, where color by
    ///         height is to be judged
    /// scale   world heights from normalised ones, which `map` is looked up with
    /// map     table of a color map by height, or null; outlives this
    /// tables  of visibility, their components in the layout; models are their subsets
    ModelErrors(const MomentLayout& layout, const ValueScale& scale, const MapTable* map,
                const TableSizes& tables, const MeasuredViews& views, int width, int height);

    void texels(int level, int y, int x0, int count, MomentRow row) override;

    /// After the pass; fits what is fitted. Without views there are no errors of models.
    [[nodiscard]] MeasuredModels measured() const;

private:
    /// Squared errors of one model, an elevation each.
    using Squares = std::vector<double>;
    struct Sums {
        double texels = 0;        ///< weight of the texels
        std::vector<double> seen; ///< an elevation: weight times area seen
        std::vector<Squares> models;
        Squares colorslope, tail;
        std::optional<ExponentBins> exponent;
    };

    /// What a view sees of a texel.
    struct Truth {
        double area; ///< over that of a plane
        Rgb color;
    };

    [[nodiscard]] bool is_picked(int level, int x, int y) const;
    [[nodiscard]] Truth truth_of(const MeasuredTexel& texel, int view) const;
    void add_slopes(const MeasuredTexel& texel, Sums& sums) const;
    void add_colors(const MeasuredTexel& texel, Sums& sums) const;
    /// The squared error of each model that shows something.
    void add_models(const SeenTexel& seen, const Rgb& truth, size_t elevation, double weight,
                    Sums& sums) const;
    [[nodiscard]] Sums total(int level) const;
    [[nodiscard]] double color_size() const;
    [[nodiscard]] double largest_error(const Sums& sums, size_t model,
                                       const std::optional<ExponentFit>& fit) const;

    MomentLayout layout_;
    MeasuredViews views_;
    std::vector<CandidateModel> models_;
    std::vector<double> picked_;            ///< share of the texels of a level
    std::vector<std::vector<Sums>> blocks_; ///< [level][block]
    Rgb mean_color_{};                      ///< of the whole map: of the last level's one texel
};

} // namespace scree
