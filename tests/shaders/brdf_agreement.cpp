#include "shaders/brdf_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/direction_pairs.h"

namespace scree::test {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTolerance = 1e-5;
constexpr size_t kIsotropic = 12, kReach = 19, kBeyond = 22, kBack = 34, kPlace = 52;

filter::Directions<double> directions_of(const BrdfCase& row)
{
    return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
}

double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

/// Worst component of both directions.
double worst_apart(const filter::Directions<double>& w, const float* got)
{
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        worst = std::max({worst, std::abs(w.wo[i] - static_cast<double>(got[i])),
                          std::abs(w.wi[i] - static_cast<double>(got[3 + i]))});
    return worst;
}

void expect_round_trips(const filter::Directions<double>& w, const BrdfOutputs& got)
{
    const double low = std::max(std::min(w.wo.z, w.wi.z), 1e-2);
    const double mean = std::max(0.5 * (w.wo.z + w.wi.z), 1e-2);
    EXPECT_LT(worst_apart(w, &got[kBack]), kTolerance);
    EXPECT_LT(worst_apart(w, &got[kBack + 6]) * low, kTolerance);
    EXPECT_LT(worst_apart(w, &got[kBack + 12]) * mean, kTolerance);
}

/// Where every vector is long enough to have its angles.
void expect_coordinates(const filter::Directions<double>& w, const BrdfOutputs& got)
{
    const auto half = filter::half_difference(w);
    const auto flat = filter::orthographic(w);
    const auto both = filter::hybrid(w);
    const auto reduced = filter::isotropic_coordinates(w);
    const double cos_d = std::cos(half.theta_d), k_flat = flat.k_bar, h = flat.h_bar;
    const std::array<std::pair<double, double>, 19> all = {{{half.theta_h, cos_d},
                                                            {half.phi_h, h},
                                                            {half.theta_d, 1},
                                                            {half.phi_d, h * both.k},
                                                            {h, 1},
                                                            {flat.phi_h, h},
                                                            {k_flat, 1},
                                                            {flat.phi_k, k_flat},
                                                            {both.h_bar, 1},
                                                            {both.phi_h, h},
                                                            {both.k, 1},
                                                            {both.phi_k, k_flat},
                                                            {reduced.theta_h, cos_d},
                                                            {reduced.theta_d, 1},
                                                            {reduced.phi_d, h * both.k},
                                                            {reduced.h_bar, 1},
                                                            {reduced.k_bar, 1},
                                                            {reduced.k, 1},
                                                            {reduced.azimuth, h * k_flat}}};
    static_assert(kIsotropic + 7 == kReach);
    for (size_t i = 0; i < all.size(); ++i)
        EXPECT_LT(apart(static_cast<double>(got[i]), all[i].first) * all[i].second, kTolerance)
            << "output " << i << " is " << got[i] << ", in C++ " << all[i].first;
}

/// As what they are of: the angle of x, the share of y, the azimuth of z.
void expect_place(const filter::Directions<double>& w, const BrdfOutputs& got)
{
    const auto want = filter::hybrid_place(w);
    const auto c = filter::isotropic_coordinates(w);
    const double x = got[kPlace], y = got[kPlace + 1], z = got[kPlace + 2];
    for (const double each : {x, y, z})
        EXPECT_TRUE(each >= 0 && each <= 1) << each;
    EXPECT_NEAR(std::sin(x * x * kPi / 2), std::sin(want.x * want.x * kPi / 2), kTolerance);
    const double reach = kernel::scree_hybrid_reach(c.h_bar, c.azimuth);
    EXPECT_LT(std::abs(std::sin(y * kPi / 2) - std::sin(want.y * kPi / 2)) * reach * c.h_bar * c.k,
              10 * kTolerance); // the reach by the azimuth, with its rounding
    EXPECT_LT(std::abs(z - want.z) * c.h_bar * c.k_bar, kTolerance);
}

void expect_beyond(const BrdfCase& row, const BrdfOutputs& got)
{
    const double h = static_cast<double>(row[6]);
    const double azimuth = static_cast<double>(row[9]) - static_cast<double>(row[7]);
    EXPECT_NEAR(got[kReach], kernel::scree_half_difference_reach(h * kPi / 2, azimuth), 1e-5);
    // At h_bar = 1 the reach is 0 as a root.
    EXPECT_NEAR(got[kReach + 1], kernel::scree_orthographic_reach(h, azimuth), 1e-3);
    EXPECT_NEAR(got[kReach + 2], kernel::scree_hybrid_reach(h, azimuth), 1e-3);
    for (size_t system = 0; system < 3; ++system) {
        const float* of = &got[kBeyond + 4 * system];
        EXPECT_GE(std::min(of[0], of[1]), 0);
        EXPECT_NEAR(of[2], 1, 1e-6);
        EXPECT_NEAR(of[3], 1, 1e-6);
    }
}

} // namespace

std::vector<BrdfCase> brdf_cases()
{
    std::vector<BrdfCase> cases;
    size_t n = 0;
    for (const auto& [name, w] : direction_pairs()) {
        ++n;
        if ((name == "grid" || name == "random") && n % 16 != 0)
            continue;
        const auto f = [](double x) { return static_cast<float>(x); };
        const auto turn = static_cast<double>(n);
        cases.push_back({f(w.wo.x), f(w.wo.y), f(w.wo.z), f(w.wi.x), f(w.wi.y), f(w.wi.z),
                         f(static_cast<double>(n % 31) / 30), f(std::sin(turn * 1.3) * 3),
                         f(static_cast<double>(n % 37) / 36), f(std::cos(turn * 0.7) * 3), 0, 0});
    }
    return cases;
}

Image brdf_image(const std::vector<BrdfCase>& cases)
{
    Image image{3, static_cast<int>(cases.size()), {"R", "G", "B", "A"}, {}};
    for (const BrdfCase& row : cases)
        image.pixels.insert(image.pixels.end(), row.begin(), row.end());
    return image;
}

void expect_brdf_agreement(const std::vector<BrdfCase>& cases,
                           const std::vector<BrdfOutputs>& answers, const std::string& language)
{
    ASSERT_EQ(cases.size(), answers.size());
    ASSERT_GT(cases.size(), 4000U);
    for (size_t n = 0; n < cases.size(); ++n) {
        const auto w = directions_of(cases[n]);
        const testing::ScopedTrace trace(
            __FILE__, __LINE__,
            ::testing::Message() << language << ": case " << n << ", wo " << w.wo << " wi " << w.wi
                                 << ", h " << cases[n][6] << ' ' << cases[n][7] << " k "
                                 << cases[n][8] << ' ' << cases[n][9]);
        expect_round_trips(w, answers[n]);
        if (w.wo.z > 1e-2 || w.wi.z > 1e-2)
            expect_coordinates(w, answers[n]);
        if (std::min(w.wo.z, w.wi.z) > 1e-2)
            expect_place(w, answers[n]);
        expect_beyond(cases[n], answers[n]);
        if (testing::Test::HasFailure())
            return; // one is enough
    }
}

} // namespace scree::test
