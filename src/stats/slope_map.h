#pragma once

#include "stats/moment_layout.h"

namespace scree {

/// Slopes that go through a linear map of their own in every texel: s' = a s, t' = b s + c t.
struct SlopeMap {
    float a = 1, b = 0, c = 1;
};

/// Maps mean, covariance and, where the layout has them, third and fourth central moments of the
/// slopes of one row: C' = L C L', and so on by the binomial law for the higher ones.
///
/// maps     one a texel
/// count    texels
/// moments  with slopes, and no other moment that goes with them yet
void map_slopes(const MomentLayout& layout, const SlopeMap* maps, int count, MomentRow moments);

} // namespace scree
