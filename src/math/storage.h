#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

namespace scree {

/// How a number is stored in a file: IEEE binary32, or binary16 by its bits.
///
/// Both are sign and magnitude, so adding one to the bits of a finite number is one step away
/// from zero; `step_up` relies on it. Bits are worked with in 32-bit words, which is what
/// processors have vectors of, and narrowed to `Bits` at the end.
struct StoreFloat {
    using Bits = uint32_t;

    static uint32_t nearest(double value)
    {
        const auto rounded = static_cast<float>(value);
        uint32_t bits = 0;
        std::memcpy(&bits, &rounded, sizeof bits);
        return bits;
    }
    static double value(uint32_t bits)
    {
        float stored = 0;
        std::memcpy(&stored, &bits, sizeof stored);
        return static_cast<double>(stored);
    }
};

struct StoreHalf {
    using Bits = uint16_t;

    /// Rounded to the nearest, ties to even, as Imath and processors do it; without branches, so
    /// that loops over it are vectorised. By way of float: that moves a value within 2^-24 of the
    /// middle of two halves, far below the step between them.
    static uint32_t nearest(double value)
    {
        const uint32_t with_sign = StoreFloat::nearest(value);
        const uint32_t bits = with_sign & 0x7fffffffU;
        // Normal halves: round at bit 13, carry into the exponent, change its bias.
        const uint32_t normal = (bits + 0xfffU + ((bits >> 13) & 1U) - (112U << 23)) >> 13;
        // Below 2^-14: adding 1/2 makes the processor round at 2^-24, the step of subnormals.
        const auto shifted = static_cast<float>(StoreFloat::value(bits)) + 0.5F;
        uint32_t shifted_bits = 0;
        std::memcpy(&shifted_bits, &shifted, sizeof shifted);
        const uint32_t small = shifted_bits - 0x3f000000U;
        const uint32_t magnitude = bits >= 0x477ff000U  ? 0x7c00U // 65520 and up: infinite
                                   : bits < 0x38800000U ? small
                                                        : normal;
        return magnitude | ((with_sign >> 16) & 0x8000U);
    }

    static double value(uint32_t bits)
    {
        // The exponent's bias changed by a multiplication, which also mends subnormals.
        const double magnitude = StoreFloat::value((bits & 0x7fffU) << 13) * 0x1p112;
        const double finite =
            magnitude < 65536 ? magnitude : std::numeric_limits<double>::infinity();
        return (bits & 0x8000U) != 0 ? -finite : finite;
    }
};

/// The next stored number above `bits`, which holds a number >= 0 and below the largest.
inline uint32_t step_up(uint32_t bits) { return bits + 1; }

} // namespace scree
