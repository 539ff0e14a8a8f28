#include "shaders/agreement.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scree::test {

namespace {

constexpr double kTolerance = 1e-5;
constexpr double kPowerTolerance = 3e-5; ///< of what goes by the language's own pow
constexpr double kSmallestNormal = 1.2e-38;

/// What the difference of an output is compared with.
double scale(const KernelCase& row, const Outputs<float>& want, int output)
{
    const double itself = std::abs(static_cast<double>(want[static_cast<size_t>(output)]));
    const auto in = [&](int i) { return static_cast<double>(row.in[static_cast<size_t>(i)]); };
    const auto out = [&](Output i) { return static_cast<double>(want[i]); };
    switch (output) {
    case kVisibleS:
    case kVisibleT:
        return std::max(itself, std::sqrt(std::abs(in(kCss) + in(kCtt))));
    case kVisibleSs:
    case kVisibleSt:
    case kVisibleTt:
        return out(kVisibleSs) + out(kVisibleTt);
    case kRawCss:
    case kRawCst:
    case kRawCtt:
        return out(kRawCss) + out(kRawCtt);
    case kByVisibility:
        return std::max(itself, in(kTableC)); // a difference may be all but black
    case kSeenAndLit:
        return std::max({itself, in(kTableC), in(kLitC), out(kByVisibility)});
    case kMeasured: { // what a relative error of Lambda becomes in the power of a difference
        const double lambda = out(kRawLambda);
        const double above = std::max(lambda - in(kThreshold), kSmallestNormal);
        // Less than a millionth is no exponent; the smallest numbers end elsewhere in OSL.
        return std::max(itself * std::max(1.0, lambda * in(kPower) / above), 1e-6);
    }
    case kDiffuse:
        return std::max(itself, 1e-6); // a reflectance: less is black
    default:
        return itself;
    }
}

} // namespace

void expect_agreement(const std::vector<KernelCase>& cases,
                      const std::vector<Outputs<float>>& answers, const std::string& language)
{
    ASSERT_EQ(cases.size(), answers.size());
    ASSERT_GT(cases.size(), 300U);
    Outputs<double> worst{};
    for (size_t k = 0; k < cases.size(); ++k) {
        const Outputs<float> want = evaluate<float>(cases[k]);
        const Outputs<float>& got = answers[k];
        for (int i = 0; i < kOutputs; ++i) {
            const double w = static_cast<double>(want[static_cast<size_t>(i)]);
            const double g = static_cast<double>(got[static_cast<size_t>(i)]);
            ASSERT_TRUE(std::isfinite(g)) << language << ": " << output_name(i) << " is " << g
                                          << " for " << describe(cases[k]);
            const double error =
                std::abs(g - w) / std::max(scale(cases[k], want, i), kSmallestNormal);
            auto& most = worst[static_cast<size_t>(i)];
            if (std::abs(g - w) > kSmallestNormal && error > most) {
                most = error;
                EXPECT_LE(error, i == kMeasured ? kPowerTolerance : kTolerance)
                    << language << ": " << output_name(i) << " is " << g << ", in C++ " << w
                    << ", for " << describe(cases[k]);
            }
        }
        const auto ss = static_cast<double>(got[kVisibleSs]);
        const auto st = static_cast<double>(got[kVisibleSt]);
        const auto tt = static_cast<double>(got[kVisibleTt]);
        const bool given = static_cast<double>(cases[k].in[kCss]) * cases[k].in[kCtt] >=
                           static_cast<double>(cases[k].in[kCst]) * cases[k].in[kCst];
        if (given && cases[k].in[kCss] >= 0) {
            EXPECT_TRUE(ss >= 0 && tt >= 0 && ss * tt >= st * st)
                << language << ": visible covariance " << ss << ' ' << st << ' ' << tt << " for "
                << describe(cases[k]);
        }
    }
    for (int i = 0; i < kOutputs; ++i)
        ::testing::Test::RecordProperty(std::string("worst ") + output_name(i),
                                        fmt::format("{:.1e}", worst[static_cast<size_t>(i)]));
}

} // namespace scree::test
