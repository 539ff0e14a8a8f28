#include "oracle/brute_force.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scree::oracle {
namespace {

using Real = long double;

// ---- Level 0: which texels count ---------------------------------------------------------------

std::size_t index_of(const Input& in, int x, int y)
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(in.width) +
           static_cast<std::size_t>(x);
}

/// Own weight of a texel, 0 for no data.
double own_weight(const Input& in, std::size_t i)
{
    if (!in.heights.empty() && !std::isfinite(in.heights[i]))
        return 0;
    if (!in.colors.empty())
        for (double channel : in.colors[i])
            if (!std::isfinite(channel))
                return 0;
    if (!in.slopes.empty())
        for (double slope : in.slopes[i])
            if (!std::isfinite(slope))
                return 0;
    if (in.weights.empty())
        return 1;
    return in.weights[i] > 0 ? in.weights[i] : 0; // a NaN is not > 0
}

void check(const Input& in)
{
    if (in.width <= 0 || in.height <= 0)
        throw std::invalid_argument("oracle: width and height must be positive");
    if (!(in.dx > 0 && in.dy > 0))
        throw std::invalid_argument("oracle: dx and dy must be positive");
    const std::size_t n = static_cast<std::size_t>(in.width) * static_cast<std::size_t>(in.height);
    auto wrong = [n](std::size_t size, bool optional) {
        return size != n && !(optional && size == 0);
    };
    if (wrong(in.heights.size(), !in.slopes.empty()) || wrong(in.colors.size(), true) ||
        wrong(in.weights.size(), true) || wrong(in.slopes.size(), true))
        throw std::invalid_argument("oracle: a grid is not height x width");
    for (double weight : in.weights)
        if (std::isinf(weight) && weight > 0)
            throw std::invalid_argument("oracle: a weight is infinite");
}

// ---- Level 0: heights around a texel -----------------------------------------------------------

/// A height that may be missing.
struct Sample {
    bool present = false;
    Real h = 0;
};

/// One axis continued beyond its edge by one texel: i in [-1, n], get(i) defined on [0, n).
template <class Get>
Sample extended(Wrap wrap, bool repeat_border, int n, int i, const Get& get)
{
    if (i >= 0 && i < n)
        return get(i);
    const int border = i < 0 ? 0 : n - 1;
    switch (wrap) {
    case Wrap::kPeriodic:
        return get(i < 0 ? n - 1 : 0);
    case Wrap::kMirror:
        return get(border);
    case Wrap::kBlack:
        return {true, 0};
    case Wrap::kClamp:
        break;
    }
    if (repeat_border || n == 1)
        return get(border);
    const Sample last = get(border);
    const Sample before = get(i < 0 ? 1 : n - 2);
    return {last.present && before.present, 2 * last.h - before.h};
}

/// h[1 + j][1 + i]: height at offset (i, j) from the centre, i along s, j along t.
using Neighbours = std::array<std::array<Real, 3>, 3>;

/// The 3x3 heights around a valid texel: wrapped, and completed where they are missing such that a
/// plane stays a plane wherever one neighbour of an axis is left.
Neighbours neighbours(const Input& in, const std::vector<double>& own, int x, int y)
{
    const bool repeat = in.reconstruction == Reconstruction::kSobel;
    auto in_row = [&](int column, int row) {
        return extended(in.wrap_s, repeat, in.width, column, [&](int c) {
            const std::size_t i = index_of(in, c, row);
            return own[i] > 0 ? Sample{true, in.heights[i]} : Sample{};
        });
    };
    // Columns first, then rows from the rows so extended.
    auto anywhere = [&](int column, int row) {
        return extended(in.wrap_t, repeat, in.height, row,
                        [&](int r) { return in_row(column, r); });
    };

    std::array<std::array<Sample, 3>, 3> raw;
    Neighbours h{};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
            raw[j][i] = anywhere(x + static_cast<int>(i) - 1, y + static_cast<int>(j) - 1);
            h[j][i] = raw[j][i].h;
        }

    // Edges look at what was there, not at what was completed: two missing ones are both level
    // with the centre.
    const Real centre = h[1][1];
    auto complete = [centre](const Sample& mine, const Sample& opposite) {
        if (mine.present)
            return mine.h;
        return opposite.present ? 2 * centre - opposite.h : centre;
    };
    h[1][0] = complete(raw[1][0], raw[1][2]);
    h[1][2] = complete(raw[1][2], raw[1][0]);
    h[0][1] = complete(raw[0][1], raw[2][1]);
    h[2][1] = complete(raw[2][1], raw[0][1]);
    for (std::size_t j : {0u, 2u})
        for (std::size_t i : {0u, 2u})
            if (!raw[j][i].present)
                h[j][i] = h[1][i] + h[j][1] - centre;
    return h;
}

