#pragma once

#include "kernel/cases.h"

namespace scree::test {

/// What the kernel should have answered, in numbers of many digits from the case's float32 inputs
/// taken as exact. No line in common with src/kernel: the Gaussian part is the published nine
/// integrals (Heitz et al. 2013, supplement, eq. 61 to 69 with the errors of published_test.cpp
/// mended), the tails are integrals of a polynomial times exp(t) over a half line.

/// Whether the oracle knows the case: its covariance is exactly positive semi-definite.
bool has_oracle(const KernelCase& row);

/// Whether [ss st; st tt] has no negative eigenvalue, without rounding.
bool positive_semi_definite(double ss, double st, double tt);

enum class Digits { k60, k100 };

/// All outputs but kDiffuse (0), rounded once at the end. Those that depend on Smith's Lambda take
/// the true one. Requires has_oracle(row).
Outputs<double> oracle(const KernelCase& row, Digits digits = Digits::k100);

/// Replaces what depends on Lambda (height, color by height and by rank, map) by what it is for
/// that exponent: a kernel's own Lambda, so that its error is not counted twice.
void take_exponent(const KernelCase& row, double exponent, Outputs<double>& outputs);

/// Likewise the measured exponent, for that Lambda of the raw moments.
void take_raw_lambda(const KernelCase& row, double lambda, Outputs<double>& outputs);

/// E[W], E[W d], E[W d d'] of the slope d from a given point, W = max(0, wz - w.slope).
struct FacingMoments {
    double area, s, t, ss, st, tt;
};

/// For Gaussian slopes of the case's mean and `spread` times its covariance; its tau is ignored.
FacingMoments gaussian_facing_moments(const KernelCase& row, double spread, double from_s,
                                      double from_t);

/// a / b of the case: the deviations of slope between the mean plane and the grazing one.
/// Infinite where the slope does not spread along the view.
double grazing_distance(const KernelCase& row);

} // namespace scree::test
