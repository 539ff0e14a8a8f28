// The rank coefficients of a few parts, by the antiderivatives of Boost's Legendre polynomials, and
// of colors that are polynomials of the rank.
#include "reference/rank_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <map>
#include <random>

#include "support/truth.h"

namespace scree::reference {
namespace {

// Of sums of a hundred doubles near 1.
constexpr double kRounding = 1e-13;

/// (2 n + 1) integral of c(u) P_n(2 u - 1) by the antiderivative, over groups of one height.
double by_antiderivative(const std::vector<Ranked>& parts, const std::vector<Rgb>& colors, int n,
                         std::size_t channel)
{
    std::map<double, std::pair<double, double>> groups; // height to weight and weight times color
    double total = 0;
    for (const Ranked& part : parts) {
        groups[part.height].first += part.weight;
        groups[part.height].second += part.weight * colors[part.texel][channel];
        total += part.weight;
    }
    auto antiderivative = [n](double u) {
        const double x = std::clamp(2 * u - 1, -1.0, 1.0);
        return (boost::math::legendre_p(n + 1, x) - boost::math::legendre_p(n - 1, x)) / 2;
    };
    double below = 0, sum = 0;
    for (const auto& [height, group] : groups) {
        const double above = below + group.first / total;
        sum += group.second / group.first * (antiderivative(above) - antiderivative(below));
        below = above;
    }
    return sum;
}

TEST(RankTerms, AreThoseOfTheDefinitionAlsoWithTies)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const int count : {1, 2, 3, 17, 100})
        for (const bool ties : {false, true}) {
            std::vector<Ranked> parts;
            std::vector<Rgb> colors;
            for (int i = 0; i < count; ++i) {
                const double h = uniform(random) - 0.5;
                parts.push_back({ties ? std::floor(8 * h) : h, 0.1 + uniform(random),
                                 static_cast<std::size_t>(i)});
                colors.push_back({uniform(random), h, 1 / (1.1 - h)});
            }
            const std::vector<Ranked> given = parts;
            const RankTerms got = rank_terms(parts, colors, kMaxRankTerms);
            for (int n = 1; n <= kMaxRankTerms; ++n)
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(got[static_cast<std::size_t>(n - 1)][c],
                                by_antiderivative(given, colors, n, c), kRounding)
                        << count << " parts, term " << n << " channel " << c;
        }
}

TEST(RankTerms, OneColorHasNone)
{
    std::vector<Ranked> parts = {{3, 0.25, 0}, {1, 0.5, 1}, {2, 0.3, 0}};
    const std::vector<Rgb> colors = {{0.1, 0.7, 5}, {0.1, 0.7, 5}};
    for (const Rgb& term : rank_terms(parts, colors, kMaxRankTerms))
        EXPECT_EQ(term, Rgb{});
}

TEST(RankTerms, OfATwoColoredFootprintAreThoseOfAStep)
{
    // Black below rank u, white above: a_n = (P_(n-1) - P_(n+1))(2 u - 1) / 2, by hand for n =
    // 1, 2.
    StatisticsInput in;
    in.relief.width = 4;
    in.relief.height = 1;
    in.relief.heights = {5, 2, 7, 2};
    in.relief.colors = {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    in.relief.weights = {0.5F, 1, 1, 0.5F};
    const test::Truth truth = test::brute_force(in, 2);
    const RankTerms& top = truth.levels.back().at(0, 0).rank; // u = 1/2, x = 0
    EXPECT_NEAR(top[0][0], 0.75, kRounding);                  // (1 + 1/2) / 2
    EXPECT_NEAR(top[1][0], 0, kRounding);
    EXPECT_EQ(top[2], Rgb{});                              // not asked for
    const RankTerms& left = truth.levels[1].at(0, 0).rank; // u = 2/3, x = 1/3
    EXPECT_NEAR(left[0][0], 2.0 / 3, kRounding);           // (1 - (3/9 - 1) / 2) / 2
    EXPECT_NEAR(left[1][0], 10.0 / 27, kRounding);         // (1/3 - (5/27 - 1) / 2) / 2
    EXPECT_EQ(truth.levels[0].at(2, 0).rank, RankTerms{});
}

} // namespace
} // namespace scree::reference