// ---- Level 0: slopes inside a texel ------------------------------------------------------------

/// The slopes inside one texel, as quadrature points: in quarter cell q the points are all pairs of
/// an s slope and a t slope, since ds h depends on the position along t alone and dt h on that
/// along s. A constant slope has one cell and one node.
struct SlopePoints {
    std::size_t cells = 0;
    std::size_t nodes = 0;
    std::array<std::array<Real, 3>, 4> s{}; ///< [cell][node along t]
    std::array<std::array<Real, 3>, 4> t{}; ///< [cell][node along s]
};

// Gauss-Legendre over half a texel, 3 points: exact to degree 5; fourth moments need degree 4.
const std::array<Real, 3> kGaussWeight = {Real(5) / 36, Real(8) / 36, Real(5) / 36};

Real gauss_node(std::size_t k)
{
    return Real(0.5) + (static_cast<Real>(k) - 1) * std::sqrt(Real(15)) / 10;
}

/// visit(weight, s, t) for every quadrature point; the weights sum to 1.
template <class Visit>
void for_each_point(const SlopePoints& p, const Visit& visit)
{
    if (p.nodes == 1)
        return visit(Real(1), p.s[0][0], p.t[0][0]);
    for (std::size_t q = 0; q < p.cells; ++q)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i)
                visit(kGaussWeight[i] * kGaussWeight[j], p.s[q][j], p.t[q][i]);
}

SlopePoints constant_slope(Real s, Real t)
{
    SlopePoints p;
    p.cells = p.nodes = 1;
    p.s[0][0] = s;
    p.t[0][0] = t;
    return p;
}

SlopePoints bilinear_slopes(const Neighbours& h, Real dx, Real dy)
{
    SlopePoints p;
    p.cells = 4;
    p.nodes = 3;
    for (std::size_t q = 0; q < 4; ++q) {
        const std::size_t i = q % 2, j = q / 2; // corner of the bilinear cell in the 3x3
        const Real h00 = h[j][i], h10 = h[j][i + 1], h01 = h[j + 1][i], h11 = h[j + 1][i + 1];
        for (std::size_t k = 0; k < 3; ++k) {
            // The texel holds the far half of a cell before its centre, the near half of one after.
            const Real u = (gauss_node(k) + (i == 0 ? 1 : 0)) / 2;
            const Real v = (gauss_node(k) + (j == 0 ? 1 : 0)) / 2;
            // Differences, not (1 - v) a + v b: equal slopes stay equal to the last bit.
            p.s[q][k] = ((h10 - h00) + v * ((h11 - h01) - (h10 - h00))) / dx;
            p.t[q][k] = ((h01 - h00) + u * ((h11 - h10) - (h01 - h00))) / dy;
        }
    }
    return p;
}

SlopePoints slopes_of(const Input& in, const std::vector<double>& own, int x, int y)
{
    if (!in.slopes.empty()) {
        const std::array<double, 2>& slope = in.slopes[index_of(in, x, y)];
        return constant_slope(slope[0], slope[1]);
    }
    const Real dx = in.dx, dy = in.dy;
    const Neighbours h = neighbours(in, own, x, y);
    if (in.reconstruction == Reconstruction::kBilinear)
        return bilinear_slopes(h, dx, dy);
    if (in.reconstruction == Reconstruction::kCentral)
        return constant_slope((h[1][2] - h[1][0]) / (2 * dx), (h[2][1] - h[0][1]) / (2 * dy));
    Real s = 0, t = 0;
    const std::array<Real, 3> smooth = {1, 2, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        s += smooth[k] * (h[k][2] - h[k][0]);
        t += smooth[k] * (h[2][k] - h[0][k]);
    }
    return constant_slope(s / (8 * dx), t / (8 * dy));
}

// ---- Moments -----------------------------------------------------------------------------------

/// mu[a][b] = E[ds^a dt^b] about the mean, a + b <= 4.
struct SlopeMoments {
    Real mean_s = 0, mean_t = 0;
    std::array<std::array<Real, 5>, 5> mu{};
};

