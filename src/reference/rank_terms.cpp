#include "reference/rank_terms.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scree::reference {

namespace {

struct Node {
    double place, weight; ///< in [-1, 1]; the weights sum to 1
};

/// Gauss and Legendre, 5 points.
std::array<Node, 5> gauss_nodes()
{
    const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3;
    const double outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
    const double heavy = (322 + 13 * std::sqrt(70.0)) / 1800;
    const double light = (322 - 13 * std::sqrt(70.0)) / 1800;
    return {{{-outer, light}, {-inner, heavy}, {0, 64.0 / 225}, {inner, heavy}, {outer, light}}};
}

/// Adds the mean of P_1 .. P_terms over [low, high], part of [-1, 1], times `amount` each.
void add_means(double low, double high, const Rgb& amount, int terms, RankTerms& sums)
{
    static const std::array<Node, 5> kNodes = gauss_nodes();
    std::array<double, kMaxRankTerms> mean{};
    for (const Node& node : kNodes) {
        const double x = (low + high) / 2 + node.place * (high - low) / 2;
        double last = 1, now = x;
        for (int n = 1; n <= terms; ++n) {
            mean[static_cast<size_t>(n - 1)] += node.weight * now;
            const double next = ((2 * n + 1) * x * now - n * last) / (n + 1);
            last = now;
            now = next;
        }
    }
    for (size_t n = 0; n < static_cast<size_t>(terms); ++n)
        for (size_t c = 0; c < 3; ++c)
            sums[n][c] += amount[c] * mean[n];
}

} // namespace

RankTerms rank_terms(std::vector<Ranked>& parts, const std::vector<Rgb>& colors, int terms)
{
    assert(terms >= 0 && terms <= kMaxRankTerms);
    RankTerms a{};
    if (terms == 0 || parts.empty())
        return a;
    std::sort(parts.begin(), parts.end(),
              [](const Ranked& l, const Ranked& r) { return l.height < r.height; });
    double total = 0;
    for (const Ranked& part : parts)
        total += part.weight;

    // P_n has mean 0, so colors count from any one of them: equal ones then give exactly 0.
    const Rgb& base = colors[parts.front().texel];
    double below = 0;
    for (size_t begin = 0; begin < parts.size();) {
        double weight = 0;
        Rgb amount{};
        size_t end = begin;
        for (; end < parts.size() && parts[end].height == parts[begin].height; ++end) {
            weight += parts[end].weight;
            for (size_t c = 0; c < 3; ++c)
                amount[c] += parts[end].weight / total * (colors[parts[end].texel][c] - base[c]);
        }
        add_means(2 * below / total - 1, 2 * (below + weight) / total - 1, amount, terms, a);
        below += weight;
        begin = end;
    }
    for (size_t n = 0; n < static_cast<size_t>(terms); ++n)
        for (double& term : a[n])
            term *= 2 * static_cast<double>(n + 1) + 1;
    return a;
}

} // namespace scree::reference
