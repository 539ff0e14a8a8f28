// The four numbers of a direction (tail, shift, narrowing, widening), against the textbook forms in
// a hundred digits, where nothing that cancels is lost.

#include <gtest/gtest.h>

#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>

#include "kernel/filter.h"

namespace scree::test {
namespace {

namespace mp = boost::multiprecision;
using Exact =
    mp::cpp_bin_float_100; // at z = -40 the textbook loses 6, of the tail at z = 18 it loses 73

struct View {
    Exact tail, shift, narrowing, widening;
};

/// From E[W], E[x W], E[x^2 W] and E[|x| W].
View from_integrals(const Exact& z, const Exact& area, const Exact& first, const Exact& second)
{
    const Exact mean = first / area;
    return {area - (z > 0 ? z : Exact(0)), mean, second / area - mean * mean, 1};
}

View gaussian(double at)
{
    const Exact z = at;
    const Exact phi = exp(-z * z / 2) / sqrt(2 * boost::math::constants::pi<Exact>());
    const Exact cdf = boost::math::erfc(Exact(-z / sqrt(Exact(2)))) / 2;
    const Exact area = z * cdf + phi;
    return from_integrals(z, area, -cdf, area + phi);
}

View k0(double at)
{
    const Exact z = at, b = 1 / sqrt(Exact(2)), y = abs(z), e = exp(-y / b);
    if (at < 0) {
        const Exact area = b * e / 2, first = -e * (y * b + 1) / 2;
        View view = from_integrals(z, area, first, e * (y * y * b + 2 * y + 3 * b) / 2);
        view.widening = Exact(1) / 2 - first / area * b;
        return view;
    }
    const Exact area = z + b * e / 2;
    View view =
        from_integrals(z, area, -1 + e * (z * b + 1) / 2, z + e * (z * z * b + 2 * z + 3 * b) / 2);
    view.widening = Exact(1) / 2 + (z * b + e * (z * b + 1) / 2) / area * b;
    return view;
}

double relative(double got, const Exact& want)
{
    return static_cast<double>(Exact(abs(got - want) / abs(want)));
}

/// Larger by far near 0 than elsewhere, so that is where most points are.
std::vector<double> places()
{
    std::vector<double> z;
    for (double at = 1e-4; at < 40; at *= 1.15) {
        z.push_back(at);
        z.push_back(-at);
    }
    z.push_back(0);
    return z;
}

template <typename Real>
class FourNumbers : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(FourNumbers, Reals);

TYPED_TEST(FourNumbers, OfGaussianSlopesMatchTheTextbook)
{
    using Real = TypeParam;
    const bool single = sizeof(Real) == 4;
    double worst_tail = 0, worst_shift = 0, worst_narrowing = 0;
    for (const double at : places()) {
        const Real z = static_cast<Real>(at);
        const View want = gaussian(static_cast<double>(z));
        Real tail = 0, shift = 0, narrowing = 0;
        kernel::scree_gaussian_view(z, tail, shift, narrowing);
        if (std::abs(at) < (single ? 8 : 18))
            worst_tail = std::max(worst_tail, relative(tail, want.tail));
        worst_shift = std::max(worst_shift, relative(shift, want.shift));
        worst_narrowing = std::max(worst_narrowing, relative(narrowing, want.narrowing));
    }
    this->RecordProperty("tail", std::to_string(worst_tail * 1e9));
    this->RecordProperty("shift", std::to_string(worst_shift * 1e9));
    this->RecordProperty("narrowing", std::to_string(worst_narrowing * 1e9));
    EXPECT_LE(worst_tail, single ? 1e-6 : 3e-8);
    EXPECT_LE(worst_shift, single ? 1e-6 : 3e-8);
    EXPECT_LE(worst_narrowing, single ? 5e-6 : 4e-8);
}

TYPED_TEST(FourNumbers, OfK0SlopesMatchTheTextbook)
{
    using Real = TypeParam;
    const double tolerance = sizeof(Real) == 4 ? 5e-6 : 3e-8;
    for (const double at : places()) {
        const Real z = static_cast<Real>(at);
        const View want = k0(static_cast<double>(z));
        Real tail = 0, shift = 0, narrowing = 0, widening = 0;
        kernel::scree_k0_view(z, tail, shift, narrowing, widening);
        EXPECT_LE(relative(tail, want.tail), tolerance) << at;
        EXPECT_LE(relative(shift, want.shift), tolerance) << at;
        EXPECT_LE(relative(narrowing, want.narrowing), tolerance) << at;
        EXPECT_LE(relative(widening, want.widening), tolerance) << at;
    }
}

TYPED_TEST(FourNumbers, OfAMixtureAtItsEndsAreThoseOfItsParts)
{
    using Real = TypeParam;
    for (const double at : places()) {
        const Real z = static_cast<Real>(at);
        Real tail = 0, shift = 0, narrowing = 0, widening = 0;
        Real of_tail = 0, of_shift = 0, of_narrowing = 0, of_widening = 1;
        kernel::scree_gaussian_view(z, of_tail, of_shift, of_narrowing);
        for (const Real tau : {Real(-1), Real(0)}) {
            kernel::scree_mixture_view(z, tau, tail, shift, narrowing, widening);
            EXPECT_EQ(tail, of_tail);
            EXPECT_EQ(shift, of_shift);
            EXPECT_EQ(narrowing, of_narrowing);
            EXPECT_EQ(widening, of_widening);
        }
        kernel::scree_k0_view(z, of_tail, of_shift, of_narrowing, of_widening);
        for (const Real tau : {Real(1), Real(2)}) {
            kernel::scree_mixture_view(z, tau, tail, shift, narrowing, widening);
            EXPECT_NEAR(tail, of_tail, 1e-7 * of_tail);
            EXPECT_NEAR(shift, of_shift, 1e-5 * std::abs(of_shift));
            EXPECT_NEAR(narrowing, of_narrowing, 1e-5);
            EXPECT_NEAR(widening, of_widening, 1e-5 * of_widening);
        }
    }
}

} // namespace
} // namespace scree::test
