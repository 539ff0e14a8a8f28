#pragma once

#include "stats/moment_layout.h"

namespace scree {

/// How slopes follow from heights at the texel centres.
enum class Reconstruction {
    bilinear, ///< the bilinear surface, its slopes integrated over the texel, exact
    central,  ///< one slope a texel, (h(x+1) - h(x-1)) / (2 dx)
    sobel,    ///< one slope a texel, 3x3 Sobel / 8, as `maketx --bumpslopes` takes it
};

/// Three padded rows of heights around a row of texels; entry 0 is the texel left of texel 0.
struct HeightRows {
    const double* above;
    const double* center;
    const double* below;

    [[nodiscard]] HeightRows from(int x) const { return {above + x, center + x, below + x}; }
};

/// Slope moments of the texels of one row, from the heights around them.
///
/// bilinear: a texel is four quarter cells of the bilinear surface. In each, ds h is linear in t
/// alone and dt h linear in s alone, so the slope is uniform on a rectangle, centre (a, b), half
/// widths (p, q), and s and t are independent there:
///   mean = sum (a, b) / 4
///   E[(s - mean)^2] = sum (a'^2 + p^2/3) / 4,  E[(s-..)(t-..)] = sum a' b' / 4,  a' = a - mean
///   third: a'^3 + a' p^2;  fourth: a'^4 + 2 a'^2 p^2 + p^4/5
/// The left upper quarter has a = (3 D + D-) / 4 and p = (D - D-) / 4, with D the difference to
/// the left neighbour over dx and D- the same one row up. Derived in docs/statistics.md.
///
/// rows          heights in world units, no NaN among the 3x3 of any texel
/// count         texels, at most kMergeRun
/// texel_width, texel_height  world units
/// moments       gets mean, covariance and, if the layout has them, tail moments of the slope
void slope_moments(const MomentLayout& layout, Reconstruction reconstruction, HeightRows rows,
                   int count, double texel_width, double texel_height, MomentRow moments);

/// The same where heights may be missing (NaN), texel by texel; a missing texel gets zeros.
void slope_moments_with_holes(const MomentLayout& layout, Reconstruction reconstruction,
                              HeightRows rows, int count, double texel_width, double texel_height,
                              MomentRow moments);

} // namespace scree
