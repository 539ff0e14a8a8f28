#pragma once

#include <array>
#include <string>
#include <vector>

#include "support/random_image.h"

namespace scree::test {

/// wo, wi, then coordinates h, phi_h, k, phi_k (half/difference: h and k times 90 degrees), and two
/// numbers not used.
using BrdfCase = std::array<float, 12>;

/// Coordinates of wo and wi: 4 of half/difference, 4 orthographic, 4 hybrid, 7 isotropic; the
/// three reaches; wo.z, wi.z, |wo|^2, |wi|^2 of the given coordinates in the three systems; wo and
/// wi of the coordinates that were made of them, in the three systems; the place of wo and wi in a
/// table; one not used.
using BrdfOutputs = std::array<float, 56>;

/// Directions of direction_pairs(), every fourth of the grid and the random ones, and coordinates
/// within and beyond what two directions above the surface have.
std::vector<BrdfCase> brdf_cases();

/// The cases as an image of 3 x cases texels.
Image brdf_image(const std::vector<BrdfCase>& cases);

/// Fails the test where directions do not come back to 1e-5 (over z or h_z at the horizon, as in
/// kernel/brdf_coordinates_test.cpp), coordinates are not those of C++ to 1e-5 of their vectors'
/// length, or what has no solution does not give unit vectors above the surface.
///
/// language  for messages
void expect_brdf_agreement(const std::vector<BrdfCase>& cases,
                           const std::vector<BrdfOutputs>& answers, const std::string& language);

} // namespace scree::test