/// Mean of weighted values, taken about the first: equal values have exactly that mean.
class Mean {
public:
    void add(Real weight, Real value)
    {
        if (weight_ == 0)
            first_ = value;
        weight_ += weight;
        sum_ += weight * (value - first_);
    }
    Real value() const { return weight_ > 0 ? first_ + sum_ / weight_ : 0; }

private:
    Real weight_ = 0, first_ = 0, sum_ = 0;
};

using Powers = std::array<Real, 5>;

Powers powers(Real x) { return {1, x, x * x, x * x * x, x * x * x * x}; }

SlopeMoments moments_inside(const SlopePoints& points)
{
    Mean mean_s, mean_t;
    for_each_point(points, [&](Real w, Real s, Real t) {
        mean_s.add(w, s);
        mean_t.add(w, t);
    });
    SlopeMoments m;
    m.mean_s = mean_s.value();
    m.mean_t = mean_t.value();
    for_each_point(points, [&](Real w, Real s, Real t) {
        const Powers ps = powers(s - m.mean_s), pt = powers(t - m.mean_t);
        for (std::size_t a = 0; a <= 4; ++a)
            for (std::size_t b = 0; a + b <= 4; ++b)
                m.mu[a][b] += w * ps[a] * pt[b];
    });
    // True by definition; left to rounding they would leak into the higher moments of a mixture.
    m.mu[0][0] = 1;
    m.mu[1][0] = m.mu[0][1] = 0;
    return m;
}

