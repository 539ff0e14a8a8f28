// Color by height rank, against its definition by quadrature and against closed forms.

#include "stats/ranks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "kernel/filter.h"

namespace scree::test {
namespace {

using Atoms = std::vector<RankAtom>;

RankProfile profile_of(const Atoms& atoms)
{
    return {atoms.data(), static_cast<int>(atoms.size())};
}

/// N atoms of equal weight, gray, by rising rank.
template <class Color>
Atoms evenly(int count, Color color)
{
    Atoms atoms;
    for (int i = 0; i < count; ++i) {
        const auto c = static_cast<float>(color(i));
        atoms.push_back({static_cast<double>(i), 1.0F / static_cast<float>(count), {c, c, c}});
    }
    return atoms;
}

std::vector<double> coefficients(const Atoms& atoms, int terms)
{
    std::vector<double> a(static_cast<size_t>(3 * terms));
    rank_coefficients(profile_of(atoms), terms, a.data());
    return a;
}

/// Of red: a_1 ... a_terms.
std::vector<double> red(const Atoms& atoms, int terms)
{
    const auto all = coefficients(atoms, terms);
    std::vector<double> a;
    for (size_t n = 0; n < static_cast<size_t>(terms); ++n)
        a.push_back(all[3 * n]);
    return a;
}

Atoms random_atoms(int count, int different_heights, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.05F, 1.0F);
    Atoms atoms;
    for (int i = 0; i < count; ++i)
        atoms.push_back({static_cast<double>(static_cast<int>(random()) % different_heights),
                         unit(random),
                         {unit(random), unit(random), unit(random)}});
    return atoms;
}

/// All of them as one profile, through merges of single atoms in pairs.
Atoms merged(const Atoms& atoms)
{
    ProfileMerger merger;
    Atoms all;
    for (const RankAtom& atom : atoms) {
        const ProfilePart parts[] = {{profile_of(all), 1}, {{&atom, 1}, 1}};
        const RankProfile both = merger.merge(parts, 2);
        all = Atoms(both.atoms, both.atoms + both.count);
    }
    return all;
}

/// Oracle: (2n+1) times the integral of c(u) P_n(2u-1), c(u) the color of the texels whose ranks
/// include u, ties sharing theirs; by quadrature, one interval a height.
std::vector<double> by_definition(Atoms atoms, int terms, size_t channel)
{
    std::sort(atoms.begin(), atoms.end(),
              [](const RankAtom& a, const RankAtom& b) { return a.height < b.height; });
    double total = 0;
    for (const auto& atom : atoms)
        total += static_cast<double>(atom.weight);
    std::vector<double> a(static_cast<size_t>(terms), 0.0);
    double below = 0;
    for (size_t i = 0; i < atoms.size();) {
        double weight = 0, color = 0;
        const double height = atoms[i].height;
        for (; i < atoms.size() && atoms[i].height == height; ++i) {
            weight += static_cast<double>(atoms[i].weight);
            color +=
                static_cast<double>(atoms[i].weight) * static_cast<double>(atoms[i].color[channel]);
        }
        for (int n = 1; n <= terms; ++n) {
            auto p = [n](double u) { return boost::math::legendre_p(n, 2 * u - 1); };
            a[static_cast<size_t>(n) - 1] += (2 * n + 1) * color / weight *
                                             boost::math::quadrature::gauss<double, 15>::integrate(
                                                 p, below / total, (below + weight) / total);
        }
        below += weight;
    }
    return a;
}

TEST(Ranks, CoefficientsAreTheirDefinition)
{
    for (const int heights : {1, 2, 3, 7, 50, 1 << 30}) // bricks have few heights, noise many
        for (const int count : {1, 2, 3, 4, 9, 64, 333}) {
            const Atoms given = random_atoms(count, heights, 7);
            const auto got = coefficients(merged(given), kMaxRankTerms);
            for (size_t c = 0; c < 3; ++c) {
                const auto expected = by_definition(given, kMaxRankTerms, c);
                for (size_t n = 0; n < expected.size(); ++n)
                    // Weights and mean colors of ties are floats: some hundred roundings of 2^-24.
                    EXPECT_NEAR(got[3 * n + c], expected[n], 2e-6)
                        << count << " texels, " << heights << " heights, a_" << n + 1;
            }
        }
}

TEST(Ranks, AStepAtRankRHasTheCoefficientsOfAStep)
{
    // c(u) = 1 for u > r: a_n = (P_(n-1)(x) - P_(n+1)(x)) / 2 at x = 2r - 1, exactly.
    const int count = 64;
    for (const int below : {1, 16, 32, 63}) {
        const auto a = red(evenly(count, [=](int i) { return i < below ? 0 : 1; }), kMaxRankTerms);
        const double x = 2.0 * below / count - 1;
        for (int n = 1; n <= kMaxRankTerms; ++n)
            EXPECT_NEAR(a[static_cast<size_t>(n) - 1],
                        (boost::math::legendre_p(n - 1, x) - boost::math::legendre_p(n + 1, x)) / 2,
                        1e-14)
                << below << " below, a_" << n;
    }
}

TEST(Ranks, ColorLinearInRankHasOneTermToTheStepOfTheTexels)
{
    // Texel i of N has the color of its mean rank: sum of the boundary terms in closed form.
    for (const int count : {4, 16, 64, 4096}) {
        const double n = count;
        const auto a = red(evenly(count, [=](int i) { return (i + 0.5) / n; }), 4);
        EXPECT_NEAR(a[0], 0.5 * (1 - 1 / (n * n)), 1e-7) << count; // color is a float
        EXPECT_NEAR(a[1], 0, 1e-7);
        EXPECT_NEAR(a[3], 0, 1e-7);
    }
}

TEST(Ranks, APolynomialInRankIsShownExactlyWhateverTheExponent)
{
    // Each texel has the mean of p(u) = sum p_k u^k over its ranks; both ways to the visible color
    // then agree with sum p_k (1 + L) / (1 + L + k) to the texels' size squared.
    const double p[] = {0.4, 0.5, -1.2, 0.9, -0.3};
    auto primitive = [&p](double u) {
        double sum = 0;
        for (int k = 4; k >= 0; --k)
            sum = (sum + p[k] / (k + 1)) * u;
        return sum;
    };
    const int count = 4096;
    const Atoms atoms = evenly(count, [&](int i) {
        return (primitive((i + 1.0) / count) - primitive(static_cast<double>(i) / count)) * count;
    });
    auto a = red(atoms, 4);
    a.resize(8, 0.0);
    for (const double L : {0.0, 0.3, 1.0, 5.0, 20.0}) {
        double truth = 0;
        for (int k = 0; k <= 4; ++k)
            truth += p[k] * (1 + L) / (1 + L + k);
        const double table = kernel::scree_color_by_rank<double>(primitive(1), a[0], a[1], a[2],
                                                                 a[3], a[4], a[5], a[6], a[7], L);
        EXPECT_NEAR(table, truth, 2e-7) << L;
        EXPECT_NEAR(visible_color(profile_of(atoms), L)[0], truth, 2e-7) << L;
    }
}

TEST(Ranks, VisibleColorOfTwoHeightsIsTheTwoPowers)
{
    // Mortar of mass m, bricks above it: what is seen of the mortar is m^(1+L).
    const Atoms wall = {{0.0, 0.3F, {0.1F, 0.2F, 0.3F}}, {1.0, 0.7F, {0.9F, 0.8F, 0.7F}}};
    for (const double L : {0.0, 0.5, 3.0, 1e3, 1e6}) {
        const double m = std::pow(0.3, 1 + L);
        const auto color = visible_color(profile_of(wall), L);
        EXPECT_NEAR(color[0], 0.1 * m + 0.9 * (1 - m), 1e-7) << L;
        EXPECT_NEAR(color[2], 0.3 * m + 0.7 * (1 - m), 1e-7) << L;
    }
}

TEST(Ranks, EqualColorsHaveNoCoefficientsWhateverHeightsAndWeights)
{
    Atoms atoms = random_atoms(500, 90, 3);
    for (RankAtom& atom : atoms)
        atom.color = {0.3F, 0.1F, 0.7F};
    for (const double a : coefficients(merged(atoms), kMaxRankTerms))
        EXPECT_EQ(a, 0);
}

/// Under the hypothesis that color and rank are independent, a_n^2 N / ((2n+1) var c) has mean 1,
/// and the mean over many footprints a standard deviation of about sqrt(2 / footprints).
TEST(Ranks, AShuffledColorHasNoCorrelationBeyondSamplingError)
{
    constexpr int kFootprints = 400, kTexels = 256, kTerms = 4;
    std::mt19937 random(11);
    std::vector<float> colors(kTexels);
    for (int i = 0; i < kTexels; ++i)
        colors[static_cast<size_t>(i)] = static_cast<float>(i * i) / (kTexels * kTexels);
    double mean = 0, square = 0;
    for (const float c : colors) {
        mean += static_cast<double>(c) / kTexels;
        square += static_cast<double>(c) * static_cast<double>(c) / kTexels;
    }
    double sums[kTerms] = {}, signed_sums[kTerms] = {};
    for (int k = 0; k < kFootprints; ++k) {
        std::shuffle(colors.begin(), colors.end(), random);
        const auto a =
            red(evenly(kTexels, [&](int i) { return colors[static_cast<size_t>(i)]; }), kTerms);
        for (int n = 0; n < kTerms; ++n) {
            const double scaled = a[static_cast<size_t>(n)] *
                                  std::sqrt(kTexels / ((2 * n + 3) * (square - mean * mean)));
            sums[n] += scaled * scaled / kFootprints;
            signed_sums[n] += scaled / std::sqrt(kFootprints);
        }
    }
    for (int n = 0; n < kTerms; ++n) {
        EXPECT_NEAR(sums[n], 1, 5 * std::sqrt(2.0 / kFootprints)) << "a_" << n + 1;
        EXPECT_LT(std::abs(signed_sums[n]), 5) << "a_" << n + 1;
    }
}

TEST(Ranks, TheOrderOfMergingDoesNotMatter)
{
    const Atoms given = random_atoms(729, 100, 5);
    ProfileMerger merger;
    std::vector<Atoms> level;
    for (const RankAtom& atom : given)
        level.push_back({atom});
    while (level.size() > 1) { // nine by nine, as where both sizes are odd
        std::vector<Atoms> next;
        for (size_t i = 0; i < level.size(); i += 9) {
            ProfilePart parts[9];
            for (size_t k = 0; k < 9; ++k)
                parts[k] = {profile_of(level[i + k]), 0.5F};
            const RankProfile all = merger.merge(parts, 9);
            next.emplace_back(all.atoms, all.atoms + all.count);
        }
        level = next;
    }
    const Atoms one_by_one = merged(given);
    ASSERT_EQ(level[0].size(), one_by_one.size());
    for (size_t i = 0; i < one_by_one.size(); ++i) {
        EXPECT_EQ(level[0][i].height, one_by_one[i].height);
        EXPECT_NEAR(level[0][i].weight / one_by_one[i].weight, 0.125F, 1e-6);
        EXPECT_NEAR(level[0][i].color[1], one_by_one[i].color[1], 1e-6);
    }
}

TEST(Ranks, TexelsWithoutDataDoNotCount)
{
    const Atoms atoms = merged(random_atoms(20, 50, 1));
    ProfileMerger merger;
    const ProfilePart parts[] = {{{}, 0.25F}, {profile_of(atoms), 0.25F}, {{}, 0.5F}};
    const RankProfile all = merger.merge(parts, 3);
    EXPECT_EQ(static_cast<size_t>(all.count), atoms.size());
    const auto a = coefficients(atoms, 4);
    std::vector<double> b(12);
    rank_coefficients(all, 4, b.data());
    for (size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(a[i], b[i], 1e-7);
    EXPECT_EQ(merger.merge(parts, 1).count, 0);
}

TEST(Ranks, ASummaryKeepsMassMeanAndHeavyAtomsAndMovesRanksByNoMoreThanASlot)
{
    constexpr int kMost = 64;
    Atoms given = random_atoms(5000, 1 << 30, 9);
    for (size_t i = 0; i < given.size(); i += 3)
        given[i].height = 1 << 29; // a third of the footprint is a floor
    const Atoms all = merged(given);
    Atoms summary;
    summarise(profile_of(all), kMost, summary);
    EXPECT_LE(summary.size(), static_cast<size_t>(kMost + 2)); // one heavy atom splits a slot
    auto mass_below = [](const Atoms& atoms, double height) {
        double below = 0, total = 0;
        for (const RankAtom& atom : atoms) {
            total += static_cast<double>(atom.weight);
            below += atom.height < height ? static_cast<double>(atom.weight) : 0;
        }
        return below / total;
    };
    auto mean_green = [](const Atoms& atoms) {
        double sum = 0, total = 0;
        for (const RankAtom& atom : atoms) {
            total += static_cast<double>(atom.weight);
            sum += static_cast<double>(atom.weight) * static_cast<double>(atom.color[1]);
        }
        return sum / total;
    };
    EXPECT_NEAR(mean_green(summary), mean_green(all), 1e-6);
    const auto floor_of = [](const Atoms& atoms) {
        return *std::find_if(atoms.begin(), atoms.end(),
                             [](const RankAtom& a) { return a.height == 1 << 29; });
    };
    EXPECT_NEAR(floor_of(summary).weight / floor_of(all).weight, 1, 1e-6);
    for (const RankAtom& atom : all)
        EXPECT_NEAR(mass_below(summary, atom.height), mass_below(all, atom.height),
                    1.0 / kMost + 1e-6);
    EXPECT_TRUE(std::is_sorted(summary.begin(), summary.end(),
                               [](const auto& a, const auto& b) { return a.height <= b.height; }));
}

TEST(Ranks, ASummaryLeavesAtomsAloneThatAreAsHeavyAsASlot)
{
    // 69 atoms, of which one has 1.2 of the 8 slots: it lies in two and shares neither.
    Atoms atoms;
    for (int i = 0; i < 69; ++i)
        atoms.push_back({static_cast<double>(i), i == 2 ? 12.0F : 1.0F, {0.5F, 0.5F, 0.5F}});
    Atoms summary;
    summarise(profile_of(atoms), 8, summary);
    EXPECT_LE(summary.size(), 16U);
    EXPECT_EQ(std::count_if(summary.begin(), summary.end(),
                            [](const RankAtom& a) { return a.height == 2 && a.weight == 12; }),
              1);
}

} // namespace
} // namespace scree::test
