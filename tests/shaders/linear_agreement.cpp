#include "shaders/linear_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scree::test {

Image linear_case_image(const std::vector<LinearCase>& cases)
{
    Image image{(kLinearInputs + 3) / 4, static_cast<int>(cases.size()), {"R", "G", "B", "A"}, {}};
    for (const LinearCase& row : cases) {
        image.pixels.insert(image.pixels.end(), row.in.begin(), row.in.end());
        image.pixels.resize(image.pixels.size() + (4 - kLinearInputs % 4) % 4);
    }
    return image;
}

void expect_linear_agreement(const std::vector<LinearCase>& cases,
                             const std::vector<std::array<float, kLinearOutputs>>& answers,
                             const std::string& language)
{
    constexpr size_t kDistance = 1, kSigma2 = 12, kGaussian = 13, kTwelve = 15;
    ASSERT_FALSE(cases.empty());
    for (size_t row = 0; row < cases.size(); ++row) {
        const auto want = evaluate_linear<float>(cases[row]);
        for (size_t i = 0; i < want.size(); ++i) {
            // A whole peak is about 0.3 / (distance sigma).
            const double brightest = 0.3 / static_cast<double>(want[kDistance]) /
                                     std::sqrt(static_cast<double>(want[kSigma2]));
            const bool radiance = i >= kGaussian && i <= kTwelve;
            const double tolerance =
                radiance ? 1e-4 * std::min(brightest, 100.0)
                         : 2e-5 * std::max(1.0, std::abs(static_cast<double>(want[i])));
            EXPECT_NEAR(answers[row][i], want[i], tolerance)
                << language << ", output " << i << ", " << cases[row].name << ' ' << row;
        }
    }
}

} // namespace scree::test
