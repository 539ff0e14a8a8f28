#pragma once

#include <array>
#include <string>
#include <vector>

namespace scree::test {

/// What a case gives scree_linear_light.h, in the order of the parameters of linear_outputs(): the
/// light's two ends and its normal, the surface's normal, the viewer, slope variances and the
/// facets' own roughness. Numbers of float32.
constexpr int kLinearInputs = 18;

/// What comes of it: frame, angles, distance, the peak by Newton's steps, sigma^2, the Gaussian, 8
/// and 12 points, table coordinates.
constexpr int kLinearOutputs = 20;

struct LinearCase {
    std::string name;
    std::array<float, kLinearInputs> in{};
};

/// Lights and views at random, and those where the frame or the light degenerates.
std::vector<LinearCase> linear_cases();

/// The kernel in C++; Real is float or double.
template <typename Real>
std::array<Real, kLinearOutputs> evaluate_linear(const LinearCase& row);

extern template std::array<float, kLinearOutputs> evaluate_linear<float>(const LinearCase&);
extern template std::array<double, kLinearOutputs> evaluate_linear<double>(const LinearCase&);

} // namespace scree::test
