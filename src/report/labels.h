#pragma once

#include <optional>
#include <vector>

#include "report/svg.h"

namespace scree::report {

/// A straight line that labels had better not cross.
struct Stroke {
    Spot from, to;
};

/// Words that want to stand beside a point.
struct LabelWish {
    Spot point;
    double width = 0, height = 0; ///< of the words
};

/// The place in a box that is nearest to a point.
Spot nearest_in(const Box& box, const Spot& point);

/// Places labels beside their points: inside the frame, off the points and strokes and off each
/// other, as near as that allows.
///
/// Every label has the same few dozen candidates around its point; labels take the cheapest in
/// turn, and again until none wants to move (a descent, not the optimum: the problem is hard).
///
/// points   centres of all markers, radius around them to be kept free
/// returns  a box for each wish; nothing where every place would cover another label or a marker
std::vector<std::optional<Box>> place_labels(const std::vector<LabelWish>& wishes,
                                             const std::vector<Spot>& points, double radius,
                                             const std::vector<Stroke>& strokes, const Box& frame);

} // namespace scree::report
