#include "reference/statistics.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "reference/base_texels.h"
#include "reference/footprint.h"

namespace scree::reference {

namespace {

/// det C below this share of trace^2: C has no inverse worth using (docs/statistics.md).
constexpr double kThin = 1e-6;

/// Visits the level-0 texels with data under a footprint, from the top, each row from the left.
///
/// visit    visit(x, y, weight)
/// end_row  called after every row
template <class Visit, class EndRow>
void for_each_texel(const BaseTexels& base, const Footprint& footprint, const Visit& visit,
                    const EndRow& end_row)
{
    for (size_t j = 0; j < footprint.t.share.size(); ++j) {
        const int y = footprint.t.first + static_cast<int>(j);
        for (size_t i = 0; i < footprint.s.share.size(); ++i) {
            const int x = footprint.s.first + static_cast<int>(i);
            const double own = base.weights[base.index(x, y)];
            if (own > 0)
                visit(x, y, own * footprint.s.share[i] * footprint.t.share[j]);
        }
        end_row();
    }
}

/// Sums over a footprint, row by row.
///
/// add  add(x, y, weight, sums) adds a texel's part
template <size_t N, class Add>
std::array<double, N> sum_over(const BaseTexels& base, const Footprint& footprint, const Add& add)
{
    std::array<double, N> total{}, row{};
    for_each_texel(
        base, footprint, [&](int x, int y, double weight) { add(x, y, weight, row); },
        [&] {
            for (size_t k = 0; k < N; ++k)
                total[k] += row[k];
            row = {};
        });
    return total;
}

double total_of(const AxisShares& shares)
{
    double sum = 0;
    for (const double share : shares.share)
        sum += share;
    return sum;
}

/// E[d^k] over the points of a cell along one axis, k = 0 .. 4, d = point - mean.
std::array<double, 5> powers_about(const std::array<double, 3>& points, double mean)
{
    std::array<double, 3> power = {1, 1, 1};
    std::array<double, 5> average{};
    for (double& a : average) {
        a = (5 * power[0] + 8 * power[1] + 5 * power[2]) / 18; // of ones exactly 1
        for (size_t k = 0; k < 3; ++k)
            power[k] *= points[k] - mean;
    }
    return average;
}

/// Which moment E[ds^a dt^b] stands where among the second, third and fourth ones.
struct Order {
    size_t a, b;
};
constexpr std::array<Order, 12> kOrders = {{{2, 0},
                                            {0, 2},
                                            {1, 1},
                                            {3, 0},
                                            {2, 1},
                                            {1, 2},
                                            {0, 3},
                                            {4, 0},
                                            {3, 1},
                                            {2, 2},
                                            {1, 3},
                                            {0, 4}}};

/// Adds weight * E[ds^a dt^b] of a texel: in a cell s and t are independent.
template <size_t N>
void add_slopes(const SlopePoints& points, const std::array<double, 2>& mean, double weight,
                std::array<double, N>& sums)
{
    const double cell = weight / points.cells;
    for (size_t q = 0; q < static_cast<size_t>(points.cells); ++q) {
        const auto s = powers_about(points.s[q], mean[0]);
        const auto t = powers_about(points.t[q], mean[1]);
        for (size_t k = 0; k < kOrders.size(); ++k)
            sums[k] += cell * s[kOrders[k].a] * t[kOrders[k].b];
    }
}

/// Fills coverage and means; false where there is no data.
bool find_means(const BaseTexels& base, const Footprint& footprint, Texel& texel)
{
    constexpr size_t kVariables = 6; // s t hn R G B
    auto values_at = [&base](size_t i) -> std::array<double, kVariables> {
        const auto& [s, t] = base.mean_slopes[i];
        const auto& [r, g, b] = base.colors[i];
        return {s, t, base.hn[i], r, g, b};
    };
    // Taken about the first value: equal ones have exactly that mean.
    std::array<double, kVariables> first{};
    bool any = false;
    const auto sums = sum_over<kVariables + 1>(
        base, footprint, [&](int x, int y, double w, std::array<double, kVariables + 1>& row) {
            const auto values = values_at(base.index(x, y));
            if (!any)
                first = values;
            any = true;
            for (size_t k = 0; k < kVariables; ++k)
                row[k] += w * (values[k] - first[k]);
            row[kVariables] += w;
        });
    if (!any)
        return false;
    const double weight = sums[kVariables];
    auto mean = [&](size_t k) { return first[k] + sums[k] / weight; };
    texel.coverage = weight / (total_of(footprint.s) * total_of(footprint.t));
    texel.mean_slope = {mean(0), mean(1)};
    texel.mean_hn = mean(2);
    texel.mean_color = {mean(3), mean(4), mean(5)};
    return true;
}

/// Fills the central moments from the means.
void find_moments(const BaseTexels& base, const Footprint& footprint, double weight, Texel& texel)
{
    constexpr size_t kSlopes = kOrders.size(), kColors = 12; // c c, c hn, c s, c t of R, G, B
    constexpr size_t kAll = kSlopes + 1 + kColors;
    auto sums =
        sum_over<kAll>(base, footprint, [&](int x, int y, double w, std::array<double, kAll>& row) {
            const size_t i = base.index(x, y);
            add_slopes(base.slopes(x, y), texel.mean_slope, w, row);
            // Height and color are constant inside a texel, so only its mean slope counts.
            const double ds = base.mean_slopes[i][0] - texel.mean_slope[0];
            const double dt = base.mean_slopes[i][1] - texel.mean_slope[1];
            const double dh = base.hn[i] - texel.mean_hn;
            row[kSlopes] += w * dh * dh;
            for (size_t c = 0; c < 3; ++c) {
                const double dc = base.colors[i][c] - texel.mean_color[c];
                double* color = row.data() + kSlopes + 1 + 4 * c;
                color[0] += w * dc * dc;
                color[1] += w * dc * dh;
                color[2] += w * dc * ds;
                color[3] += w * dc * dt;
            }
        });
    for (double& sum : sums)
        sum /= weight;
    std::copy_n(sums.begin(), 3, texel.cov_slope.begin());
    std::copy_n(sums.begin() + 3, 4, texel.third_slope.begin());
    std::copy_n(sums.begin() + 7, 5, texel.fourth_slope.begin());
    texel.var_hn = sums[kSlopes];
    for (size_t c = 0; c < 3; ++c) {
        const double* color = sums.data() + kSlopes + 1 + 4 * c;
        texel.var_color[c] = color[0];
        texel.cov_color_hn[c] = color[1];
        texel.cov_color_s[c] = color[2];
        texel.cov_color_t[c] = color[3];
    }
}

/// Mardia's kurtosis by its definition, point by point: the closed form in the fourth moments
/// divides by det^2, and would lose the more digits the thinner C is.
double kurtosis_of(const BaseTexels& base, const Footprint& footprint, double weight,
                   const Texel& texel)
{
    const auto [ss, tt, st] = texel.cov_slope;
    const double trace = ss + tt, det = ss * tt - st * st;
    if (!(trace > 0))
        return 0;
    // q = d' F d with F = C^-1, or the projection on the principal axis if C is thin.
    const bool thin = det <= kThin * trace * trace;
    const double angle = std::atan2(2 * st, ss - tt) / 2;
    const double axis_s = std::cos(angle), axis_t = std::sin(angle);
    const double form_ss = thin ? axis_s * axis_s : tt / det;
    const double form_tt = thin ? axis_t * axis_t : ss / det;
    const double form_st = thin ? axis_s * axis_t : -st / det;

    constexpr std::array<double, 3> kGauss = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const auto sums = sum_over<2>( // of q and q^2
        base, footprint, [&](int x, int y, double w, std::array<double, 2>& row) {
            const SlopePoints points = base.slopes(x, y);
            for (size_t cell = 0; cell < static_cast<size_t>(points.cells); ++cell)
                for (size_t j = 0; j < 3; ++j)
                    for (size_t i = 0; i < 3; ++i) {
                        const double ds = points.s[cell][j] - texel.mean_slope[0];
                        const double dt = points.t[cell][i] - texel.mean_slope[1];
                        const double q = ds * (form_ss * ds + 2 * form_st * dt) + form_tt * dt * dt;
                        const double part = w / points.cells * kGauss[j] * kGauss[i];
                        row[0] += part * q;
                        row[1] += part * q * q;
                    }
        });
    const double second = sums[0] / weight, fourth = sums[1] / weight;
    return thin ? 8 * fourth / (3 * second * second) : fourth;
}

RankTerms ranks_of(const BaseTexels& base, const Footprint& footprint, int terms)
{
    std::vector<Ranked> parts;
    if (terms > 0)
        for_each_texel(
            base, footprint,
            [&](int x, int y, double weight) {
                const size_t i = base.index(x, y);
                parts.push_back({base.hn[i], weight, i});
            },
            [] {});
    return rank_terms(parts, base.colors, terms);
}

Texel texel_of(const BaseTexels& base, const Footprint& footprint, int terms)
{
    Texel texel;
    if (!find_means(base, footprint, texel))
        return texel;
    const double weight = texel.coverage * total_of(footprint.s) * total_of(footprint.t);
    find_moments(base, footprint, weight, texel);
    texel.kurtosis = kurtosis_of(base, footprint, weight, texel);
    texel.tau = std::clamp((texel.kurtosis - 8) / 8, 0.0, 1.0);
    texel.rank = ranks_of(base, footprint, terms);
    return texel;
}

} // namespace

struct Statistics::Base {
    BaseTexels texels;
    int rank_terms;
};

Statistics::Statistics(const StatisticsInput& input, int rank_terms)
    : base_(new Base{BaseTexels(input), rank_terms})
{}

Statistics::~Statistics() = default;
Statistics::Statistics(Statistics&&) noexcept = default;

double Statistics::h0() const { return base_->texels.h0; }
double Statistics::h1() const { return base_->texels.h1; }
size_t Statistics::valid_texels() const { return base_->texels.valid; }
int Statistics::levels() const { return level_count(base_->texels.width, base_->texels.height); }
int Statistics::width(int level) const { return level_size(base_->texels.width, level); }
int Statistics::height(int level) const { return level_size(base_->texels.height, level); }

Texel Statistics::at(int level, int x, int y) const
{
    const BaseTexels& base = base_->texels;
    return texel_of(base, footprint_of(base.width, base.height, level, x, y), base_->rank_terms);
}

std::vector<Texel> Statistics::rows(int level, int first, int count) const
{
    const auto columns = static_cast<size_t>(width(level));
    auto shares = [level](int n, int from, int how_many) {
        std::vector<AxisShares> all;
        all.reserve(static_cast<size_t>(how_many));
        for (int i = from; i < from + how_many; ++i)
            all.push_back(axis_shares(n, level, i));
        return all;
    };
    const auto along_s = shares(base_->texels.width, 0, width(level));
    const auto along_t = shares(base_->texels.height, first, count);

    std::vector<Texel> texels(columns * static_cast<size_t>(count));
    tbb::parallel_for(tbb::blocked_range<size_t>(0, texels.size()), [&](const auto& range) {
        for (size_t i = range.begin(); i != range.end(); ++i)
            texels[i] = texel_of(base_->texels, {along_s[i % columns], along_t[i / columns]},
                                 base_->rank_terms);
    });
    return texels;
}

} // namespace scree::reference
