#include "kernel/k0_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "kernel/k0.h"

// case_outputs is to be read as the kernel is
#include "kernel/prelude_cpp.h"

namespace scree::kernel {
#include "kernel/k0_case_outputs.h"
} // namespace scree::kernel

namespace scree::test {

namespace {

const char* const kNames[kK0Outputs] = {
    "pdf", "mixture pdf", "ndf",     "visible pdf", "projected area", "Lambda",
    "G1",  "profile",     "slope s", "slope t",     "facing slope s", "facing slope t"};

/// What the difference of an output is compared with.
double scale(const K0Case& row, size_t output, double want)
{
    if (output < 8)
        return std::abs(want);
    const auto in = [&](size_t i) { return static_cast<double>(row.in[i]); };
    return std::abs(want) + std::abs(in(3)) + std::abs(in(4)) + std::sqrt(in(5) + in(7));
}

} // namespace

std::vector<K0Case> k0_cases()
{
    std::mt19937 random(20261123);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    std::vector<K0Case> rows;
    for (int n = 0; n < 600; ++n) {
        const double theta = n % 10 == 0 ? 0 : uniform(0, n % 4 == 0 ? 3.1 : 1.57);
        const double phi = uniform(-3.14, 3.14);
        const double sigma = std::exp(uniform(-5, 0.5)), other = sigma * std::exp(uniform(-2, 2));
        const double r = n % 6 == 0 ? 0.99 : uniform(-0.9, 0.9);
        const double ms = uniform(-1, 1), mt = uniform(-1, 1);
        const double d = n % 15 == 0 ? 0 : std::exp(uniform(-9, 3)), turn = uniform(-3.14, 3.14);
        const double rho = n % 3 == 0 ? 0 : std::exp(uniform(-7, 2.5));
        const double x = d * std::cos(turn), y = d * std::sin(turn);
        const double values[] = {std::sin(theta) * std::cos(phi),
                                 std::sin(theta) * std::sin(phi),
                                 std::cos(theta),
                                 ms,
                                 mt,
                                 sigma * sigma,
                                 r * sigma * other,
                                 other * other,
                                 uniform(-0.1, 1.1),
                                 ms + sigma * x,
                                 mt + other * (r * x + std::sqrt(1 - r * r) * y),
                                 rho};
        K0Case row;
        std::ostringstream name;
        name << "case " << n << " theta " << theta << " d " << d << " rho " << rho << " r " << r;
        row.name = name.str();
        std::transform(std::begin(values), std::end(values), row.in.begin(),
                       [](double value) { return static_cast<float>(value); });
        for (size_t i = 12; i < 17; ++i) // every digit is in all languages the same
            row.in[i] = n % 40 == 7 ? 0 : static_cast<float>(random() >> 8U) / 16777216.0F;
        rows.push_back(row);
    }
    return rows;
}

std::array<float, kK0Outputs> evaluate_k0(const K0Case& row)
{
    const auto& i = row.in;
    std::array<float, kK0Outputs> o{};
    kernel::k0_case_outputs(i[0], i[1], i[2], i[3], i[4], i[5], i[6], i[7], i[8], i[9], i[10],
                            i[11], i[12], i[13], i[14], i[15], i[16], o[0], o[1], o[2], o[3], o[4],
                            o[5], o[6], o[7], o[8], o[9], o[10], o[11]);
    return o;
}

void expect_k0_agreement(const std::vector<K0Case>& cases,
                         const std::vector<std::array<float, kK0Outputs>>& answers,
                         const std::string& language)
{
    constexpr double kSmallestNormal = 1.2e-38;
    ASSERT_EQ(cases.size(), answers.size());
    ASSERT_GT(cases.size(), 300U);
    std::array<double, kK0Outputs> worst{};
    for (size_t k = 0; k < cases.size(); ++k) {
        const auto all = evaluate_k0(cases[k]);
        for (size_t i = 0; i < all.size(); ++i) {
            const auto want = static_cast<double>(all[i]);
            const auto got = static_cast<double>(answers[k][i]);
            ASSERT_TRUE(std::isfinite(got) && std::isfinite(want))
                << language << ": " << kNames[i] << " is " << got << ", in C++ " << want << ", for "
                << cases[k].name;
            const double apart = std::abs(got - want);
            const double error =
                apart > kSmallestNormal ? apart / std::max(scale(cases[k], i, want), 1e-38) : 0;
            worst[i] = std::max(worst[i], error);
            EXPECT_LE(error, 1e-5) << language << ": " << kNames[i] << " is " << got << ", in C++ "
                                   << want << ", for " << cases[k].name;
        }
    }
    for (size_t i = 0; i < worst.size(); ++i) {
        std::ostringstream text;
        text << worst[i];
        ::testing::Test::RecordProperty(std::string("worst ") + kNames[i], text.str());
    }
}

} // namespace scree::test
