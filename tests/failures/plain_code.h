#pragma once

#include <utility>
#include <vector>

#include "support/memory_source.h"

namespace scree::test {

// The formulas as one types them from a paper, without a guard: what a renderer has that was
// written in an afternoon; and, for the truth, the definitions they come from.

/// Smith's Lambda of Gaussian slopes, (exp(-v^2) - v sqrt(pi) erfc(v)) / (2 v sqrt(pi)), v =
/// (cot - mean) / (sigma sqrt(2)); mean and sigma along the view.
double plain_lambda(double cot, double mean, double sigma);

/// 1 / (1 + Lambda).
double plain_g1(double cot, double mean, double sigma);

/// Walter et al. 2007, eq. 27: the rational fit to Beckmann's G1.
double walter_g1(double cot, double mean, double sigma);

/// Smith's Lambda of Gaussian slopes by its definition, E[max(x - z, 0)] / z with x standard
/// normal, z the cotangent in deviations, above 0; by quadrature.
double lambda_by_quadrature(double z);

/// Mean of the density phi Phi^exponent: by quadrature; and as it is usually typed, over 64 samples
/// from -3 to 3 deviations in single precision.
double visible_height_by_quadrature(double exponent);
double visible_height_by_samples(double exponent);

/// Slopes seen along one axis, as deviations: variance of x, standard normal, under the weight
/// max(0, z - x). By quadrature over u = z - x, for z < 0.
double visible_variance_by_quadrature(double z);

/// A color that covers a share of the footprint at one height.
struct HeightColor {
    double share, color;
};

/// Visible color where a point of height rank q is seen with probability q^exponent:
/// sum of c (P^(1+L) - P_below^(1+L)), P the share at or below. By definition.
double color_by_definition(const std::vector<HeightColor>& rising, double exponent);

/// The same as it is usually typed, sum(c p P^L) / sum(p P^L): P includes the height itself, or
/// not; in single precision.
double color_at_or_below(const std::vector<HeightColor>& rising, double exponent);
double color_below(const std::vector<HeightColor>& rising, double exponent);

/// Of the slopes of a map along s, E[s^2] - E[s]^2 from two running sums in single precision.
double variance_by_float_sums(const MemorySource& map);

/// Texels by rising height, as (height, red); those of one height are one entry of the result.
std::vector<HeightColor> by_rising_height(std::vector<std::pair<double, double>> texels);

} // namespace scree::test
