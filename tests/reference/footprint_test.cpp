#include "reference/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/reliefs.h"

namespace scree::reference {
namespace {

/// What each texel of a level takes of all n level-0 texels, as full rows: the overlap of every
/// texel with every texel one level finer, times the finer level's rows.
std::vector<std::vector<long double>> composed(int n, int level)
{
    if (level == 0) {
        std::vector<std::vector<long double>> own(static_cast<size_t>(n));
        for (size_t i = 0; i < own.size(); ++i) {
            own[i].assign(own.size(), 0);
            own[i][i] = 1;
        }
        return own;
    }
    const auto finer = composed(n, level - 1);
    const auto from = static_cast<long double>(finer.size());
    const size_t coarse = std::max<size_t>(1, finer.size() / 2);
    const long double width = from / static_cast<long double>(coarse);
    std::vector<std::vector<long double>> rows(coarse);
    for (size_t j = 0; j < coarse; ++j) {
        rows[j].assign(static_cast<size_t>(n), 0);
        for (size_t i = 0; i < finer.size(); ++i) {
            const auto at = static_cast<long double>(i);
            const long double overlap = std::min(static_cast<long double>(j + 1) * width, at + 1) -
                                        std::max(static_cast<long double>(j) * width, at);
            if (overlap > 1e-15L) // else the rounding of an edge that both share
                for (size_t k = 0; k < rows[j].size(); ++k)
                    rows[j][k] += overlap / width * finer[i][k];
        }
    }
    return rows;
}

TEST(Footprint, SharesAreComposedAsTheLevelsAre)
{
    for (const int n : {1, 2, 3, 5, 7, 8, 11, 31, 32, 33, 100, 300})
        for (int level = 0; level < level_count(n, 1) + 1; ++level) {
            const auto truth = composed(n, level);
            ASSERT_EQ(level_size(n, level), static_cast<int>(truth.size())) << n << " " << level;
            for (size_t j = 0; j < truth.size(); ++j) {
                const AxisShares shares = axis_shares(n, level, static_cast<int>(j));
                ASSERT_GT(shares.share.front(), 0) << n << " " << level << " " << j;
                ASSERT_GT(shares.share.back(), 0) << n << " " << level << " " << j;
                std::vector<double> row(static_cast<size_t>(n), 0);
                for (size_t k = 0; k < shares.share.size(); ++k)
                    row.at(static_cast<size_t>(shares.first) + k) = shares.share[k];
                for (size_t k = 0; k < row.size(); ++k) // rounding of sums of a few terms
                    EXPECT_NEAR(row[k], static_cast<double>(truth[j][k]), 1e-15)
                        << n << " " << level << " " << j << " " << k;
            }
        }
}

TEST(Footprint, LevelsGoDownToOneTexel)
{
    EXPECT_EQ(level_count(1, 1), 1);
    EXPECT_EQ(level_count(640, 480), 10);
    EXPECT_EQ(level_count(1, 1024), 11);
    EXPECT_EQ(level_size(640, 9), 1);
    const Footprint last = footprint_of(640, 480, 9, 0, 0);
    EXPECT_EQ(last.s.share.size(), 640u);
    EXPECT_EQ(last.t.share.size(), 480u);
    const Footprint inner = footprint_of(640, 480, 3, 79, 2);
    EXPECT_EQ(inner.s.first, 632);
    EXPECT_EQ(inner.t.first, 16);
}

double position_at(const AxisShares& shares, double u) { return SharePositions(shares).at(u); }

TEST(Footprint, PositionsInvertTheShareThatLiesBefore)
{
    const AxisShares shares{3, {0.25, 0.5, 0.125, 0.125}};
    EXPECT_EQ(position_at(shares, 0), 3);
    EXPECT_EQ(position_at(shares, 0.125), 3.5);
    EXPECT_EQ(position_at(shares, 0.25), 4);
    EXPECT_EQ(position_at(shares, 0.5), 4.5);
    EXPECT_EQ(position_at(shares, 0.8125), 5.5);
    EXPECT_LT(position_at(shares, std::nextafter(1, 0)), 7);
    EXPECT_LT(position_at(shares, std::nextafter(0.25, 0)), 4); // colors change there

    const AxisShares tenths{0, std::vector<double>(10, 0.1)}; // adds up to less than 1
    EXPECT_LT(position_at(tenths, std::nextafter(1, 0)), 10);

    // Any footprint: the share before the position of u is u.
    const AxisShares level = axis_shares(1000, 7, 3);
    test::Uniform uniform(1);
    double total = 0;
    for (const double share : level.share)
        total += share;
    for (int k = 0; k < 1000; ++k) {
        const double u = uniform();
        const double place = position_at(level, u) - level.first;
        double before = 0;
        for (size_t i = 0; i < level.share.size(); ++i)
            before += level.share[i] * std::min(1.0, std::max(0.0, place - static_cast<double>(i)));
        EXPECT_NEAR(before / total, u, 1e-12);
    }
}

} // namespace
} // namespace scree::reference