/// Adds weight * E[(ds + x)^a (dt + y)^b] to sum[a][b] for 2 <= a + b <= 4: the part of one
/// component in the central moments of a mixture, by the binomial theorem.
///
/// component  its own central moments mu = E[x^i y^j]
/// ds, dt     mean of the component minus mean of the mixture
void add_component(Real weight, const SlopeMoments& component, Real ds, Real dt,
                   std::array<std::array<Real, 5>, 5>& sum)
{
    static const Real kBinomial[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    const Powers ps = powers(ds), pt = powers(dt);
    // The innermost loop is the cost of the whole oracle, so its factors are made outside.
    Real along_s[5][5], along_t[5][5];
    for (std::size_t a = 0; a <= 4; ++a)
        for (std::size_t i = 0; i <= a; ++i) {
            along_s[a][i] = weight * kBinomial[a][i] * ps[a - i];
            along_t[a][i] = kBinomial[a][i] * pt[a - i];
        }
    for (std::size_t a = 0; a <= 4; ++a)
        for (std::size_t b = a < 2 ? 2 - a : 0; a + b <= 4; ++b) {
            Real part = 0;
            for (std::size_t i = 0; i <= a; ++i) {
                Real column = 0;
                for (std::size_t j = 0; j <= b; ++j)
                    column += along_t[b][j] * component.mu[i][j];
                part += along_s[a][i] * column;
            }
            sum[a][b] += part;
        }
}

// ---- Footprints --------------------------------------------------------------------------------

/// All of level 0 that the levels are summed from, row-major.
struct Base {
    int width = 0;
    std::vector<double> own;         ///< weight, 0 for no data
    std::vector<SlopePoints> points; ///< of valid texels
    std::vector<SlopeMoments> inner; ///< of valid texels
    std::vector<Real> hn;
    std::vector<std::array<double, 3>> colors;
};

/// visit(i, weight) for each valid level-0 texel i under the product of two shares.
template <class Visit>
void for_each_texel(const Base& base, const Shares& along_s, const Shares& along_t,
                    const Visit& visit)
{
    for (std::size_t j = 0; j < along_t.share.size(); ++j) {
        const std::size_t row = static_cast<std::size_t>(along_t.first) + j;
        const std::size_t start =
            row * static_cast<std::size_t>(base.width) + static_cast<std::size_t>(along_s.first);
        for (std::size_t i = 0; i < along_s.share.size(); ++i) {
            const Real share = along_s.share[i] * along_t.share[j];
            if (base.own[start + i] > 0 && share > 0)
                visit(start + i, share * base.own[start + i]);
        }
    }
}

Real total(const Shares& shares)
{
    Real sum = 0;
    for (Real share : shares.share)
        sum += share;
    return sum;
}

/// Mardia's kurtosis of a footprint by its definition, point by point. The closed form in the
/// fourth moments divides by det^2, and would lose all digits long before det is 1e-12 trace^2.
double kurtosis_of(const Base& base, const Shares& along_s, const Shares& along_t, Real weight,
                   const SlopeMoments& m)
{
    const Real ss = m.mu[2][0], tt = m.mu[0][2], st = m.mu[1][1];
    const Real trace = ss + tt, det = ss * tt - st * st;
    if (!(trace > 0))
        return 0;
    const bool singular = det <= Real(1e-12) * trace * trace;

    // q = d' F d with F = C^-1, or the projection on the principal axis if C has no inverse.
    const Real angle = std::atan2(2 * st, ss - tt) / 2;
    const Real axis_s = std::cos(angle), axis_t = std::sin(angle);
    const Real form_ss = singular ? axis_s * axis_s : tt / det;
    const Real form_tt = singular ? axis_t * axis_t : ss / det;
    const Real form_st = singular ? axis_s * axis_t : -st / det;

    Real second = 0, fourth = 0; // E[q], E[q^2]
    for_each_texel(base, along_s, along_t, [&](std::size_t i, Real texel_weight) {
        Real texel_second = 0, texel_fourth = 0;
        for_each_point(base.points[i], [&](Real w, Real s, Real t) {
            const Real ds = s - m.mean_s, dt = t - m.mean_t;
            const Real q = ds * (form_ss * ds + 2 * form_st * dt) + form_tt * dt * dt;
            texel_second += w * q;
            texel_fourth += w * q * q;
        });
        second += texel_weight * texel_second;
        fourth += texel_weight * texel_fourth;
    });
    second /= weight;
    fourth /= weight;
    return static_cast<double>(singular ? 8 * fourth / (3 * second * second) : fourth);
}

Texel texel_of(const Base& base, const Shares& along_s, const Shares& along_t)
{
    Real weight = 0;
    Mean s, t, hn;
    std::array<Mean, 3> color;
    for_each_texel(base, along_s, along_t, [&](std::size_t i, Real w) {
        weight += w;
        s.add(w, base.inner[i].mean_s);
        t.add(w, base.inner[i].mean_t);
        hn.add(w, base.hn[i]);
        for (std::size_t c = 0; c < 3; ++c)
            color[c].add(w, base.colors[i][c]);
    });
    Texel out;
    if (!(weight > 0))
        return out;

    SlopeMoments m;
    m.mean_s = s.value();
    m.mean_t = t.value();
    Real var_hn = 0;
    std::array<Real, 3> var_color{}, color_hn{}, color_s{}, color_t{};
    for_each_texel(base, along_s, along_t, [&](std::size_t i, Real w) {
        const Real ds = base.inner[i].mean_s - m.mean_s, dt = base.inner[i].mean_t - m.mean_t;
        const Real dh = base.hn[i] - hn.value();
        add_component(w, base.inner[i], ds, dt, m.mu);
        var_hn += w * dh * dh;
        for (std::size_t c = 0; c < 3; ++c) {
            // Height and color are constant inside a level-0 texel, so only its mean slope counts.
            const Real dc = base.colors[i][c] - color[c].value();
            var_color[c] += w * dc * dc;
            color_hn[c] += w * dc * dh;
            color_s[c] += w * dc * ds;
            color_t[c] += w * dc * dt;
        }
    });
    for (auto& row : m.mu)
        for (Real& moment : row)
            moment /= weight;

    auto narrow = [](Real x) { return static_cast<double>(x); };
    out.coverage = narrow(weight / (total(along_s) * total(along_t)));
    out.mean_slope = {narrow(m.mean_s), narrow(m.mean_t)};
    out.cov_slope = {narrow(m.mu[2][0]), narrow(m.mu[0][2]), narrow(m.mu[1][1])};
    for (std::size_t b = 0; b <= 3; ++b)
        out.third_slope[b] = narrow(m.mu[3 - b][b]);
    for (std::size_t b = 0; b <= 4; ++b)
        out.fourth_slope[b] = narrow(m.mu[4 - b][b]);
    out.mean_hn = narrow(hn.value());
    out.var_hn = narrow(var_hn / weight);
    for (std::size_t c = 0; c < 3; ++c) {
        out.mean_color[c] = narrow(color[c].value());
        out.var_color[c] = narrow(var_color[c] / weight);
        out.cov_color_hn[c] = narrow(color_hn[c] / weight);
        out.cov_color_s[c] = narrow(color_s[c] / weight);
        out.cov_color_t[c] = narrow(color_t[c] / weight);
    }
    out.kurtosis = kurtosis_of(base, along_s, along_t, weight, m);
    out.tau = std::clamp((out.kurtosis - 8) / 8, 0.0, 1.0);
    return out;
}

/// Fills h0, h1 of the result and hn of the base.
void normalise_heights(const Input& in, Base& base, Result& result)
{
    base.hn.assign(base.own.size(), 0);
    if (in.heights.empty())
        return;
    Mean mean, square;
    for (std::size_t i = 0; i < base.own.size(); ++i)
        if (base.own[i] > 0)
            mean.add(base.own[i], in.heights[i]);
    for (std::size_t i = 0; i < base.own.size(); ++i)
        if (base.own[i] > 0)
            square.add(base.own[i],
                       (in.heights[i] - mean.value()) * (in.heights[i] - mean.value()));
    const Real deviation = std::sqrt(square.value());
    const Real h1 = deviation > 0 ? deviation : 1;
    for (std::size_t i = 0; i < base.own.size(); ++i)
        if (base.own[i] > 0)
            base.hn[i] = (in.heights[i] - mean.value()) / h1;
    result.h0 = static_cast<double>(mean.value());
    result.h1 = static_cast<double>(h1);
}

int coarser(int n) { return std::max(1, n / 2); }

} // namespace

