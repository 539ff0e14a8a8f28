#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/relief.h"

namespace scree::reference {

constexpr int kMaxRankTerms = 8;

/// a_1 .. a_8 of R, G, B.
using RankTerms = std::array<Rgb, kMaxRankTerms>;

/// A part of a footprint by its height.
struct Ranked {
    double height = 0; ///< in any unit
    double weight = 0; ///< > 0
    size_t texel = 0;  ///< index into the colors
};

/// Color as a function of the height's rank in the footprint, in shifted Legendre polynomials:
///
///   a_n = (2 n + 1) E[c P_n(2 q - 1)]
///
/// q is the rank, uniform in [0, 1]: parts are sorted by height, each as wide as its share of the
/// weight; parts of one height share theirs and show their mean color. P_n by its recurrence, its
/// mean over a width by 5 points of Gauss and Legendre, exact to degree 9.
///
/// parts   in any order; they are sorted
/// terms   0 to kMaxRankTerms; the others stay 0
RankTerms rank_terms(std::vector<Ranked>& parts, const std::vector<Rgb>& colors, int terms);

} // namespace scree::reference
