#include "sample/lattice_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scree {
namespace {

struct Lattice {
    int cells_s, cells_t, lean;
};

const Lattice kLattices[] = {{3, 3, 1},  {3, 3, -1}, {12, 12, -4}, {12, 12, 4}, {6, 5, 0},
                             {9, 4, -3}, {1, 1, 0},  {1, 40, 1},   {60, 1, 0}};

constexpr int kSize = 400;

std::vector<float> row(const LatticeNoise& noise, int y, int width = kSize)
{
    std::vector<float> values(static_cast<size_t>(width));
    noise.row(y, values.data());
    return values;
}

// Beyond the map the lattice comes round: row y + height is row y. The phases carry 40 bits and
// their steps are rounded, so to 2^-20 cell, times slopes of a few units a cell.
TEST(LatticeNoise, ContinuesPeriodically)
{
    for (const Lattice& l : kLattices) {
        const LatticeNoise noise(l.cells_s, l.cells_t, l.lean, kSize, kSize, 5);
        for (int y : {0, 1, 57, 200, 398, 399}) {
            const auto here = row(noise, y), below = row(noise, y + kSize);
            for (size_t x = 0; x < here.size(); ++x)
                ASSERT_NEAR(here[x], below[x], 1e-5) << l.cells_s << "x" << l.cells_t << " lean "
                                                     << l.lean << " at " << x << "," << y;
        }
    }
}

TEST(LatticeNoise, IsSmoothOverBothBorders)
{
    for (const Lattice& l : kLattices) {
        const LatticeNoise noise(l.cells_s, l.cells_t, l.lean, kSize, kSize, 5);
        // Largest slope: two gradients of length 1 and a blend (slope 15/8) of values apart
        // by 3.
        const double step = 8.0 / kSize * std::max({l.cells_s, l.cells_t, 1});
        const auto first = row(noise, 0), last = row(noise, kSize - 1);
        for (size_t x = 0; x < first.size(); ++x)
            ASSERT_NEAR(first[x], last[x], step);
        for (int y = 0; y < kSize; y += 7) {
            const auto line = row(noise, y);
            ASSERT_NEAR(line.front(), line.back(), step);
        }
    }
}

// Oracle: central differences, step a texel, so error (step^2 / 6) times a third derivative of
// up to about 60 a cell^3, plus the rounding of float over the step.
TEST(LatticeNoise, DerivativesMatchDifferences)
{
    for (const Lattice& l : {Lattice{3, 3, 1}, Lattice{3, 3, -1}, Lattice{6, 5, 0}}) {
        const LatticeNoise noise(l.cells_s, l.cells_t, l.lean, kSize, kSize, 11);
        std::vector<float> value(kSize), ds(kSize), dt(kSize);
        double largest = 0;
        for (int y = 1; y < kSize; y += 13) {
            noise.row(y, value.data(), ds.data(), dt.data());
            const auto above = row(noise, y - 1), below = row(noise, y + 1);
            EXPECT_EQ(value, row(noise, y));
            for (size_t x = 1; x + 1 < value.size(); ++x) {
                const double s = 0.5 * kSize / l.cells_s * double(value[x + 1] - value[x - 1]);
                const double t = 0.5 * kSize / l.cells_t * double(below[x] - above[x]);
                ASSERT_NEAR(ds[x], s, 5e-3) << x << "," << y << " lean " << l.lean;
                ASSERT_NEAR(dt[x], t, 5e-3) << x << "," << y << " lean " << l.lean;
                largest = std::max({largest, std::abs(s), std::abs(t)});
            }
        }
        EXPECT_GT(largest, 0.5);
    }
}

TEST(LatticeNoise, HasTheStatedMeanAndSpread)
{
    double n = 0, sum = 0, square = 0, largest = 0;
    const LatticeNoise noise(99, 99, 33, kSize, kSize, 3);
    for (int y = 0; y < kSize; ++y)
        for (float v : row(noise, y)) {
            n += 1;
            sum += double(v);
            square += double(v) * double(v);
            largest = std::max(largest, std::abs(double(v)));
        }
    // About 99^2 independent cells: the mean is known to 0.3 / 99.
    EXPECT_NEAR(sum / n, 0, 0.012);
    EXPECT_NEAR(std::sqrt(square / n), 0.3, 0.03);
    EXPECT_TRUE(largest > 0.7 && largest < 1.2) << largest;
}

TEST(LatticeNoise, OctavesReachTheTexelAndFitEveryShape)
{
    const struct {
        int width, height;
        size_t octaves;
    } cases[] = {{1, 1, 1},          {12, 12, 2},   {512, 512, 7},
                 {32768, 32768, 14}, {1, 4096, 10}, {4096, 3, 10}};
    for (const auto& c : cases) {
        const auto octaves = make_octaves(3, 20, c.width, c.height, 1);
        EXPECT_EQ(octaves.size(), c.octaves) << c.width << "x" << c.height;
        for (const LatticeNoise& octave : octaves)
            for (float v : row(octave, c.height - 1, c.width))
                ASSERT_TRUE(std::isfinite(v) && std::abs(v) < 2);
    }
    EXPECT_EQ(make_octaves(3, 4, 512, 512, 1).size(), 4u);
}

} // namespace
} // namespace scree
