// What C++ needs to read scree_filter.h and the files that go with it: Real is a template
// parameter, float or double. Include kernel/filter.h and its neighbours instead: they take the
// macros back (prelude_cpp_end.h), so those are defined at every inclusion, and the rest only once.

#ifndef SCREE_PRELUDE_CPP
#define SCREE_PRELUDE_CPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace scree::kernel {

using std::abs;
using std::floor;
using std::max;
using std::min;
using std::pow;
using std::sqrt;

/// x rounded to the upper half of its digits; x - high_part(x) is exact, and so is the product of
/// two high parts. By the bits, because a compiler may simplify any arithmetic that does it.
[[gnu::always_inline]] inline float scree_high_part(float x)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    bits = (bits + 0x800U) & 0xfffff000U;
    std::memcpy(&x, &bits, sizeof bits);
    return x;
}
[[gnu::always_inline]] inline double scree_high_part(double x)
{
    uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    bits = (bits + 0x4000000U) & 0xfffffffff8000000U;
    std::memcpy(&x, &bits, sizeof bits);
    return x;
}

/// x, in a way no compiler sees through, so that (a + x) - a stays and a product is not contracted.
/// No number of the kernel has these bits; they are those of a NaN.
[[gnu::always_inline]] inline float scree_opaque(float x)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits == 0x7fc5c4eeU ? 0 : x;
}
[[gnu::always_inline]] inline double scree_opaque(double x)
{
    uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits == 0x7ff8c5c4ee000000U ? 0 : x;
}

/// a b - c d and x - a b - c d rounded once, as the functions of that name in scree_filter.h:
/// double holds the products of floats exactly.
[[gnu::always_inline]] inline float scree_product_difference(float a, float b, float c, float d)
{
    return static_cast<float>(static_cast<double>(a) * static_cast<double>(b) -
                              static_cast<double>(c) * static_cast<double>(d));
}
[[gnu::always_inline]] inline float scree_minus_products(float x, float a, float b, float c,
                                                         float d)
{
    return static_cast<float>(static_cast<double>(x) -
                              static_cast<double>(a) * static_cast<double>(b) -
                              static_cast<double>(c) * static_cast<double>(d));
}

/// 2^-n of the integer n nearest to 0 <= x < 2^31; 0 where n > 118 (double: 1000): what follows
/// from so small a number would be subnormal, and processors take a hundred cycles over those.
/// Through int: rounding to it is one vector instruction everywhere, and so is making the power.
[[gnu::always_inline]] inline float scree_exp2_minus_nearest(float x, float& n)
{
    const auto k = static_cast<int32_t>(x + 0.5F); // NOLINT(bugprone-incorrect-roundings): x >= 0
    n = static_cast<float>(k);
    const uint32_t keep = 0U - static_cast<uint32_t>(k <= 118); // all bits or none
    const auto bits = (static_cast<uint32_t>(127 - k) << 23U) & keep;
    float power = 0;
    std::memcpy(&power, &bits, sizeof bits);
    return power;
}
[[gnu::always_inline]] inline double scree_exp2_minus_nearest(double x, double& n)
{
    const auto k = static_cast<int32_t>(x + 0.5); // NOLINT(bugprone-incorrect-roundings): x >= 0
    n = static_cast<double>(k);
    const uint64_t keep = 0U - static_cast<uint64_t>(k <= 1000);
    const auto bits = (static_cast<uint64_t>(1023 - k) << 52U) & keep;
    double power = 0;
    std::memcpy(&power, &bits, sizeof bits);
    return power;
}

/// m of x = m 2^n, m within a few roundings of [sqrt(1/2), sqrt(2)], n an integer; x > 0, a normal
/// number. Exact.
[[gnu::always_inline]] inline float scree_split(float x, float& n)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    const int32_t k = static_cast<int32_t>(bits - 0x3f3504f3U) >> 23;
    n = static_cast<float>(k);
    bits -= static_cast<uint32_t>(k) << 23U;
    std::memcpy(&x, &bits, sizeof bits);
    return x;
}
[[gnu::always_inline]] inline double scree_split(double x, double& n)
{
    uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    const int64_t k = static_cast<int64_t>(bits - 0x3fe6a09e667f3bcdU) >> 52;
    n = static_cast<double>(k);
    bits -= static_cast<uint64_t>(k) << 52U;
    std::memcpy(&x, &bits, sizeof bits);
    return x;
}

} // namespace scree::kernel

#endif

#pragma push_macro("LIT")
#pragma push_macro("OUT")
#undef LIT
#undef OUT
#define SCREE_FUNCTION                                                                             \
    template <typename Real>                                                                       \
    [[gnu::always_inline]] inline
#define LIT(x) static_cast<Real>(x)
#define OUT(type, name) type& name
