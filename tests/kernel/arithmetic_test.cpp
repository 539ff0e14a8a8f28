// The kernel's own arithmetic: exact differences of products, exp, the normal density, atan2.

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <random>

#include "kernel/filter.h"

namespace scree::test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

template <typename Real>
Real uniform(std::mt19937& random, double low, double high)
{
    return static_cast<Real>(low + (high - low) * static_cast<double>(random()) / 4294967296.0);
}

/// The shared text of scree_filter.h, which C++ single precision replaces by double arithmetic.
template <typename Real>
Real product_difference(Real a, Real b, Real c, Real d)
{
    return kernel::scree_product_difference<Real>(a, b, c, d);
}
template <typename Real>
Real minus_products(Real x, Real a, Real b, Real c, Real d)
{
    return kernel::scree_minus_products<Real>(x, a, b, c, d);
}

template <typename Real>
class Arithmetic : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Arithmetic, Reals);

// Half a unit in the last place for the one rounding, and a little for the error terms' own.
TYPED_TEST(Arithmetic, DifferencesOfProductsAreRoundedOnce)
{
    using Real = TypeParam;
    const double unit = std::numeric_limits<Real>::epsilon();
    std::mt19937 random(1);
    int cancelled = 0;
    for (int i = 0; i < 20000; ++i) {
        const Real a = uniform<Real>(random, -2, 2), b = uniform<Real>(random, -2, 2);
        const Real c = uniform<Real>(random, -2, 2);
        // Every other one cancels to the rounding of d, x.
        const Real d = i % 2 == 0 ? a * b / c : uniform<Real>(random, -2, 2);
        const Real x = i % 2 == 0 ? a * b + c * d : uniform<Real>(random, -2, 2);
        const Exact difference = Exact(a) * Exact(b) - Exact(c) * Exact(d);
        const Exact rest = Exact(x) - Exact(a) * Exact(b) - Exact(c) * Exact(d);
        EXPECT_LE(abs(Exact(product_difference(a, b, c, d)) - difference),
                  0.51 * unit * abs(difference))
            << a << ' ' << b << ' ' << c << ' ' << d;
        // Two sums round their error terms: 2^-2p of the largest number.
        EXPECT_LE(abs(Exact(minus_products(x, a, b, c, d)) - rest),
                  0.51 * unit * abs(rest) + 8 * unit * unit)
            << x << ' ' << a << ' ' << b << ' ' << c << ' ' << d;
        cancelled += abs(difference) < 4 * unit ? 1 : 0;
    }
    EXPECT_GT(cancelled, 9000); // the test is about these
}

// In C++ float the same two functions go through double; overloads are chosen without <Real>.
TEST(ArithmeticFloat, ThroughDoubleIsTheSameAsTheSharedText)
{
    std::mt19937 random(2);
    int different = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto a = uniform<float>(random, -2, 2), b = uniform<float>(random, -2, 2);
        const auto c = uniform<float>(random, -2, 2);
        const float d = i % 2 == 0 ? a * b / c : uniform<float>(random, -2, 2);
        different += kernel::scree_product_difference(a, b, c, d) !=
                             kernel::scree_product_difference<float>(a, b, c, d)
                         ? 1
                         : 0;
    }
    EXPECT_LE(different, 2); // ties of the rounding
}

// x has an error of half a unit in its last place: x eps / 2 of exp(-x).
TYPED_TEST(Arithmetic, ExpMinusIsWithinItsFitOrTheRoundingOfItsArgument)
{
    using Real = TypeParam;
    const double unit = std::numeric_limits<Real>::epsilon();
    const double lowest = sizeof(Real) == 4 ? 81 : 690;
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
        const auto x = uniform<Real>(random, 0, i % 2 == 0 ? 2 : lowest);
        const double want = std::exp(-static_cast<double>(x));
        EXPECT_NEAR(static_cast<double>(kernel::scree_exp_minus(x)) / want, 1,
                    1e-8 + 3 * unit + 0.5 * unit * static_cast<double>(x))
            << x;
    }
    EXPECT_EQ(kernel::scree_exp_minus(Real(0)), Real(1));
    EXPECT_EQ(kernel::scree_exp_minus(Real(9999)), Real(0));
}

TYPED_TEST(Arithmetic, NormalDensityKeepsItsDigitsFarOut)
{
    using Real = TypeParam;
    const double limit = sizeof(Real) == 4 ? 12.7 : 37;
    std::mt19937 random(4);
    for (int i = 0; i < 20000; ++i) {
        const auto y = uniform<Real>(random, 0, limit);
        const auto exact = static_cast<double>(y);
        const double want = std::exp(-exact * exact / 2) / std::sqrt(2 * std::acos(-1.0));
        EXPECT_NEAR(static_cast<double>(kernel::scree_normal_pdf(y)) / want, 1,
                    sizeof(Real) == 4 ? 5e-7 : 1.2e-8)
            << y;
    }
    for (const double far : {14.0, 120.0, 1e4, 1e18})
        if (sizeof(Real) == 4 || far > 100) {
            EXPECT_EQ(kernel::scree_normal_pdf(static_cast<Real>(far)), Real(0)) << far;
        }
}

// Three roundings of 1 at worst. Angles are whole 1024ths: where compilers contract, a rounded
// product would be another angle inside the function than outside.
TYPED_TEST(Arithmetic, SineAndCosineAreThoseOfTheStandardLibrary)
{
    using Real = TypeParam;
    const double tolerance = sizeof(Real) == 4 ? 2e-7 : 3.4e-16;
    for (int i = -20480; i <= 20480; ++i) {
        const Real angle = static_cast<Real>(i) / 1024;
        Real sine = 0, cosine = 0;
        kernel::scree_sine_cosine(angle, sine, cosine);
        ASSERT_NEAR(static_cast<double>(sine), std::sin(static_cast<double>(angle)), tolerance)
            << i;
        ASSERT_NEAR(static_cast<double>(cosine), std::cos(static_cast<double>(angle)), tolerance)
            << i;
    }
}

TYPED_TEST(Arithmetic, Atan2IsThatOfTheStandardLibrary)
{
    using Real = TypeParam;
    const double tolerance = sizeof(Real) == 4 ? 4e-7 : 9e-16;
    for (int i = -3599; i <= 3600; ++i)
        for (const double length : {1e-30, 3.0, 1e30}) {
            const double angle = i * std::acos(-1.0) / 3600;
            const Real x = static_cast<Real>(length * std::cos(angle));
            const Real y = static_cast<Real>(length * std::sin(angle));
            ASSERT_NEAR(static_cast<double>(kernel::scree_atan2(y, x)),
                        std::atan2(static_cast<double>(y), static_cast<double>(x)), tolerance)
                << i;
        }
    EXPECT_EQ(kernel::scree_atan2(Real(0), Real(0)), Real(0));
    EXPECT_EQ(kernel::scree_atan2(Real(0), Real(1)), Real(0));
    EXPECT_EQ(kernel::scree_atan2(Real(0), Real(-1)), static_cast<Real>(std::acos(-1.0)));
}

} // namespace
} // namespace scree::test
