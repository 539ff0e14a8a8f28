// Is brute force itself right? Exact values by hand, closed forms, and the definition by sampling.
#include "reference/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

#include "reference/footprint.h"
#include "support/truth.h"

namespace scree::reference {
namespace {

using test::brute_force;
using test::TrueLevel;
using test::Truth;

const double kPi = std::acos(-1.0);
const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

// Rounding of the double inputs, outputs and sums; values are near 1, maps small.
const double kRounding = 1e-13;

StatisticsInput map_of(int width, int height, const std::function<double(int, int)>& h)
{
    StatisticsInput in;
    in.relief.width = width;
    in.relief.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            in.relief.heights.push_back(h(x, y));
    return in;
}

StatisticsInput wrapped(StatisticsInput in, Beyond beyond_s, Beyond beyond_t,
                        Reconstruction reconstruction)
{
    in.relief.beyond_s = beyond_s;
    in.relief.beyond_t = beyond_t;
    in.reconstruction = reconstruction;
    return in;
}

const Texel& top(const Truth& result) { return result.levels.back().at(0, 0); }

/// E[q^2] from the second and fourth moments; brute force sums q^2 itself.
double kurtosis_from_moments(const Texel& m)
{
    const auto [ss, tt, st] = m.cov_slope;
    const auto [ssss, ssst, sstt, sttt, tttt] = m.fourth_slope;
    const double det = ss * tt - st * st;
    return (tt * tt * ssss + ss * ss * tttt + (4 * st * st + 2 * ss * tt) * sstt -
            4 * st * (tt * ssst + ss * sttt)) /
           (det * det);
}

// Heights, slopes and their differences are small dyadic numbers, so every check is exact.
TEST(Statistics, APlaneIsAPlaneAlsoAroundHoles)
{
    for (bool holes : {false, true})
        for (auto [width, height] : {std::pair{8, 8}, {9, 7}, {7, 16}})
            for (auto reconstruction : {Reconstruction::bilinear, Reconstruction::central}) {
                StatisticsInput in = wrapped(
                    map_of(width, height, [](int x, int y) { return 3 + 0.25 * x - 0.5 * y; }),
                    Beyond::extends, Beyond::extends, reconstruction);
                in.relief.texel_width = 0.5;
                in.relief.texel_height = 2;
                if (holes) // neighbours in a diagonal and one alone; inside, clear of the border
                    for (int i : {2 * width + 2, 3 * width + 3, 4 * width + 4})
                        in.relief.heights[static_cast<std::size_t>(i)] = i % 2 ? kNan : kInf;
                const Truth result = brute_force(in);
                EXPECT_EQ(result.valid_texels, in.relief.heights.size() - (holes ? 3 : 0));
                for (const TrueLevel& level : result.levels)
                    for (const Texel& m : level.texels) {
                        if (m.coverage == 0)
                            continue;
                        EXPECT_EQ(m.mean_slope[0], 0.5) << width << "x" << height;
                        EXPECT_EQ(m.mean_slope[1], -0.25) << width << "x" << height;
                        for (double moment : m.cov_slope)
                            EXPECT_EQ(moment, 0);
                        for (double moment : m.third_slope)
                            EXPECT_EQ(moment, 0);
                        for (double moment : m.fourth_slope)
                            EXPECT_EQ(moment, 0);
                        EXPECT_EQ(m.kurtosis, 0);
                        EXPECT_EQ(m.tau, 0);
                    }
                EXPECT_NEAR(top(result).mean_hn, 0, kRounding);
                EXPECT_NEAR(top(result).var_hn, 1, kRounding);
                const double share = static_cast<double>(result.valid_texels) /
                                     static_cast<double>(in.relief.heights.size());
                EXPECT_NEAR(top(result).coverage, share, kRounding);
            }
}

TEST(Statistics, ASineHasItsClosedForm)
{
    const int n = 24, k = 1;
    const double a = 0.7, dx = 0.25;
    for (int rows : {1, 5}) {
        StatisticsInput in =
            map_of(n, rows, [&](int x, int) { return a * std::sin(2 * kPi * k * x / n); });
        in.relief.texel_width = dx;
        for (double h : in.relief.heights)
            in.relief.colors.push_back({h, 2 - h, 0.5});
        const Truth result = brute_force(in);
        // The surface has one slope per cell, amplitude 2 a sin(pi k/n) / dx at the cells' middles.
        const double amplitude = 2 * a * std::sin(kPi * k / n) / dx;
        for (int x = 0; x < n; ++x) {
            const double before = amplitude * std::cos(2 * kPi * k * (x - 0.5) / n);
            const double after = amplitude * std::cos(2 * kPi * k * (x + 0.5) / n);
            const Texel& m = result.levels[0].at(x, rows / 2);
            EXPECT_NEAR(m.mean_slope[0], (before + after) / 2, kRounding);
            EXPECT_NEAR(m.cov_slope[0], std::pow((after - before) / 2, 2), kRounding);
            EXPECT_NEAR(m.fourth_slope[0], std::pow((after - before) / 2, 4), kRounding);
            EXPECT_EQ(m.var_color[0], 0);
        }
        const Texel& m = top(result);
        EXPECT_NEAR(result.h0, 0, kRounding);
        EXPECT_NEAR(result.h1, a / std::sqrt(2.0), kRounding);
        EXPECT_NEAR(m.mean_slope[0], 0, kRounding);
        EXPECT_NEAR(m.cov_slope[0], amplitude * amplitude / 2, kRounding);
        EXPECT_NEAR(m.cov_slope[1], 0, kRounding);
        EXPECT_NEAR(m.cov_slope[2], 0, kRounding);
        EXPECT_NEAR(m.third_slope[0], 0, kRounding);
        EXPECT_NEAR(m.fourth_slope[0], 3 * std::pow(amplitude, 4) / 8, kRounding);
        EXPECT_NEAR(m.kurtosis, 8 * 1.5 / 3, kRounding);
        EXPECT_EQ(m.tau, 0);
        EXPECT_NEAR(m.var_hn, 1, kRounding);
        EXPECT_NEAR(m.var_color[1], a * a / 2, kRounding);
        EXPECT_NEAR(m.cov_color_hn[0], result.h1, kRounding);
        EXPECT_NEAR(m.cov_color_hn[1], -result.h1, kRounding);
        EXPECT_NEAR(m.cov_color_hn[2], 0, kRounding);
        EXPECT_NEAR(m.cov_color_s[0], 0, kRounding);
    }
}

TEST(Statistics, TwoCrossedSinesAreIndependent)
{
    const int nx = 24, ny = 20;
    StatisticsInput in = map_of(nx, ny, [&](int x, int y) {
        return 0.7 * std::sin(2 * kPi * x / nx) + 0.1 * std::cos(2 * kPi * y / ny);
    });
    const double vs = std::pow(2 * 0.7 * std::sin(kPi / nx), 2) / 2;
    const double vt = std::pow(2 * 0.1 * std::sin(kPi / ny), 2) / 2;
    // Color follows the central slope, whose amplitude is that of h times sin of one step.
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            in.relief.colors.push_back({std::cos(2 * kPi * x / nx), std::sin(2 * kPi * y / ny), 0});
    const Texel m = top(brute_force(in));
    EXPECT_NEAR(m.cov_slope[0], vs, kRounding);
    EXPECT_NEAR(m.cov_slope[1], vt, kRounding);
    EXPECT_NEAR(m.cov_slope[2], 0, kRounding);
    EXPECT_NEAR(m.fourth_slope[2], vs * vt, kRounding);
    EXPECT_NEAR(m.kurtosis, 1.5 + 1.5 + 2, 1e-10);
    EXPECT_NEAR(m.cov_color_s[0], 0.7 * std::sin(2 * kPi / nx) / 2, kRounding);
    EXPECT_NEAR(m.cov_color_t[1], -0.1 * std::sin(2 * kPi / ny) / 2, kRounding);
    EXPECT_NEAR(m.cov_color_s[1], 0, kRounding);
    EXPECT_NEAR(m.cov_color_t[0], 0, kRounding);
}

TEST(Statistics, AVGrooveHasTwoSlopes)
{
    const double a = 0.5;
    for (bool along_t : {false, true}) {
        const std::size_t axis = along_t ? 1 : 0;
        const StatisticsInput in =
            map_of(16, 16, [&](int x, int y) { return a * std::abs((along_t ? y : x) - 8); });
        const Truth result = brute_force(in);
        const Texel& valley = along_t ? result.levels[0].at(3, 8) : result.levels[0].at(8, 3);
        for (const Texel& m : {valley, top(result)}) {
            EXPECT_NEAR(m.mean_slope[axis], 0, kRounding);
            EXPECT_NEAR(m.cov_slope[axis], a * a, kRounding);
            EXPECT_NEAR(m.cov_slope[1 - axis], 0, kRounding);
            EXPECT_NEAR(m.third_slope[3 * axis], 0, kRounding);
            EXPECT_NEAR(m.fourth_slope[4 * axis], a * a * a * a, kRounding);
            EXPECT_NEAR(m.kurtosis, 8.0 / 3, kRounding); // k1 = 1
            EXPECT_EQ(m.tau, 0);
        }
        const Texel& wall = along_t ? result.levels[0].at(3, 4) : result.levels[0].at(4, 3);
        EXPECT_EQ(wall.mean_slope[axis], -a);
        EXPECT_EQ(wall.cov_slope[axis], 0);
    }
}

TEST(Statistics, RareGroovesAreHeavyTailed)
{
    // Slopes -1, 1 over one cell each and 0 over the other 14: k1 = 1 / P(slope != 0).
    const Texel m = top(brute_force(map_of(16, 4, [](int x, int) { return x == 5 ? -1.0 : 0.0; })));
    EXPECT_NEAR(m.cov_slope[0], 2.0 / 16, kRounding);
    EXPECT_NEAR(m.kurtosis, 8.0 * 8 / 3, kRounding);
    EXPECT_EQ(m.tau, 1);
    // As a plateau of 3 (slopes nonzero over 2 cells of 10): k1 = 5, tau = 2/3.
    const Texel plateau =
        top(brute_force(map_of(1, 10, [](int, int y) { return y >= 3 && y <= 5 ? 1.0 : 0.0; })));
    EXPECT_NEAR(plateau.tau, (5.0 - 3) / 3, kRounding);
}

TEST(Statistics, OneBySevenTakesExactShares)
{
    StatisticsInput in = map_of(1, 7, [](int, int y) { return y * y; });
    in.relief.beyond_t = Beyond::extends;
    for (double h : in.relief.heights)
        in.relief.colors.push_back({h, 0, 0});
    const Truth result = brute_force(in);
    ASSERT_EQ(result.levels.size(), 3u);
    EXPECT_EQ(result.levels[1].width, 1);
    ASSERT_EQ(result.levels[1].height, 3);
    EXPECT_EQ(result.levels[2].height, 1);
    // Thirds of 7 texels: 1 1 1/3 | 2/3 1 2/3 | 1/3 1 1.
    const double thirds[3] = {(0 + 1 + 4 / 3.0) * 3 / 7, (8 / 3.0 + 9 + 32 / 3.0) * 3 / 7,
                              (16 / 3.0 + 25 + 36) * 3 / 7};
    for (int y = 0; y < 3; ++y)
        EXPECT_NEAR(result.levels[1].at(0, y).mean_color[0], thirds[y], 1e-13);
    EXPECT_NEAR(top(result).mean_color[0], 91 / 7.0, 1e-13);
    // Clamp: the first and last cell continue, so the total rise is 1/2 + 36 + 11/2 over 7.
    EXPECT_NEAR(top(result).mean_slope[1], 42 / 7.0, 1e-13);
    EXPECT_EQ(top(result).mean_slope[0], 0); // the single column has no slope across
}

TEST(Statistics, SharesAreComposedNotCutAnew)
{
    // 11 -> 5 -> 2: half of texel 2 of 5, which is [4.4, 6.6) of 11, goes to each side.
    const AxisShares left = axis_shares(11, 2, 0);
    ASSERT_EQ(left.first, 0);
    ASSERT_EQ(left.share.size(), 7u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(left.share[i], 1 / 5.5, kRounding);
    EXPECT_NEAR(left.share[4], (0.4 + 0.6 / 2) / 5.5, kRounding);
    EXPECT_NEAR(left.share[5], 0.5 / 5.5, kRounding);
    EXPECT_NEAR(left.share[6], 0.3 / 5.5, kRounding);

    for (int n : {1, 2, 3, 7, 8, 9, 63, 64, 65, 100})
        for (int level = 0, size = n;; ++level, size /= 2) {
            ASSERT_EQ(level_size(n, level), size);
            std::vector<double> taken(static_cast<std::size_t>(n), 0);
            for (int i = 0; i < size; ++i) {
                const AxisShares row = axis_shares(n, level, i);
                for (std::size_t k = 0; k < row.share.size(); ++k)
                    taken[static_cast<std::size_t>(row.first) + k] += row.share[k];
            }
            for (double sum : taken) // what the coarse texels take of each texel adds up evenly
                EXPECT_NEAR(sum, static_cast<double>(size) / n, kRounding) << n << " " << level;
            if (size == 1)
                break;
        }
}

// Row of heights 1 4 9 in s, its transpose in t; slopes of the three texels by hand.
TEST(Statistics, WrapsAndReconstructionsByHand)
{
    struct Case {
        Beyond wrap;
        Reconstruction reconstruction;
        double slope[3];
    };
    const Case cases[] = {
        {Beyond::repeats, Reconstruction::central, {-2.5, 4, -1.5}},
        {Beyond::mirrors, Reconstruction::central, {1.5, 4, 2.5}},
        {Beyond::ends, Reconstruction::central, {2, 4, -2}},
        {Beyond::extends, Reconstruction::central, {3, 4, 5}},
        {Beyond::repeats, Reconstruction::bilinear, {-2.5, 4, -1.5}},
        {Beyond::repeats, Reconstruction::sobel, {-2.5, 4, -1.5}},
        {Beyond::extends, Reconstruction::sobel, {1.5, 4, 2.5}},
    };
    const double h[3] = {1, 4, 9};
    for (const Case& c : cases) {
        // The axis across is mirrored: the row repeats, and the 1 2 1 of Sobel smooths nothing.
        const Truth row = brute_force(wrapped(map_of(3, 1, [&](int x, int) { return h[x]; }),
                                              c.wrap, Beyond::mirrors, c.reconstruction));
        const Truth column = brute_force(wrapped(map_of(1, 3, [&](int, int y) { return h[y]; }),
                                                 Beyond::mirrors, c.wrap, c.reconstruction));
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(row.levels[0].at(i, 0).mean_slope[0], c.slope[i], kRounding);
            EXPECT_NEAR(row.levels[0].at(i, 0).mean_slope[1], 0, kRounding);
            EXPECT_NEAR(column.levels[0].at(0, i).mean_slope[1], c.slope[i], kRounding);
        }
        const bool varies = c.reconstruction == Reconstruction::bilinear;
        EXPECT_EQ(row.levels[0].at(1, 0).cov_slope[0], varies ? 1 : 0); // slopes 3 and 5
    }

    // Sobel of an isolated peak: only the weights 1 2 1 are seen around it.
    StatisticsInput peak = map_of(5, 5, [](int x, int y) { return x == 2 && y == 2 ? 8.0 : 0.0; });
    peak.reconstruction = Reconstruction::sobel;
    peak.relief.texel_width = 2;
    const TrueLevel level = brute_force(peak).levels[0];
    EXPECT_EQ(level.at(1, 2).mean_slope[0], 1);    // 2 * 8 / (8 dx)
    EXPECT_EQ(level.at(3, 1).mean_slope[0], -0.5); // -1 * 8 / (8 dx)
    EXPECT_EQ(level.at(3, 1).mean_slope[1], 1);
    EXPECT_EQ(level.at(2, 3).mean_slope[1], -2);
    EXPECT_EQ(level.at(2, 2).mean_slope[0], 0);

    // Corners under a different wrap per axis: 1 2 / 4 8, seen from its 1.
    const double h4[4] = {1, 2, 4, 8};
    const StatisticsInput square = map_of(2, 2, [&](int x, int y) { return h4[2 * y + x]; });
    auto first = [&](Beyond beyond_s, Beyond beyond_t) {
        return brute_force(wrapped(square, beyond_s, beyond_t, Reconstruction::sobel))
            .levels[0]
            .at(0, 0)
            .mean_slope;
    };
    // 0 1 2 / 0 1 2 / 0 4 8, then 0 0 0 / 2 1 2 / 8 4 8, then 4 4 8 / 1 1 2 / 4 4 8.
    EXPECT_EQ(first(Beyond::ends, Beyond::mirrors), (std::array<double, 2>{14 / 8.0, 12 / 8.0}));
    EXPECT_EQ(first(Beyond::repeats, Beyond::ends), (std::array<double, 2>{0, 3}));
    EXPECT_EQ(first(Beyond::mirrors, Beyond::repeats), (std::array<double, 2>{10 / 8.0, 0}));
}

// Heights on a 3x3 with the corners and the edges distinguishable, seen through Sobel and bilinear.
TEST(Statistics, MissingNeighboursAreCompletedInOrder)
{
    // 9 . .      "." missing: west present only; north, south missing both -> centre;
    // 2 5 .      east -> 2*5 - 2 = 8; corners from the completed edges: north-east
    // . . 7      8 + 5 - 5 = 8, south-west 2 + 5 - 5 = 2.
    const double grid[9] = {9, kNan, kNan, 2, 5, kNan, kNan, kNan, 7};
    StatisticsInput in = map_of(3, 3, [&](int x, int y) { return grid[3 * y + x]; });
    in.reconstruction = Reconstruction::sobel;
    const Texel sobel = brute_force(in).levels[0].at(1, 1);
    EXPECT_NEAR(sobel.mean_slope[0], ((8 - 9) + 2 * (8 - 2) + (7 - 2)) / 8.0, kRounding);
    EXPECT_NEAR(sobel.mean_slope[1], ((2 - 9) + 2 * (5 - 5) + (7 - 8)) / 8.0, kRounding);

    // Alone: level with itself on all sides, where Sobel would not see a difference.
    StatisticsInput alone = map_of(3, 3, [](int x, int y) { return x == 1 && y == 1 ? 5 : kNan; });
    EXPECT_EQ(brute_force(alone).levels[0].at(1, 1).cov_slope, (std::array<double, 3>{}));

    // Clamp at a hole: h(-1) = 2 h(0) - h(1) has no h(1), so texel 0 sees neither side. A texel
    // without weight is a hole too, whatever height it has.
    for (double hole : {kNan, 100.0}) {
        StatisticsInput row = map_of(4, 1, [&](int x, int) { return x == 1 ? hole : 3.0 * x + 1; });
        row.relief.beyond_s = Beyond::extends;
        row.relief.weights = {1, hole > 0 ? 0.0F : 1, 1, 0.25F};
        const Truth result = brute_force(row);
        EXPECT_EQ(result.levels[0].at(0, 0).mean_slope[0], 0);
        EXPECT_EQ(result.levels[0].at(1, 0).coverage, 0);
        EXPECT_EQ(result.levels[0].at(1, 0).mean_slope[0], 0);
        EXPECT_EQ(result.levels[0].at(2, 0).mean_slope[0], 3);
        EXPECT_EQ(result.levels[1].at(0, 0).coverage, 0.5);
        EXPECT_EQ(result.levels[1].at(1, 0).coverage, 0.625);
        EXPECT_EQ(top(result).coverage, 2.25 / 4);
        EXPECT_NEAR(top(result).mean_slope[0], 3 * 1.25 / 2.25, kRounding);
        const double h0 = (1 + 7 + 10 * 0.25) / 2.25;
        EXPECT_NEAR(result.h0, h0, kRounding);
        EXPECT_NEAR(result.h1, std::sqrt((1 + 49 + 100 * 0.25) / 2.25 - h0 * h0), kRounding);
        EXPECT_NEAR(result.levels[1].at(0, 0).mean_hn, (1 - h0) / result.h1, kRounding);
    }
}

// Central moments E[ds^a dt^b] of the bilinear periodic surface over a texel of a level, by slopes
/// at the middles of points x points squares in each level-0 texel.
///
/// nx, ny  level-0 texels in the footprint; points must be even, so that no square straddles a cell
std::array<std::array<double, 5>, 5> pooled_moments(const StatisticsInput& in, int x, int y, int nx,
                                                    int ny, int points)
{
    auto h = [&](int i, int j) {
        return in.relief.heights[static_cast<std::size_t>((j + in.relief.height) %
                                                              in.relief.height * in.relief.width +
                                                          (i + in.relief.width) % in.relief.width)];
    };
    auto surface = [&](double px, double py) { // in texels
        const double i = std::floor(px - 0.5), j = std::floor(py - 0.5);
        const double u = px - 0.5 - i, v = py - 0.5 - j;
        const int x0 = static_cast<int>(i), y0 = static_cast<int>(j);
        return (1 - v) * ((1 - u) * h(x0, y0) + u * h(x0 + 1, y0)) +
               v * ((1 - u) * h(x0, y0 + 1) + u * h(x0 + 1, y0 + 1));
    };
    std::vector<std::array<double, 2>> slopes;
    double mean_s = 0, mean_t = 0;
    for (int j = 0; j < points * ny; ++j)
        for (int i = 0; i < points * nx; ++i) {
            const double px = x * nx + (i + 0.5) / points, py = y * ny + (j + 0.5) / points;
            const double e = 0.25 / points; // stays inside the cell, where this is the slope
            const double s =
                (surface(px + e, py) - surface(px - e, py)) / (2 * e * in.relief.texel_width);
            const double t =
                (surface(px, py + e) - surface(px, py - e)) / (2 * e * in.relief.texel_height);
            slopes.push_back({s, t});
            mean_s += s;
            mean_t += t;
        }
    const double count = static_cast<double>(slopes.size());
    mean_s /= count;
    mean_t /= count;
    std::array<std::array<double, 5>, 5> mu{};
    for (const auto& [s, t] : slopes)
        for (std::size_t a = 0; a <= 4; ++a)
            for (std::size_t b = 0; a + b <= 4; ++b)
                mu[a][b] += std::pow(s - mean_s, a) * std::pow(t - mean_t, b) / count;
    mu[1][0] = mean_s;
    mu[0][1] = mean_t;
    return mu;
}

// No quadrature and no cells that are independent, only many slopes in one heap. The slopes
// are linear in each quarter cell, so for moments of order <= 4 the midpoint rule errs by exactly
// c2/m^2 + c4/m^4, and three sizes m give the true value to rounding.
TEST(Statistics, RandomHeightsMatchPooledSamples)
{
    const int width = 6, height = 4; // 6 -> 3 -> 1 and 4 -> 2 -> 1: whole texels at each level
    std::mt19937 random(7);
    std::gamma_distribution<double> skewed(0.5);
    StatisticsInput in = map_of(width, height, [&](int, int) { return skewed(random); });
    in.relief.texel_width = 0.8;
    in.relief.texel_height = 1.25;
    const Truth result = brute_force(in);
    ASSERT_EQ(result.levels.size(), 3u);
    for (const TrueLevel& level : result.levels)
        for (int y = 0; y < level.height; ++y)
            for (int x = 0; x < level.width; ++x) {
                const int nx = width / level.width, ny = height / level.height;
                const auto m2 = pooled_moments(in, x, y, nx, ny, 2);
                const auto m4 = pooled_moments(in, x, y, nx, ny, 4);
                const auto m8 = pooled_moments(in, x, y, nx, ny, 8);
                auto want = [&](std::size_t a, std::size_t b) {
                    return (64 * m8[a][b] - 20 * m4[a][b] + m2[a][b]) / 45;
                };
                const double sigma = std::sqrt(std::max(want(2, 0), want(0, 2)));
                const Texel& got = level.at(x, y);
                auto expect = [&](double value, std::size_t a, std::size_t b) {
                    const double scale = std::pow(sigma, static_cast<double>(a + b));
                    EXPECT_NEAR(value, want(a, b), 1e-12 * scale)
                        << "a " << a << " b " << b << " level width " << level.width << " texel "
                        << x << " " << y;
                };
                expect(got.mean_slope[0], 1, 0);
                expect(got.mean_slope[1], 0, 1);
                expect(got.cov_slope[0], 2, 0);
                expect(got.cov_slope[1], 0, 2);
                expect(got.cov_slope[2], 1, 1);
                for (std::size_t b = 0; b <= 3; ++b)
                    expect(got.third_slope[b], 3 - b, b);
                for (std::size_t b = 0; b <= 4; ++b)
                    expect(got.fourth_slope[b], 4 - b, b);
                // Two ways to one number; the one from moments cancels, but not where C is round.
                EXPECT_NEAR(got.kurtosis / kurtosis_from_moments(got), 1, 1e-9);
                EXPECT_EQ(got.tau, std::clamp((got.kurtosis - 8) / 8, 0.0, 1.0));
            }
}

TEST(Statistics, GivenSlopesHaveNoVarianceInside)
{
    StatisticsInput in;
    in.relief.width = 2;
    in.relief.height = 2;
    in.slopes = {{1, 2}, {-1, 0}, {kNan, 5}, {3, 4}};
    in.relief.weights = {1, 1, 1, 2};
    const Truth result = brute_force(in);
    EXPECT_EQ(result.valid_texels, 3u);
    EXPECT_EQ(result.h1, 1);
    EXPECT_EQ(result.levels[0].at(0, 0).mean_slope[1], 2);
    EXPECT_EQ(result.levels[0].at(0, 0).cov_slope[0], 0);
    EXPECT_EQ(result.levels[0].at(1, 1).coverage, 2);
    EXPECT_EQ(top(result).coverage, 1);
    EXPECT_NEAR(top(result).mean_slope[0], 6 / 4.0, kRounding);
    EXPECT_NEAR(top(result).mean_slope[1], 10 / 4.0, kRounding);
    // s about 1.5: -0.5, -2.5, 1.5, 1.5; t about 2.5: -0.5, -2.5, 1.5, 1.5, so C is singular.
    EXPECT_NEAR(top(result).cov_slope[0], 11 / 4.0, kRounding);
    EXPECT_NEAR(top(result).cov_slope[2], 11 / 4.0, kRounding);
    EXPECT_NEAR(top(result).third_slope[1], (-0.125 - 15.625 + 2 * 3.375) / 4, kRounding);
    EXPECT_NEAR(top(result).kurtosis, 8 * (49.25 / 4) / (7.5625) / 3, kRounding);
}

// Mardia's kurtosis does not change under a linear map of the slopes, up to where C is thin.
TEST(Statistics, KurtosisIsAffineInvariant)
{
    std::mt19937 random(3);
    std::exponential_distribution<double> draw(1);
    StatisticsInput in;
    in.relief.width = 9;
    in.relief.height = 11;
    std::vector<std::array<double, 2>> round;
    for (int i = 0; i < in.relief.width * in.relief.height; ++i)
        round.push_back({draw(random), draw(random)});
    auto kurtosis = [&](double epsilon) {
        in.slopes.clear();
        for (const auto& [s, t] : round)
            in.slopes.push_back({s + epsilon * t, s});
        return top(brute_force(in)).kurtosis;
    };
    const double want = kurtosis(1);
    EXPECT_GT(want, 8.5); // not one of the values every wrong formula gives
    EXPECT_NEAR(kurtosis(-3), want, 1e-11);
    // det / trace^2 is near epsilon^2 / 4, here twice the limit; C, of sums exact to 1e-16 or so,
    // leaves 1e-16 / epsilon^2 in its inverse.
    EXPECT_NEAR(kurtosis(3e-3), want, 1e-9);

    // Thin, all along s = t; the top takes every texel evenly, also from odd sizes.
    double mean = 0, second = 0, fourth = 0;
    const double count = static_cast<double>(round.size());
    for (const auto& slope : round)
        mean += slope[0] / count;
    for (const auto& slope : round) {
        second += std::pow(slope[0] - mean, 2) / count;
        fourth += std::pow(slope[0] - mean, 4) / count;
    }
    const double along = 8 * fourth / (3 * second * second);
    EXPECT_GT(std::abs(along / want - 1), 0.1); // or the limit could not be seen
    EXPECT_NEAR(kurtosis(1e-8), along, 1e-6);
    EXPECT_NEAR(kurtosis(1e-3) / along, 1, 1e-2); // 4 times below the limit; s + epsilon t, not s
}

TEST(Statistics, ATexelIsTheSameHoweverItIsAskedFor)
{
    const StatisticsInput in =
        map_of(37, 21, [](int x, int y) { return std::sin(0.7 * x * x) + 0.1 * ((x * y) % 7); });
    const Statistics statistics(in, 3);
    const Truth truth = brute_force(in, 3);
    ASSERT_EQ(static_cast<std::size_t>(statistics.levels()), truth.levels.size());
    EXPECT_EQ(statistics.width(1), 18);
    EXPECT_EQ(statistics.height(4), 1);
    for (int l = 0; l < statistics.levels(); ++l) {
        const int y = statistics.height(l) - 1, x = statistics.width(l) / 2;
        const Texel& expected = truth.levels[static_cast<std::size_t>(l)].at(x, y);
        const Texel alone = statistics.at(l, x, y);
        const Texel in_row = statistics.rows(l, y, 1)[static_cast<std::size_t>(x)];
        for (const Texel& got : {alone, in_row}) {
            EXPECT_EQ(got.fourth_slope, expected.fourth_slope) << "level " << l;
            EXPECT_EQ(got.mean_hn, expected.mean_hn) << "level " << l;
            EXPECT_EQ(got.rank, expected.rank) << "level " << l;
        }
    }
}

TEST(Statistics, BadColorsAndWeightsAreNoData)
{
    StatisticsInput in = map_of(4, 1, [](int, int) { return 0.1; });
    in.relief.colors = {{0.1, 0.2, 0.3}, {1, kInf, 1}, {0.1, 0.2, 0.3}, {7, 7, 7}};
    in.relief.weights = {0.75F, 1, std::nanf(""), -1};
    const Truth result = brute_force(in);
    EXPECT_EQ(result.valid_texels, 1u);
    EXPECT_EQ(result.h0, 0.1);
    EXPECT_EQ(result.h1, 1); // equal heights: exactly no deviation
    EXPECT_NEAR(top(result).coverage, 0.75 / 4, kRounding);
    EXPECT_EQ(top(result).mean_color[1], 0.2);
    EXPECT_EQ(top(result).var_color[1], 0);
    EXPECT_EQ(result.levels[1].at(1, 0).coverage, 0);
    EXPECT_EQ(result.levels[1].at(1, 0).mean_color[0], 0);

    in.relief.heights.pop_back();
    EXPECT_THROW(brute_force(in), std::invalid_argument);
}

} // namespace
} // namespace scree::reference
