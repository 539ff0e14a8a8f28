#pragma once

#include <string>
#include <vector>

#include "kernel/cases.h"

namespace scree::test {

/// Fails the test where another language's answers to the table of cases are not those of C++ in
/// float32 to 1e-5, not finite, or a visible covariance that is not positive semi-definite.
///
/// Relative to the number itself; the visible mean relative to the larger of it and the standard
/// deviation of the slope, covariances relative to their trace, the slope mean of raw moments to
/// the moments, the diffuse reflection and the measured exponent to at least 1e-6; that exponent,
/// of the language's own pow, to 3e-5 and to what an error of Lambda becomes in it. Below the
/// smallest normal float both may be anything as small.
///
/// language  for messages
void expect_agreement(const std::vector<KernelCase>& cases,
                      const std::vector<Outputs<float>>& answers, const std::string& language);

} // namespace scree::test
