#pragma once

#include <cmath>

namespace scree {

/// Density of the standard normal law.
inline double normal_pdf(double z)
{
    constexpr double kInverseRootTwoPi = 0.39894228040143267794;
    return kInverseRootTwoPi * std::exp(-z * z / 2);
}

/// Distribution function of the standard normal law; keeps its relative accuracy down to z = -37,
/// where it leaves the range of double.
inline double normal_cdf(double z)
{
    constexpr double kInverseRootTwo = 0.70710678118654752440;
    return std::erfc(-z * kInverseRootTwo) / 2;
}

/// log(normal_cdf(z)), accurate on both sides: near z = 9 the distribution function differs from 1
/// by 1e-19, which only its logarithm can hold. -infinity below z = -38.
inline double log_normal_cdf(double z)
{
    return z < 0 ? std::log(normal_cdf(z)) : std::log1p(-normal_cdf(-z));
}

} // namespace scree
