#include "math/storage.h"

#include <Imath/half.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace scree::test {
namespace {

TEST(StoreHalf, ReadsEveryHalfAsImathDoes)
{
    for (uint32_t bits = 0; bits <= 0xffff; ++bits) {
        const auto truth = static_cast<double>(imath_half_to_float(static_cast<uint16_t>(bits)));
        if (!std::isnan(truth)) {
            ASSERT_EQ(StoreHalf::value(bits), truth) << bits;
        }
    }
}

TEST(StoreHalf, RoundsAsImathDoes)
{
    auto expect_same = [](float value) {
        ASSERT_EQ(StoreHalf::nearest(static_cast<double>(value)), imath_float_to_half(value))
            << std::hexfloat << value;
    };
    // Every half, the middle between it and the next, and the floats on both sides of that.
    for (uint32_t bits = 0; bits < 0x7c00; ++bits) {
        const auto low = static_cast<float>(StoreHalf::value(bits));
        const auto high =
            bits + 1 == 0x7c00 ? 65536.0F : static_cast<float>(StoreHalf::value(bits + 1));
        const float middle = low + (high - low) / 2;
        for (const float value :
             {low, middle, std::nextafter(middle, 0.0F), std::nextafter(middle, 1e9F)}) {
            expect_same(value);
            expect_same(-value);
        }
    }
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-30, 18);
    for (int i = 0; i < 100000; ++i)
        expect_same(static_cast<float>(std::exp2(exponent(random))));
}

TEST(Storage, OneStepUpIsTheNextNumber)
{
    const uint32_t one = StoreFloat::nearest(1);
    EXPECT_EQ(StoreFloat::value(step_up(one)), 1 + std::ldexp(1.0, -23));
    const uint32_t half_one = StoreHalf::nearest(1);
    EXPECT_EQ(StoreHalf::value(step_up(half_one)), 1 + std::ldexp(1.0, -10));
    EXPECT_EQ(StoreHalf::value(step_up(0)), std::ldexp(1.0, -24));
}

} // namespace
} // namespace scree::test
