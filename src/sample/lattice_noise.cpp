#include "sample/lattice_noise.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace scree {
namespace {

constexpr int kFractionBits = 40;
constexpr int kBlock = 8;

struct Gradient {
    float s, t;
};

constexpr int kDirections = 32;

std::array<Gradient, kDirections> make_directions()
{
    std::array<Gradient, kDirections> directions;
    for (int k = 0; k < kDirections; ++k) {
        const double angle = 2 * 3.14159265358979323846 * (k + 0.5) / kDirections;
        directions[static_cast<size_t>(k)] = {static_cast<float>(std::cos(angle)),
                                              static_cast<float>(std::sin(angle))};
    }
    return directions;
}

/// How far the value at a lattice point may be from 0.
constexpr float kValueRange = 0.45f;

float fraction(std::uint64_t phase)
{
    const auto bits = static_cast<std::int32_t>((phase >> (kFractionBits - 24)) & 0xffffff);
    return static_cast<float>(bits) * 0x1p-24f;
}

std::uint64_t cell_step(int cells, int texels)
{
    // Rounded: off by at most 2^-41 cell a texel, 2^-21 cell over the largest map.
    return ((static_cast<std::uint64_t>(cells) << kFractionBits) +
            static_cast<std::uint64_t>(texels) / 2) /
           static_cast<std::uint64_t>(texels);
}

float fade(float f) { return f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f); }
float fade_slope(float f) { return 30.0f * f * f * (f * (f - 2.0f) + 1.0f); }

} // namespace

LatticeNoise::LatticeNoise(int cells_s, int cells_t, int lean, int width, int height,
                           std::uint32_t seed)
    : cells_s_(cells_s), cells_t_(cells_t), lean_(lean), width_(width), seed_(hash32(seed)),
      step_s_(cell_step(cells_s, width)), step_t_(cell_step(cells_t, height)),
      step_lean_(cell_step(std::abs(lean), height)), step_(static_cast<float>(step_s_) * 0x1p-40f)
{
    assert(lean == 0 || cells_s % lean == 0);
}

void LatticeNoise::cells(int y, std::uint64_t* phase, std::vector<Cell>& value,
                         std::vector<Cell>* dt) const
{
    static const std::array<Gradient, kDirections> gradients = make_directions();

    // Rows and the first texel are taken at their middle, so maps of all sizes show one surface.
    const std::uint64_t t2 = 2 * static_cast<std::uint64_t>(y) + 1;
    const std::uint64_t around = static_cast<std::uint64_t>(cells_s_) << kFractionBits;
    const std::uint64_t leant = t2 * step_lean_ / 2 % around;
    const std::uint64_t start = (step_s_ / 2 + (lean_ < 0 ? around - leant : leant) +
                                 (static_cast<std::uint64_t>(seed_) << (kFractionBits - 32))) %
                                around;
    *phase = start & ((std::uint64_t(1) << kFractionBits) - 1);

    // What column c spans at this row, a + b * (offset along s), and its derivative along t.
    struct Line {
        float a, b, dt_a, dt_b;
    };
    const int twins = lean_ == 0 ? cells_s_ : std::abs(lean_);
    auto column = [&](int c, int twin) {
        const std::uint32_t shift = hash32(seed_ - static_cast<std::uint32_t>(twin) - 1);
        const std::uint64_t along =
            t2 * step_t_ / 2 + (static_cast<std::uint64_t>(shift) << (kFractionBits - 32));
        auto point = [&](int j) {
            int i = c;
            for (; j >= cells_t_; j -= cells_t_) {
                i -= lean_;
                i += i < 0 ? cells_s_ : i >= cells_s_ ? -cells_s_ : 0;
            }
            return hash32(seed_ + static_cast<std::uint32_t>(i) * 0x9e3779b9u +
                          static_cast<std::uint32_t>(j) * 0x85ebca6bu);
        };
        const auto j = static_cast<int>(along >> kFractionBits);
        const std::uint32_t hash0 = point(j), hash1 = point(j + 1);
        const float f = fraction(along), v = fade(f), dv = fade_slope(f);
        const Gradient g0 = gradients[hash0 % kDirections];
        const Gradient g1 = gradients[hash1 % kDirections];
        const float p0 = kValueRange * (2 * unit_float(hash0) - 1) + g0.t * f;
        const float p1 = kValueRange * (2 * unit_float(hash1) - 1) + g1.t * (f - 1);
        return Line{p0 + v * (p1 - p0), g0.s + v * (g1.s - g0.s),
                    g0.t + v * (g1.t - g0.t) + dv * (p1 - p0), dv * (g1.s - g0.s)};
    };

    // One cell more than the lattice has: the first is entered at *phase, so the last is too.
    const size_t count = static_cast<size_t>(cells_s_) + 1;
    value.resize(count);
    if (dt)
        dt->resize(count);
    int c = static_cast<int>(start >> kFractionBits);
    int twin = c % twins;
    Line left = column(c, twin);
    for (size_t i = 0; i < count; ++i) {
        c = c + 1 < cells_s_ ? c + 1 : 0;
        twin = twin + 1 < twins ? twin + 1 : 0; // 0 where c is: twins divides cells_s
        const Line right = column(c, twin);
        value[i] = {left.a, left.b, right.a - right.b - left.a, right.b - left.b};
        if (dt)
            (*dt)[i] = {left.dt_a, left.dt_b, right.dt_a - right.dt_b - left.dt_a,
                        right.dt_b - left.dt_b};
        left = right;
    }
}

