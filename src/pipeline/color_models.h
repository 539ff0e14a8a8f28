#pragma once

#include <functional>
#include <vector>

#include "color/map_table.h"
#include "kernel/filter.h"
#include "pipeline/measured_views.h"
#include "pipeline/texture_values.h"
#include "stats/moment_layout.h"
#include "texset/manifest.h"

namespace scree {

/// A texel of any level, as a renderer would look it up; in doubles, before it is stored.
struct MeasuredTexel {
    /// row  moments, at the texel
    MeasuredTexel(const MomentLayout& layout, MomentRow row);

    [[nodiscard]] double value(int plane) const { return row.plane(plane)[0]; }
    /// R, G, B in consecutive planes.
    [[nodiscard]] Rgb rgb(int plane) const;
    /// The slopes about the texture plane, of mean 0: what an exponent that is fitted goes by.
    [[nodiscard]] filter::Slopes<double> about_plane() const;

    MomentRow row;
    double weight = 0; ///< coverage, in [0, 1]
    filter::Slopes<double> slopes;
    Rgb color{};                       ///< mean; black without
    double height = 0, height_var = 0; ///< mean and variance, normalised; 0 without
};

/// A texel from a view: what every model of color goes by.
struct SeenTexel {
    SeenTexel(const MeasuredTexel& texel, const MeasuredView& view);

    const MeasuredTexel& texel;
    filter::Vec3<double> w; ///< unit, to the viewer
    double lambda;          ///< Smith's, in [0, 1e6]
    filter::VisibleHeight<double> height;
};

/// A way to show the visible color, and what it reads.
struct CandidateModel {
    ModelRecord record;   ///< its name, channels and rank terms
    VisibilityPlan table; ///< of visibility; without nodes where it has none
    /// The color shown, scene-linear. Empty for the model whose exponent is fitted to what is seen
    /// (pipeline/exponent_fit.h): before that it shows nothing.
    std::function<Rgb(const SeenTexel&)> shown;

    [[nodiscard]] bool is_fitted() const { return !shown; }
};

/// All models that a layout allows, cheapest first: the mean color; a color map by height; 1, 2,
/// 4, ... terms by height rank, and all there are; color by height, with Smith's exponent and with
/// a fitted one; of the tables of visibility the whole, and parts of it.
///
/// scale   world heights from normalised ones, which `map` is looked up with
/// map     table of a color map by height, or null; outlives the models
/// tables  of visibility, their components in the layout
std::vector<CandidateModel> candidate_models(const MomentLayout& layout, const ValueScale& scale,
                                             const MapTable* map, const TableSizes& tables);

} // namespace scree
