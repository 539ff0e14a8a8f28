#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace scree::reference {

/// Scatters the bits of a number: a bijection after which neighbouring numbers have nothing in
/// common (the finaliser of Steele, Lea and Flood's SplitMix64, 2014).
inline uint64_t scattered(uint64_t x)
{
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// Two uniform numbers in [0, 1) that depend on nothing but what is asked for.
inline std::array<double, 2> jitter(uint64_t seed, uint64_t footprint, uint64_t sample)
{
    const uint64_t bits = scattered(scattered(scattered(seed) ^ footprint) ^ sample);
    return {static_cast<double>(bits >> 32) * 0x1p-32,
            static_cast<double>(bits & 0xffffffffU) * 0x1p-32};
}

/// Which half of the samples (column, row) of the grid belongs to.
///
/// Of each 2x2 block one diagonal goes to one half and one to the other, by chance. So what
/// changes linearly over a block does not tell the halves apart, and what the diagonals differ by
/// does not add up over the blocks, as it would on a checkerboard.
inline size_t half_of(uint64_t seed, uint64_t footprint, uint64_t column, uint64_t row)
{
    const uint64_t block = (column / 2) << 32 | row / 2;
    const uint64_t chance = scattered(scattered(scattered(~seed) ^ footprint) ^ block);
    return (column + row + chance) % 2;
}

} // namespace scree::reference
