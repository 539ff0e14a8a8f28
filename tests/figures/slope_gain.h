#pragma once

#include "figures/slope_table.h"
#include "figures/slope_truth.h"

namespace scree::test {

/// Mean and covariance as they were baked, as if all of the surface was seen.
SeenSlopes unchanged(const filter::Slopes<double>& baked);

/// The kernel's closed form of what w sees, with K0 tails of weight tau in place of the baked ones.
SeenSlopes closed_form(const Vec3& w, const filter::Slopes<double>& baked, double tau);

/// What the closed form is corrected by, one pair of numbers a level.
struct SlopeGain {
    double mean = 1;       ///< times what it shifts the mean by
    double covariance = 1; ///< times its covariance
};

/// Least squares of a level, all nodes and azimuths together, by the area that is seen.
SlopeGain fitted_gain(const SlopesOfSize& size, const SlopeViews& views);

/// The closed form of the baked slopes' own tau, by such gains.
SeenSlopes gained(const Vec3& w, const filter::Slopes<double>& baked, const SlopeGain& gain);

} // namespace scree::test
