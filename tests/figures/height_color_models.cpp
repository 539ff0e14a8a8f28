#include "figures/height_color_models.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/filter.h"

namespace scree::test {
namespace {

Model mean_only()
{
    return {"mean color", 0, [](const Footprint&, Values&) {},
            [](const Values& v, double) {
                return Color{v[0], v[1], v[2]};
            }};
}

/// E[c hn], E[hn], E[hn hn] with hn = (h - h0) / h1, and the kernel's formula.
Model linear(double h0, double h1)
{
    const auto bake = [=](const Footprint& footprint, Values& values) {
        std::array<double, 5> sums{};
        for (const Group& g : footprint) {
            const double hn = (g.height - h0) / h1;
            for (size_t c = 0; c < 3; ++c)
                sums[c] += hn * g.color[c];
            sums[3] += hn * g.mass;
            sums[4] += hn * hn * g.mass;
        }
        values.insert(values.end(), sums.begin(), sums.end());
    };
    const auto show = [](const Values& v, double L) {
        double mean = 0, variance = 0;
        kernel::scree_visible_height(L, mean, variance);
        Color shown;
        for (size_t c = 0; c < 3; ++c)
            shown[c] = kernel::scree_color_by_height(v[c], v[3 + c], v[6], v[7], mean);
        return shown;
    };
    return {"linear", 5, bake, show};
}

/// Shifted Legendre coefficients of color over height rank, `terms` of them, and the kernel's
/// formula.
///
///   a_n = 1/2 sum_b (c_b+1 - c_b) (P_n-1(x_b) - P_n+1(x_b)),   x_b = 2 U_b - 1
///
/// over the boundaries b between groups: the integral of a step function, by parts.
Model rank_table(size_t terms)
{
    const auto bake = [=](const Footprint& footprint, Values& values) {
        std::vector<double> a(3 * terms);
        double below = 0;
        for (size_t i = 0; i + 1 < footprint.size(); ++i) {
            const Group &g = footprint[i], &next = footprint[i + 1];
            below += g.mass;
            const double x = 2 * below - 1;
            double before = 1, here = x; // P_n-1, P_n
            for (size_t n = 1; n <= terms; ++n) {
                const auto k = static_cast<double>(n);
                const double after = ((2 * k + 1) * x * here - k * before) / (k + 1);
                for (size_t c = 0; c < 3; ++c)
                    a[3 * (n - 1) + c] +=
                        0.5 * (next.color[c] / next.mass - g.color[c] / g.mass) * (before - after);
                before = here;
                here = after;
            }
        }
        values.insert(values.end(), a.begin(), a.end());
    };
    const auto show = [=](const Values& v, double L) {
        Color shown;
        for (size_t c = 0; c < 3; ++c) {
            std::array<double, 8> a{};
            for (size_t n = 0; n < terms; ++n)
                a[n] = v[3 + 3 * n + c];
            shown[c] = kernel::scree_color_by_rank(v[c], a[0], a[1], a[2], a[3], a[4], a[5], a[6],
                                                   a[7], L);
        }
        return shown;
    };
    return {"rank, " + std::to_string(terms), 3 * terms, bake, show};
}

/// Mass and color sum in bins of height, one color a bin; the lowest bin follows from the others.
///
/// The lowest, because it is seen least: its rounding errors are weighted with mass^L.
///
/// edges  between bins, rising
Model bins(const std::string& name, const std::vector<double>& edges)
{
    const size_t stored = edges.size();
    const auto bake = [=](const Footprint& footprint, Values& values) {
        std::vector<std::array<double, 4>> sums(stored + 1); // red, green, blue, mass
        for (const Group& g : footprint) {
            auto& bin = sums[static_cast<size_t>(
                std::upper_bound(edges.begin(), edges.end(), g.height) - edges.begin())];
            for (size_t c = 0; c < 3; ++c)
                bin[c] += g.color[c];
            bin[3] += g.mass;
        }
        for (size_t k = 1; k <= stored; ++k)
            values.insert(values.end(), sums[k].begin(), sums[k].end());
    };
    const auto show = [=](const Values& v, double L) {
        Color shown{}, rest = {v[0], v[1], v[2]};
        double high = 1; // rank of the next bin's upper end
        const auto add = [&](const Color& sum, double mass) {
            const double weight = std::pow(high, 1 + L) - std::pow(high - mass, 1 + L);
            high -= mass;
            for (size_t c = 0; c < 3 && mass > 1e-9; ++c) // less is a rest of rounding
                shown[c] += sum[c] / mass * weight;
        };
        for (size_t k = stored; k > 0; --k) {
            const double* bin = &v[3 + 4 * (k - 1)];
            for (size_t c = 0; c < 3; ++c)
                rest[c] -= bin[c];
            add({bin[0], bin[1], bin[2]}, std::min(bin[3], high));
        }
        add(rest, high);
        for (double& c : shown)
            c = std::max(c, 0.0);
        return shown;
    };
    return {name + ", " + std::to_string(stored + 1), 4 * stored, bake, show};
}

/// sorted  heights
Model bins_of_equal_width(const std::vector<double>& sorted, size_t count)
{
    std::vector<double> edges;
    for (size_t k = 1; k < count; ++k)
        edges.push_back(sorted.front() + (sorted.back() - sorted.front()) * static_cast<double>(k) /
                                             static_cast<double>(count));
    return bins("bins of equal width", edges);
}

/// Edges at the quantiles of the map's heights. `sorted`: heights
Model bins_of_equal_mass(const std::vector<double>& sorted, size_t count)
{
    std::vector<double> edges;
    for (size_t k = 1; k < count; ++k)
        edges.push_back(sorted[k * sorted.size() / count]);
    return bins("bins of equal mass", edges);
}

} // namespace

Color visible_color(const Footprint& footprint, double L)
{
    Color sum{};
    double below = 0, power_below = 0;
    for (const Group& g : footprint) {
        below += g.mass;
        const double power = std::pow(below, 1 + L);
        for (size_t c = 0; c < 3; ++c)
            sum[c] += g.color[c] / g.mass * (power - power_below);
        power_below = power;
    }
    return sum;
}

std::vector<Model> height_color_models(std::vector<double> heights)
{
    std::sort(heights.begin(), heights.end());
    const auto count = static_cast<double>(heights.size());
    double mean = 0, variance = 0;
    for (const double h : heights)
        mean += h / count;
    for (const double h : heights)
        variance += (h - mean) * (h - mean) / count;

    std::vector<Model> models = {mean_only()};
    const auto add_bins = [&](size_t n) {
        models.push_back(bins_of_equal_width(heights, n));
        models.push_back(bins_of_equal_mass(heights, n));
    };
    models.push_back(rank_table(1));
    add_bins(2);
    models.push_back(linear(mean, std::sqrt(variance)));
    models.push_back(rank_table(2));
    add_bins(3);
    models.push_back(rank_table(4));
    add_bins(4);
    models.push_back(rank_table(8));
    add_bins(7);
    return models;
}

} // namespace scree::test
