#pragma once

#include <cstdint>
#include <vector>

namespace scree {

/// A well mixed 32-bit value of a 32-bit key (Wellons' lowbias32).
inline std::uint32_t hash32(std::uint32_t x)
{
    x ^= x >> 16;
    x *= 0x21f0aaadu;
    x ^= x >> 15;
    x *= 0x735a2d97u;
    return x ^ (x >> 15);
}

/// Uniform in [0, 1), from the upper bits of a hash.
inline float unit_float(std::uint32_t hash)
{
    return static_cast<float>(static_cast<std::int32_t>(hash >> 8)) * 0x1p-24f;
}

/// One octave of periodic noise, evaluated a row at a time.
///
/// A lattice of cells_s columns of cells_t points covers the map exactly once. To hide it, columns
/// lean (each crosses `lean` column widths between the top and the bottom of the map) and are
/// shifted along t by random parts of a cell, so no lattice line follows an axis. A column that
/// leaves at the bottom comes in at the top `lean` columns further on, so those two need the same
/// shift: columns c and c + lean are twins, and lean must divide cells_s.
///
/// Each lattice point has a value and a gradient (32 directions, none along an axis). Down a
/// column, and then between columns, the planes they span are blended with the quintic 6 f^5 - 15
/// f^4 + 10 f^3, so the noise is twice differentiable. The value keeps the noise from being zero at
/// every lattice point.
///
/// In a fixed row each column is a straight line in the offset along s: two hashes a column, a
/// polynomial a texel.
class LatticeNoise {
public:
    /// lean  in columns, either sign; 0 or a divisor of cells_s
    LatticeNoise(int cells_s, int cells_t, int lean, int width, int height, std::uint32_t seed);

    /// noise  receives width values of row y
    void row(int y, float* noise) const;

    /// The same with the derivatives along s and t, per cell.
    void row(int y, float* noise, float* ds, float* dt) const;

private:
    /// Cell between two lattice columns: (a + b f) + u(f) (da + db f), for the noise and for d/dt.
    struct Cell {
        float a, b, da, db;

        float at(float f, float u) const { return a + b * f + u * (da + db * f); }
        float along_s(float f, float u, float du) const { return b + u * db + du * (da + db * f); }
    };

    /// phase  receives the position of the first texel in the first cell
    void cells(int y, std::uint64_t* phase, std::vector<Cell>& value, std::vector<Cell>* dt) const;

    /// Calls block(x, cell, f) for eight texels at once where one cell holds them, else texel(...).
    template <class Block, class Texel>
    void walk(std::uint64_t phase, Block block, Texel texel) const;

    int cells_s_, cells_t_, lean_, width_;
    std::uint32_t seed_;
    std::uint64_t step_s_, step_t_, step_lean_; // a texel, in 2^-40 cells
    float step_;                                // step_s_ in cells
};

/// Octaves for a map whose longer side is cut into base_cells, then about 1.93 times as many, ...,
/// while a cell is at least two texels wide; never none. They lean to either side in turn, by a
/// third, except on maps too thin for it.
std::vector<LatticeNoise> make_octaves(double base_cells, int max_octaves, int width, int height,
                                       std::uint32_t seed);

} // namespace scree
