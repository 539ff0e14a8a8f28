#pragma once

#include <array>
#include <string>
#include <vector>

namespace scree::test {

constexpr int kK0Inputs = 20; ///< 17 parameters of k0_case_outputs(), in its order, and three zeros
constexpr int kK0Outputs = 12; ///< likewise

struct K0Case {
    std::string name;
    std::array<float, kK0Inputs> in{};
};

/// Surfaces as they are met and thin ones, views above and below the texture plane, upright and
/// grazing, slopes in the middle and far out, pixels from none to wider than the law, random
/// numbers with their ends. The same at every call.
std::vector<K0Case> k0_cases();

/// In C++.
std::array<float, kK0Outputs> evaluate_k0(const K0Case& row);

/// Fails the test where another language's answers are not those of C++: relative to 1e-5 (slopes:
/// of the deviation and the slope), and finite.
void expect_k0_agreement(const std::vector<K0Case>& cases,
                         const std::vector<std::array<float, kK0Outputs>>& answers,
                         const std::string& language);

} // namespace scree::test
