#pragma once

#include <Imath/half.h>

#include <cstdint>
#include <cstring>
#include <limits>

namespace scree {

/// How a number is stored in a file: IEEE binary32, or binary16 by its bits.
///
/// Both are sign and magnitude, so adding one to the bits of a finite number is one step away
/// from zero; `step_up` relies on it.
struct StoreFloat {
    using Bits = uint32_t;
    static constexpr double kLargest = std::numeric_limits<float>::max();

    static Bits nearest(double value)
    {
        const auto rounded = static_cast<float>(value);
        Bits bits = 0;
        std::memcpy(&bits, &rounded, sizeof bits);
        return bits;
    }
    static double value(Bits bits)
    {
        float stored = 0;
        std::memcpy(&stored, &bits, sizeof stored);
        return static_cast<double>(stored);
    }
};

struct StoreHalf {
    using Bits = uint16_t;
    static constexpr double kLargest = 65504;

    static Bits nearest(double value)
    {
        // By way of float: the double rounding moves a value that lies within 2^-24 of the middle
        // of two halves, which is far below the half step it is measured against.
        return imath_float_to_half(static_cast<float>(value));
    }
    static double value(Bits bits) { return static_cast<double>(imath_half_to_float(bits)); }
};

/// The next stored number above `bits`, which holds a number >= 0 and below the largest.
template <class Store>
typename Store::Bits step_up(typename Store::Bits bits)
{
    return static_cast<typename Store::Bits>(bits + 1);
}

} // namespace scree
