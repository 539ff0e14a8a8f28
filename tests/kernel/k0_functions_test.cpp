// What scree_k0.h calls: logarithm, cosine and sine of a turn, Bessel functions.

#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kernel/k0.h"

namespace scree::test {
namespace {

template <typename Real>
class K0Functions : public ::testing::Test {
protected:
    static constexpr bool kSingle = sizeof(Real) == 4;

    void SetUp() override { worst_ = 0; }
    void compare(Real got, long double want, double at)
    {
        const auto error = static_cast<double>(std::abs(static_cast<long double>(got) / want - 1));
        if (error > worst_) {
            worst_ = error;
            at_ = at;
        }
    }
    void expect_below(const std::string& name, double tolerance)
    {
        this->RecordProperty(name, std::to_string(worst_ * 1e9));
        EXPECT_LE(worst_, tolerance) << name << " at " << at_;
        EXPECT_GT(worst_, 0) << name << ": nothing was compared";
        worst_ = 0;
    }

private:
    double worst_ = 0, at_ = 0;
};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(K0Functions, Reals);

/// Everywhere, in equal ratios, and on both sides of the places where the formulas change.
std::vector<double> places(double low, double high)
{
    std::vector<double> x;
    for (double at = low; at < high; at *= 1.01)
        x.push_back(at);
    for (const double seam : {2.0, 4.0})
        for (const double aside : {-1e-3, -1e-7, 0.0, 1e-7, 1e-3})
            if (seam < high)
                x.push_back(seam + aside);
    x.push_back(high);
    return x;
}

TYPED_TEST(K0Functions, LogarithmKeepsItsDigitsNearOneToo)
{
    using Real = TypeParam;
    for (const double at : places(1e-30, 1e30))
        for (const Real x : {static_cast<Real>(at), static_cast<Real>(1 + at)})
            if (x != Real(1) && x < Real(1e30))
                this->compare(kernel::scree_log(x), std::log(static_cast<long double>(x)), at);
    this->expect_below("log", this->kSingle ? 3e-7 : 1e-9);
    EXPECT_EQ(kernel::scree_log(Real(1)), Real(0));
}

// K0 and K1 over (0, 80]: beyond, exp(-x) ends in single precision.
TYPED_TEST(K0Functions, BesselK)
{
    using Real = TypeParam;
    for (const double at : places(1e-18, 80)) {
        const Real x = static_cast<Real>(at);
        const auto exact = static_cast<long double>(x);
        Real growth = 0;
        const Real k0 = kernel::scree_bessel_k0(x, growth);
        this->compare(k0 * kernel::scree_exp_minus(-growth), boost::math::cyl_bessel_k(0, exact),
                      at);
    }
    this->expect_below("K0", this->kSingle ? 1e-6 : 3e-8);
    for (const double at : places(1e-18, 80)) {
        const Real x = static_cast<Real>(at);
        const auto exact = static_cast<long double>(x);
        Real growth = 0;
        const Real xk1 = kernel::scree_bessel_x_k1(x, growth);
        this->compare(xk1 * kernel::scree_exp_minus(-growth),
                      exact * boost::math::cyl_bessel_k(1, exact), at);
    }
    this->expect_below("x K1", this->kSingle ? 1e-6 : 3e-8);
}

TYPED_TEST(K0Functions, BesselI)
{
    using Real = TypeParam;
    for (const double at : places(1e-9, 80)) {
        const Real x = static_cast<Real>(at);
        const auto exact = static_cast<long double>(x);
        Real growth = 0;
        const Real i0 = kernel::scree_bessel_i0(x, growth);
        this->compare(
            i0, boost::math::cyl_bessel_i(0, exact) * std::exp(-static_cast<long double>(growth)),
            at);
    }
    this->expect_below("I0", this->kSingle ? 1e-6 : 3e-8);
    for (const double at : places(1e-9, 80)) {
        const Real x = static_cast<Real>(at);
        const auto exact = static_cast<long double>(x);
        Real growth = 0;
        const Real i1 = kernel::scree_bessel_i1_per_x(x, growth);
        this->compare(i1,
                      boost::math::cyl_bessel_i(1, exact) / exact *
                          std::exp(-static_cast<long double>(growth)),
                      at);
    }
    this->expect_below("I1 / x", this->kSingle ? 1e-6 : 3e-8);
}

// 1 - x K1(x) and I0(x) - 1 of small x, where the plain differences have no digit left.
TYPED_TEST(K0Functions, DifferencesOfBesselFunctionsFromTheirLimits)
{
    using Real = TypeParam;
    for (const double at : places(1e-2, 2)) {
        const Real x = static_cast<Real>(at);
        const auto exact = static_cast<long double>(x);
        this->compare(kernel::scree_bessel_k1_fall(x),
                      (1 - exact * boost::math::cyl_bessel_k(1, exact)) / (exact * exact), at);
    }
    this->expect_below("1 - x K1", this->kSingle ? 1e-6 : 3e-8);
    for (const double at : places(1e-2, 4)) {
        const Real x = static_cast<Real>(at);
        const auto exact = static_cast<long double>(x);
        this->compare(kernel::scree_bessel_i0_rise(x),
                      (boost::math::cyl_bessel_i(0, exact) - 1) / (exact * exact), at);
    }
    this->expect_below("I0 - 1", this->kSingle ? 1e-6 : 3e-8);
    // Smaller yet, by the leading terms of the series; the next are below x^2 ln x.
    const long double euler = 0.577215664901532861L;
    for (const double at : places(1e-18, 1e-6)) {
        const Real x = static_cast<Real>(at);
        const auto exact = static_cast<long double>(x);
        this->compare(kernel::scree_bessel_k1_fall(x), (0.5L - euler - std::log(exact / 2)) / 2,
                      at);
    }
    this->expect_below("1 - x K1 of tiny x", this->kSingle ? 1e-6 : 3e-8);
}

} // namespace
} // namespace scree::test
