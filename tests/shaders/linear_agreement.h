#pragma once

#include <array>
#include <string>
#include <vector>

#include "kernel/linear_cases.h"
#include "support/files.h"

namespace scree::test {

/// The cases as a texture: a row each, the numbers in texels of four.
Image linear_case_image(const std::vector<LinearCase>& cases);

/// Fails the test where another language's answers are not those of C++ in float32: to 2e-5 of what
/// is of the order of 1, radiances to 2e-4 of the largest there is for that roughness or of
/// themselves.
void expect_linear_agreement(const std::vector<LinearCase>& cases,
                             const std::vector<std::array<float, kLinearOutputs>>& answers,
                             const std::string& language);

} // namespace scree::test
