#pragma once

#include "failures/failure_case.h"

namespace scree::test {

/// One file a group; 23 cases in all.
std::vector<FailureCase> direction_cases();  ///< 1, 2, 3: of the view
std::vector<FailureCase> covariance_cases(); ///< 4, 5, 6
std::vector<FailureCase> slope_law_cases();  ///< 7, 8: slopes that are not Gaussian
std::vector<FailureCase> color_cases();      ///< 9, 10, 11
std::vector<FailureCase> relief_cases();     ///< 12, 13: where Smith's masking does not hold
std::vector<FailureCase> number_cases();     ///< 14, 20: of pixel types
std::vector<FailureCase> border_cases();     ///< 15, 16, 19: edges and sizes
std::vector<FailureCase> texel_cases();      ///< 17, 18: missing texels, texels that are no squares
std::vector<FailureCase> filter_cases();     ///< 21, 22, 23: layers, level 0, between levels

/// All of them by number.
std::vector<FailureCase> all_cases();

} // namespace scree::test