std::vector<Shares> composed_shares(int n, int level)
{
    std::vector<Shares> rows(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        rows[static_cast<std::size_t>(i)] = {i, {1}};

    for (int l = 0; l < level; ++l) {
        const int fine = static_cast<int>(rows.size());
        const int coarse = coarser(fine);
        std::vector<Shares> next(static_cast<std::size_t>(coarse));
        for (int j = 0; j < coarse; ++j) {
            std::vector<Real> dense(static_cast<std::size_t>(n), 0);
            for (int i = 0; i < fine; ++i) {
                // [j fine/coarse, (j+1) fine/coarse) with [i, i+1), both times coarse: integers,
                // so a border that falls on a texel's edge does so exactly.
                using Wide = long long;
                const Wide from = std::max(Wide{j} * fine, Wide{i} * coarse);
                const Wide to = std::min((Wide{j} + 1) * fine, (Wide{i} + 1) * coarse);
                if (to <= from)
                    continue;
                const Real part = static_cast<Real>(to - from) / static_cast<Real>(fine);
                const Shares& of = rows[static_cast<std::size_t>(i)];
                for (std::size_t k = 0; k < of.share.size(); ++k)
                    dense[static_cast<std::size_t>(of.first) + k] += part * of.share[k];
            }
            auto positive = [](Real share) { return share > 0; };
            const auto begin = std::find_if(dense.begin(), dense.end(), positive);
            const auto end = std::find_if(dense.rbegin(), dense.rend(), positive).base();
            next[static_cast<std::size_t>(j)] = {static_cast<int>(begin - dense.begin()),
                                                 {begin, end}};
        }
        rows = std::move(next);
    }
    return rows;
}

Result brute_force(const Input& in)
{
    check(in);
    Result result;
    const std::size_t n = static_cast<std::size_t>(in.width) * static_cast<std::size_t>(in.height);

    Base base;
    base.width = in.width;
    base.own.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        base.own[i] = own_weight(in, i);
        result.valid_texels += base.own[i] > 0;
    }
    base.colors = in.colors;
    base.colors.resize(n);
    normalise_heights(in, base, result);
    base.points.resize(n);
    base.inner.resize(n);
    for (int y = 0; y < in.height; ++y)
        for (int x = 0; x < in.width; ++x) {
            const std::size_t i = index_of(in, x, y);
            if (base.own[i] > 0) {
                base.points[i] = slopes_of(in, base.own, x, y);
                base.inner[i] = moments_inside(base.points[i]);
            }
        }

    for (int level = 0;; ++level) {
        const std::vector<Shares> along_s = composed_shares(in.width, level);
        const std::vector<Shares> along_t = composed_shares(in.height, level);
        Level out;
        out.width = static_cast<int>(along_s.size());
        out.height = static_cast<int>(along_t.size());
        for (const Shares& t : along_t)
            for (const Shares& s : along_s)
                out.texels.push_back(texel_of(base, s, t));
        result.levels.push_back(std::move(out));
        if (along_s.size() == 1 && along_t.size() == 1)
            return result;
    }
}

} // namespace scree::oracle
