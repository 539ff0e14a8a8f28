#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/node_check.h"
#include "judge/original.h"
#include "judge/set_reader.h"
#include "judge/statistics_check.h"
#include "judge/texel_images.h"
#include "judge/view_check.h"

namespace scree {

/// Errors above which a set is out of tolerance; absent: reported, not judged.
///
/// Statistics are judged by StatisticsFigure::tolerance, times `statistics`. The others are
/// ViewErrors over all levels, of the worst angle, with the reference's noise taken off.
struct Tolerances {
    double statistics = 1;
    std::optional<double> color, radiance, masking, slope, covariance;
    /// Of NodeErrors, area and color, likewise: over all levels, of the worst node.
    std::optional<double> tables;
};

/// Whether any but the statistics has one.
bool has_tolerance_of_views(const Tolerances& tolerances);

/// What to validate a set with.
struct ValidationPlan {
    bool views = true;  ///< compare with the reference, where there are heights and colors
    bool images = true; ///< draw a level, for a page
    ViewPlan view;
    Tolerances tolerances;
};

/// What came of it.
struct Validation {
    std::vector<StatisticsFigure> statistics;
    std::optional<ViewCheck> views;  ///< absent: not asked for, or not possible
    std::optional<NodeCheck> tables; ///< absent like `views`, and where the set has none
    std::string without_views;       ///< why it was not possible; empty: it was
    std::vector<TexelImages> images;
    std::vector<std::string> flags;    ///< what about the asset no model shows well
    std::vector<std::string> exceeded; ///< tolerances; empty: the set is valid
};

/// Compares a set with the surface it was baked from. Tolerances of views that could not be
/// compared are exceeded.
///
/// Throws Error where the set cannot be read or is not of that surface's size, Cancelled when asked
/// to stop.
Validation validate(SetReader& set, Original original, const BakeOptions& options,
                    const ValidationPlan& plan, const BakeMonitor& monitor);

} // namespace scree
