#include "stats/raw_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "math/storage.h"
#include "stats/merge.h"

namespace scree::test {
namespace {

/// Slopes of all sizes, with correlation up to exactly +-1: the worst that rounding can meet.
struct HardSlopes {
    std::vector<double> s, t, ss, tt, st;

    HardSlopes(int count, unsigned seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> exponent(-12, 6), sign(-1, 1);
        const double correlations[] = {1, -1, 1 - 1e-9, -1 + 1e-6, 0.999, 0};
        for (int i = 0; i < count; ++i) {
            const double a = std::exp2(exponent(random)), b = std::exp2(exponent(random));
            s.push_back(std::exp2(exponent(random)) * std::copysign(1.0, sign(random)));
            t.push_back(std::exp2(exponent(random)) * std::copysign(1.0, sign(random)));
            ss.push_back(i % 17 == 0 ? 0 : a * a);
            tt.push_back(b * b);
            st.push_back(i % 17 == 0 ? 0 : correlations[i % 6] * a * b);
        }
    }
};

template <class Store>
void expect_semi_definite_and_near(double relative_step, double smallest_step)
{
    const int count = kMergeRun;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const HardSlopes hard(count, seed);
        using Bits = typename Store::Bits;
        std::vector<Bits> s(kMergeRun), t(s), ss(s), tt(s), st(s);
        store_slopes({hard.s.data(), hard.t.data(), hard.ss.data(), hard.tt.data(), hard.st.data()},
                     count, s.data(), t.data(), ss.data(), tt.data(), st.data());
        for (size_t i = 0; i < s.size(); ++i) {
            const double ms = Store::value(s[i]), mt = Store::value(t[i]);
            const double css = Store::value(ss[i]) - ms * ms, ctt = Store::value(tt[i]) - mt * mt;
            const double cst = Store::value(st[i]) - ms * mt;
            ASSERT_GE(css, 0) << i;
            ASSERT_GE(ctt, 0) << i;
            ASSERT_GE(css * ctt - cst * cst, 0) << i;
            // Nearest, plus at most three steps up of numbers as large as these.
            const double slack = 4 * relative_step;
            EXPECT_NEAR(css, hard.ss[i], slack * (hard.ss[i] + ms * ms) + 4 * smallest_step) << i;
            EXPECT_NEAR(ctt, hard.tt[i], slack * (hard.tt[i] + mt * mt) + 4 * smallest_step) << i;
            EXPECT_NEAR(cst, hard.st[i],
                        relative_step * (std::abs(hard.st[i]) + std::abs(ms * mt)) + smallest_step)
                << i;
        }
    }
}

TEST(RawMoments, FloatSlopesReadBackSemiDefinite)
{
    expect_semi_definite_and_near<StoreFloat>(std::ldexp(1.0, -23), std::ldexp(1.0, -149));
}

TEST(RawMoments, PairsNeverGiveANegativeVarianceInFloatArithmeticEither)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<double> exponent(-12, 7);
    std::vector<double> mean, variance;
    for (int i = 0; i < kMergeRun; ++i) {
        mean.push_back(std::exp2(exponent(random)));
        variance.push_back(i % 2 == 0 ? 0 : 1e-9 * mean.back());
    }
    std::vector<uint32_t> x(kMergeRun), xx(kMergeRun);
    store_pairs(mean.data(), variance.data(), kMergeRun, x.data(), xx.data());
    std::vector<uint16_t> hx(kMergeRun), hxx(kMergeRun);
    store_pairs(mean.data(), variance.data(), kMergeRun, hx.data(), hxx.data());
    for (size_t i = 0; i < x.size(); ++i) {
        const auto m = static_cast<float>(StoreFloat::value(x[i]));
        EXPECT_GE(static_cast<float>(StoreFloat::value(xx[i])) - m * m, 0.0F) << mean[i];
        const auto h = static_cast<float>(StoreHalf::value(hx[i]));
        EXPECT_GE(static_cast<float>(StoreHalf::value(hxx[i])) - h * h, 0.0F) << mean[i];
    }
}

TEST(RawMoments, HalfSlopesReadBackSemiDefinite)
{
    expect_semi_definite_and_near<StoreHalf>(std::ldexp(1.0, -10), std::ldexp(1.0, -24));
}

} // namespace
} // namespace scree::test
