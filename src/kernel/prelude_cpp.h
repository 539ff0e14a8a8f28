#pragma once

// What C++ needs to read scree_filter.h: Real is a template parameter, float or double. Include
// kernel/filter.h instead; it undefines the macros again.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#define SCREE_FUNCTION                                                                             \
    template <typename Real>                                                                       \
    inline
#define LIT(x) static_cast<Real>(x)
#define OUT(type, name) type& name

namespace scree::kernel {

using std::abs;
using std::max;
using std::min;
using std::sqrt;

/// x with the lower half of its digits cleared; x - high_part(x) is exact, and so is the product
/// of two high parts. By the bits, because a compiler may simplify any arithmetic that does it.
inline float scree_high_part(float x)
{
    uint32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    bits &= 0xfffff000U;
    std::memcpy(&x, &bits, sizeof bits);
    return x;
}
inline double scree_high_part(double x)
{
    uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    bits &= 0xfffffffff8000000U;
    std::memcpy(&x, &bits, sizeof bits);
    return x;
}

/// x, in a way that keeps a shading compiler from simplifying (a + x) - a; C++ compilers do not.
template <typename Real>
inline Real scree_opaque(Real x)
{
    return x;
}

/// 2^-k of an integer k >= 0; 0 where that is no normal number any more.
inline float scree_exp2_minus(float k)
{
    const auto bits = static_cast<uint32_t>(127 - min(static_cast<int32_t>(k), 127)) << 23U;
    float power = 0;
    std::memcpy(&power, &bits, sizeof bits);
    return power;
}
inline double scree_exp2_minus(double k)
{
    const auto bits = static_cast<uint64_t>(1023 - min(static_cast<int32_t>(k), 1023)) << 52U;
    double power = 0;
    std::memcpy(&power, &bits, sizeof bits);
    return power;
}

/// The integer part of 0 <= x < 2^31. Through int: that is one vector instruction everywhere.
template <typename Real>
inline Real scree_truncate(Real x)
{
    return static_cast<Real>(static_cast<int32_t>(x));
}

} // namespace scree::kernel