template <class Block, class Texel>
void LatticeNoise::walk(std::uint64_t phase, Block block, Texel texel) const
{
    const std::uint64_t span = (kBlock - 1) * step_s_;
    for (int x = 0; x < width_;) {
        const size_t cell = phase >> kFractionBits;
        if (x + kBlock <= width_ && (phase + span) >> kFractionBits == cell) {
            block(x, cell, fraction(phase));
            x += kBlock;
            phase += kBlock * step_s_;
        } else {
            texel(x, cell, fraction(phase));
            ++x;
            phase += step_s_;
        }
    }
}

void LatticeNoise::row(int y, float* noise) const
{
    std::vector<Cell> value;
    std::uint64_t phase;
    cells(y, &phase, value, nullptr);
    auto texel = [&](int x, size_t cell, float f) { noise[x] = value[cell].at(f, fade(f)); };
    auto block = [&](int x, size_t cell, float f0) {
        const Cell c = value[cell];
        const float step = step_;
        float* out = noise + x;
        for (int k = 0; k < kBlock; ++k) {
            const float f = f0 + step * static_cast<float>(k);
            out[k] = c.at(f, fade(f));
        }
    };
    walk(phase, block, texel);
}

void LatticeNoise::row(int y, float* noise, float* ds, float* dt) const
{
    std::vector<Cell> value, along_t;
    std::uint64_t phase;
    cells(y, &phase, value, &along_t);
    // A column leans: at fixed s, going down a cell moves by `lean` across the columns.
    const float lean = static_cast<float>(lean_) / static_cast<float>(cells_t_);
    auto texel = [&](int x, size_t cell, float f) {
        const Cell &c = value[cell], &d = along_t[cell];
        noise[x] = c.at(f, fade(f));
        ds[x] = c.along_s(f, fade(f), fade_slope(f));
        dt[x] = d.at(f, fade(f)) + lean * ds[x];
    };
    auto block = [&](int x, size_t cell, float f0) {
        const Cell c = value[cell], d = along_t[cell];
        const float step = step_;
        float out[3][kBlock]; // local: the compiler knows that nothing overlaps
        for (int k = 0; k < kBlock; ++k) {
            const float f = f0 + step * static_cast<float>(k), u = fade(f);
            out[0][k] = c.at(f, u);
            out[1][k] = c.along_s(f, u, fade_slope(f));
            out[2][k] = d.at(f, u) + lean * out[1][k];
        }
        std::copy_n(out[0], kBlock, noise + x);
        std::copy_n(out[1], kBlock, ds + x);
        std::copy_n(out[2], kBlock, dt + x);
    };
    walk(phase, block, texel);
}

std::vector<LatticeNoise> make_octaves(double base_cells, int max_octaves, int width, int height,
                                       std::uint32_t seed)
{
    const double side = std::max(width, height);
    std::vector<LatticeNoise> octaves;
    double cells = base_cells;
    int sign = 1;
    do {
        auto count = [&](int texels) {
            return std::max(1, static_cast<int>(std::lround(cells * texels / side)));
        };
        // Lean by a third of a cell a cell; the lean has to divide the columns.
        const int cells_t = count(height), lean = static_cast<int>(std::lround(cells_t / 3.0));
        const int cells_s = count(width);
        const int groups = lean == 0 ? 0 : static_cast<int>(std::lround(double(cells_s) / lean));
        const auto k = static_cast<std::uint32_t>(octaves.size());
        if (groups > 0)
            octaves.emplace_back(groups * lean, cells_t, sign * lean, width, height, seed + k);
        else
            octaves.emplace_back(cells_s, cells_t, 0, width, height, seed + k);
        sign = -sign;
        cells *= 1.93; // not 2: lattice lines of different octaves must not coincide
    } while (2 * cells <= side && static_cast<int>(octaves.size()) < max_octaves);
    return octaves;
}

} // namespace scree
