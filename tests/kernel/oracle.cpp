#include "kernel/oracle.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::test {

namespace {

template <unsigned digits>
using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>,
                                             boost::multiprecision::et_off>;

template <typename Real>
const Real kPi = boost::math::constants::pi<Real>();

template <typename Real>
struct Moments {
    Real area, s, t, ss, st, tt; ///< E[W], E[W s], ... of FacingMoments
};

/// A view and a law of slopes.
template <typename Real>
struct Setting {
    Real wx, wy, wz, ms, mt, css, cst, ctt;

    Real facing() const { return wz - wx * ms - wy * mt; }

    /// Variance of w.slope; 0 as well where the kernel by contract takes the surface for a plane.
    Real spread() const
    {
        if (css < 1e-18 && ctt < 1e-18)
            return 0;
        return wx * wx * css + 2 * wx * wy * cst + wy * wy * ctt;
    }
};

template <typename Real>
Setting<Real> setting_of(const KernelCase& row)
{
    const auto& in = row.in;
    return {Real(in[kWox]),   Real(in[kWoy]), Real(in[kWoz]), Real(in[kMeanS]),
            Real(in[kMeanT]), Real(in[kCss]), Real(in[kCst]), Real(in[kCtt])};
}

/// All facets seen alike.
template <typename Real>
Moments<Real> without_spread(const Setting<Real>& g)
{
    const Real w = std::max<Real>(g.facing(), 0);
    return {w,
            w * g.ms,
            w * g.mt,
            w * (g.css + g.ms * g.ms),
            w * (g.cst + g.ms * g.mt),
            w * (g.ctt + g.mt * g.mt)};
}

/// Gaussian slopes: eq. 24 to 29 and 61 to 69 of the supplement in the frame of the view, o along
/// its azimuth, p (perp) across. W need not come from a unit vector: only cot theta enters, and a
/// factor in front.
///
///   E1 = sigma_o^2 p(cot theta)   eq. 59 prints the sign of -p(cot theta) and loses the scale
///   E2 = Prob(s_o < cot theta)    eq. 60; erfc(-x) / 2, not 1 - erfc(x) / 2: keeps digits
template <typename Real>
Moments<Real> gaussian_moments(const Setting<Real>& g)
{
    const Real sin2 = g.wx * g.wx + g.wy * g.wy;
    if (sin2 == 0 || g.spread() <= 0)
        return without_spread(g);
    const Real sin = sqrt(sin2), cs = g.wx / sin, sn = g.wy / sin, cot = g.wz / sin;

    const Real mo = g.ms * cs + g.mt * sn, mp = -g.ms * sn + g.mt * cs;      // 6, 7
    const Real vo = g.spread() / sin2;                                       // 8
    const Real vp = g.css * sn * sn + g.ctt * cs * cs - 2 * g.cst * cs * sn; // 9
    const Real c = (g.ctt - g.css) * cs * sn + g.cst * (cs * cs - sn * sn);  // 10
    const Real slope = c / vo, bend = mp + slope * (cot - mo);

    const Real x = (cot - mo) / sqrt(2 * vo);
    const Real e1 = sqrt(vo / (2 * kPi<Real>)) * exp(-x * x);
    const Real e2 = boost::math::erfc(Real(-x)) / 2;
    const Real io = -e1 + mo * e2;                                                  // 62
    const Real ip = -slope * e1 + mp * e2;                                          // 63
    const Real ioo = -cot * e1 + vo * e2 + mo * io;                                 // 64
    const Real ipp = -slope * bend * e1 + vp * e2 + mp * ip;                        // 65
    const Real iop = -slope * cot * e1 + c * e2 + mp * io;                          // 66
    const Real ioop = -slope * cot * cot * e1 + 2 * c * io + mp * ioo;              // 67
    const Real iopp = -(vp - slope * c + bend * bend) * e1 + mo * ipp + 2 * c * ip; // 68
    const Real iooo = 2 * vo * io - cot * cot * e1 + mo * ioo;                      // 69

    const Real area = g.wz * e2 - sin * io;
    const Real o = g.wz * io - sin * ioo, p = g.wz * ip - sin * iop;
    const Real oo = g.wz * ioo - sin * iooo, op = g.wz * iop - sin * ioop;
    const Real pp = g.wz * ipp - sin * iopp;
    return {area,
            o * cs - p * sn,
            o * sn + p * cs,
            oo * cs * cs + pp * sn * sn - 2 * op * cs * sn,
            (oo - pp) * cs * sn + op * (cs * cs - sn * sn),
            oo * sn * sn + pp * cs * cs + 2 * op * cs * sn};
}

/// Integrals over t < z of t^n and of |t| t^n times the Laplace density exp(-sqrt2 |t|) / sqrt2.
template <typename Real>
struct LaplaceIntegrals {
    Real plain[4], absolute[2];

    explicit LaplaceIntegrals(const Real& z)
    {
        const Real root2 = boost::math::constants::root_two<Real>();
        Real left[4]; // t < min(z, 0), by parts
        const Real end = std::min<Real>(z, 0), at_end = exp(root2 * end) / 2;
        Real power = 1;
        for (int n = 0; n < 4; ++n, power *= end)
            left[n] = power * at_end - (n ? Real(n / root2 * left[n - 1]) : Real(0));
        Real right[4] = {0, 0, 0, 0}; // 0 < t < z
        if (z > 0) {
            const Real at_z = exp(-root2 * z) / 2;
            power = 1;
            for (int n = 0; n < 4; ++n, power *= z)
                right[n] = (n ? Real(n / root2 * right[n - 1]) : Real(0.5)) - power * at_z;
        }
        for (int n = 0; n < 4; ++n)
            plain[n] = left[n] + right[n];
        for (int n = 0; n < 2; ++n)
            absolute[n] = right[n + 1] - left[n + 1];
    }
};

/// K0 slopes. Along w the slope is m + u t, t Laplace of unit variance, u = C w / b; across it is
/// normal with variance x times its share of C, and the mixing variable x given t has the mean
/// 1/2 + |t| / sqrt2.
template <typename Real>
Moments<Real> tail_moments(const Setting<Real>& g)
{
    if (g.spread() <= 0)
        return without_spread(g);
    const Real b = sqrt(g.spread()), z = g.facing() / b;
    const Real us = (g.css * g.wx + g.cst * g.wy) / b, ut = (g.cst * g.wx + g.ctt * g.wy) / b;
    const LaplaceIntegrals<Real> j(z);
    const Real w = b * (z * j.plain[0] - j.plain[1]);
    const Real wt = b * (z * j.plain[1] - j.plain[2]);
    const Real wtt = b * (z * j.plain[2] - j.plain[3]);
    const Real wx =
        w / 2 + b * (z * j.absolute[0] - j.absolute[1]) / boost::math::constants::root_two<Real>();
    auto second = [&](const Real& mi, const Real& mj, const Real& ui, const Real& uj,
                      const Real& cij) {
        return Real(mi * mj * w + (mi * uj + mj * ui) * wt + ui * uj * wtt + (cij - ui * uj) * wx);
    };
    return {w,
            g.ms * w + us * wt,
            g.mt * w + ut * wt,
            second(g.ms, g.ms, us, us, g.css),
            second(g.ms, g.mt, us, ut, g.cst),
            second(g.mt, g.mt, ut, ut, g.ctt)};
}

template <typename Real>
Moments<Real> mixed_moments(const Setting<Real>& g, const Real& tau)
{
    const Moments<Real> n = gaussian_moments(g), k = tail_moments(g);
    auto mix = [&](const Real& x, const Real& y) { return Real((1 - tau) * x + tau * y); };
    return {mix(n.area, k.area), mix(n.s, k.s),   mix(n.t, k.t),
            mix(n.ss, k.ss),     mix(n.st, k.st), mix(n.tt, k.tt)};
}

constexpr double kMostLambda = 1e6; // the kernel's, by contract

/// Lambda, given the area hidden from a view: what the opposite one would see if facets had no
/// thickness, E[max(-w.n, 0)] = N - a without its cancellation.
template <typename Real>
Real smith_lambda(const Real& facing, const Real& hidden)
{
    return facing > 0 ? std::min<Real>(hidden / facing, kMostLambda) : Real(kMostLambda);
}

template <typename Real>
Setting<Real> from_below(Setting<Real> g)
{
    g.wx = -g.wx, g.wy = -g.wy, g.wz = -g.wz;
    return g;
}

/// The view, and slopes of mean 0 with the case's raw second moments.
template <typename Real>
Setting<Real> of_second_moments(const KernelCase& row)
{
    Setting<Real> g = setting_of<Real>(row);
    g.ms = 0, g.mt = 0;
    g.css = row.in[kSecondSs], g.ctt = row.in[kSecondTt];
    const Real most = sqrt(g.css * g.ctt); // rounding to float32 may have gone beyond it
    g.cst = std::max<Real>(-most, std::min<Real>(most, row.in[kSecondSt]));
    return g;
}

template <typename Real>
Real specular(const KernelCase& row)
{
    Setting<Real> o = setting_of<Real>(row);
    const Real base = std::max<Real>(Real(row.in[kBaseAlpha]), Real(1e-4));
    o.css += base * base / 2;
    o.ctt += base * base / 2;
    Setting<Real> i = o;
    i.wx = row.in[kWix], i.wy = row.in[kWiy], i.wz = row.in[kWiz];
    if (i.facing() <= 0)
        return 0;
    const Real hz = o.wz + i.wz, s = -(o.wx + i.wx) / hz, t = -(o.wy + i.wy) / hz;
    const Real ds = s - o.ms, dt = t - o.mt, det = o.css * o.ctt - o.cst * o.cst;
    const Real q = (o.ctt * ds * ds - 2 * o.cst * ds * dt + o.css * dt * dt) / det;
    const Real pdf = exp(-q / 2) / (2 * kPi<Real> * sqrt(det));
    const Real lambda_i = smith_lambda<Real>(i.facing(), gaussian_moments(from_below(i)).area);
    const Real jacobian = 1 + s * s + t * t;
    const Real seen = gaussian_moments(o).area + std::max<Real>(o.facing(), 0) * lambda_i;
    return 4 * seen > Real(1e-24) ? Real(pdf * jacobian * jacobian / (4 * seen)) : Real(0);
}

template <typename Real>
Real color_by_slope(const KernelCase& row)
{
    const Setting<Real> g = setting_of<Real>(row);
    const Real c = row.in[kC], b2 = g.spread(), tau = row.in[kTau];
    if (b2 <= 0)
        return std::max<Real>(c, 0);
    const Real b = sqrt(b2), z = std::max<Real>(g.facing() / b, 0);
    const auto standard = mixed_moments<Real>({1, 0, z, 0, 0, 1, 0, 1}, tau);
    const Real level = (g.wx * g.wx + g.wy * g.wy) * (g.css + g.ctt) / 100000000;
    const Real pull = standard.s / standard.area * b / (b2 + level);
    const Real cov_s = row.in[kCs] - c * g.ms, cov_t = row.in[kCt] - c * g.mt;
    return std::max<Real>(c + pull * (cov_s * g.wx + cov_t * g.wy), 0);
}

/// tan theta from its cosine, theta at most acos(0.01).
template <typename Real>
Real node_coordinate(const Real& cosine)
{
    const Real c = std::min<Real>(1, std::max<Real>(cosine, Real(1) / 100));
    return sqrt(1 / (c * c) - 1);
}

/// Everything that concerns visibility tables.
template <typename Real, typename Set>
void set_table_outputs(const KernelCase& row, Set&& set)
{
    const auto& in = row.in;
    const Real cosine = in[kWoz], x = node_coordinate<Real>(cosine);
    const Real near = node_coordinate<Real>(in[kNodeNear]),
               far = node_coordinate<Real>(in[kNodeFar]);
    set(kNodeCoordinate, x);
    set(kNodeShare, std::min<Real>(1, std::max<Real>(0, (x - near) / (far - near))));
    if (in[kWox] != 0 || in[kWoy] != 0) {
        const Real phi = atan2(Real(in[kWoy]), Real(in[kWox]));
        set(kCos1, cos(phi)), set(kCos2, cos(2 * phi));
        set(kSin1, sin(phi)), set(kSin2, sin(2 * phi));
    }

    const Real along = in[kWox];
    set(kAxisCosine, cosine <= 0  ? Real(0)
                     : along == 0 ? Real(1)
                                  : Real(cos(atan(abs(along) / cosine))));
    const Real c = in[kTableC], beta = in[kBeta], v = 1 + Real(in[kA]), d = Real(1) / 4;
    set(kVisibleArea, v > 0 && cosine > 0 ? Real(v * cosine) : Real(0));
    const Real of_seen = c + beta; // E[c v]
    const Real view = std::max<Real>(0, v >= d    ? Real(of_seen / v)
                                        : v >= -d ? Real((of_seen + (d - v) * c) / d)
                                                  : Real(c - (of_seen - v * c) / v));
    set(kByVisibility, view);
    const Real horizontal = Real(in[kWox]) * in[kWix] + Real(in[kWoy]) * in[kWiy];
    const Real together = (9 + 8 * horizontal) / 20;
    set(kOverlap, together);
    const Real by_view = view - c, by_light = in[kLitC] - c;
    Real shift = by_view + by_light;
    if (by_view * by_light > 0) // of the smaller one, the rest
        shift -= together * (abs(by_view) < abs(by_light) ? by_view : by_light);
    set(kSeenAndLit, std::max<Real>(0, c + shift));
}

template <typename Real>
Outputs<double> oracle_in(const KernelCase& row)
{
    Outputs<double> out{};
    auto set = [&](int output, const Real& value) {
        out[static_cast<size_t>(output)] = static_cast<double>(value);
    };
    const auto& in = row.in;

    const Real rs = in[kRawS], rt = in[kRawT];
    const Real raw_ss = std::max<Real>(Real(in[kRawSs]) - rs * rs, 0);
    const Real raw_tt = std::max<Real>(Real(in[kRawTt]) - rt * rt, 0);
    const Real limit = sqrt(raw_ss * raw_tt), raw_st = Real(in[kRawSt]) - rs * rt;
    set(kRawCss, raw_ss);
    set(kRawCst, std::max<Real>(-limit, std::min<Real>(limit, raw_st)));
    set(kRawCtt, raw_tt);

    const Setting<Real> g = setting_of<Real>(row);
    const Real facing = g.facing();
    const auto seen = mixed_moments<Real>(g, in[kTau]);
    set(kArea, seen.area);
    set(kProjected, seen.area);
    if (seen.area > 0 && g.spread() > 0) {
        const Real s = seen.s / seen.area, t = seen.t / seen.area;
        set(kVisibleS, s);
        set(kVisibleT, t);
        set(kVisibleSs, seen.ss / seen.area - s * s);
        set(kVisibleSt, seen.st / seen.area - s * t);
        set(kVisibleTt, seen.tt / seen.area - t * t);
    } else if (facing < 0 && g.spread() > 0) {
        // So far below that exp(-z^2 / 2) is 0 even here (one groove of the table, z = -3e15): of a
        // Gaussian only its edge is seen, t exp(-|z| t) beyond z, but for a share of 1 / z^2.
        const Real b = sqrt(g.spread()), z = facing / b;
        const Real us = (g.css * g.wx + g.cst * g.wy) / b, ut = (g.cst * g.wx + g.ctt * g.wy) / b;
        const Real shift = z + 2 / z, lost = 1 - 2 / (z * z);
        set(kVisibleS, g.ms + us * shift);
        set(kVisibleT, g.mt + ut * shift);
        set(kVisibleSs, g.css - us * us * lost);
        set(kVisibleSt, g.cst - us * ut * lost);
        set(kVisibleTt, g.ctt - ut * ut * lost);
    } else { // by contract the surface itself
        set(kVisibleS, g.ms);
        set(kVisibleT, g.mt);
        set(kVisibleSs, g.css);
        set(kVisibleSt, g.cst);
        set(kVisibleTt, g.ctt);
    }
    set(kLambda, smith_lambda<Real>(facing, mixed_moments<Real>(from_below(g), in[kTau]).area));
    set(kG1, facing > 0 ? Real(facing / seen.area) : Real(0));

    set(kBySlope, color_by_slope<Real>(row));
    set(kSpecular, specular<Real>(row));

    const Real base = in[kBaseAlpha], half_sum = (g.css + g.ctt) / 2;
    const Real half_difference = (g.css - g.ctt) / 2;
    const Real radius = sqrt(half_difference * half_difference + g.cst * g.cst);
    set(kAlphaX, sqrt(base * base + 2 * (half_sum + radius)));
    set(kAlphaY, sqrt(base * base + 2 * std::max<Real>(half_sum - radius, 0)));
    set(kAngle, atan2(Real(2 * g.cst), Real(g.css - g.ctt)) / 2);
    set(kAlong, sqrt((9 * g.css + 24 * g.cst + 16 * g.ctt) / 25));
    set(kSteepness, sqrt(g.ms * g.ms + g.mt * g.mt));
    set(kSteepnessSpread, sqrt((g.css + g.ctt) / 2));
    set_table_outputs<Real>(row, set);
    const Setting<Real> about_plane = of_second_moments<Real>(row);
    set(kRawLambda,
        smith_lambda<Real>(about_plane.wz,
                           mixed_moments<Real>(from_below(about_plane), in[kTau]).area));
    take_exponent(row, out[kLambda], out);
    take_raw_lambda(row, out[kRawLambda], out);
    return out;
}

/// Mean and variance of the density proportional to phi Phi^L. The trapezoidal rule on a grid of
/// 1/32 has no error to speak of: for L up to 1e6 the density is analytic and 6 steps wide or more.
struct VisibleHeight {
    double mean, variance;

    explicit VisibleHeight(double exponent)
    {
        static const std::vector<std::array<double, 3>> nodes = [] { // x, phi, log Phi
            std::vector<std::array<double, 3>> all;
            for (int i = -320; i <= 320; ++i) {
                const double x = i / 32.0, tail = std::erfc(std::abs(x) / std::sqrt(2.0)) / 2;
                all.push_back(
                    {x, std::exp(-x * x / 2), x > 0 ? std::log1p(-tail) : std::log(tail)});
            }
            return all;
        }();
        double sum = 0, first = 0, second = 0;
        for (const auto& [x, phi, log_rank] : nodes) {
            const double weight = phi * std::exp(exponent * log_rank);
            sum += weight;
            first += weight * x;
        }
        mean = first / sum;
        for (const auto& [x, phi, log_rank] : nodes)
            second += phi * std::exp(exponent * log_rank) * (x - mean) * (x - mean);
        variance = second / sum;
    }
};

} // namespace

bool positive_semi_definite(double ss, double st, double tt)
{
    using Real = Number<60>; // holds the products of two doubles
    return ss >= 0 && tt >= 0 && Real(ss) * tt >= Real(st) * st;
}

bool has_oracle(const KernelCase& row)
{
    return positive_semi_definite(row.in[kCss], row.in[kCst], row.in[kCtt]);
}

Outputs<double> oracle(const KernelCase& row, Digits digits)
{
    return digits == Digits::k60 ? oracle_in<Number<60>>(row) : oracle_in<Number<100>>(row);
}

void take_exponent(const KernelCase& row, double exponent, Outputs<double>& outputs)
{
    // The products of two floats are exact in double.
    const double h = row.in[kH], hh = row.in[kHh], c = row.in[kC];
    const VisibleHeight seen(exponent);
    outputs[kHeightMean] = seen.mean;
    outputs[kHeightVariance] = seen.variance;

    const double variance = std::max(hh - h * h, 0.0), sigma = std::sqrt(variance);
    const double fading = variance > 0 ? 1 / (1 + std::pow(hh / 1024 / variance, 2)) : 0;
    const double pull = variance > 0 ? (row.in[kCh] - c * h) / sigma * fading : 0;
    outputs[kByHeight] = std::max(0.0, c + pull * seen.mean);

    double color = c, term = 1;
    for (int n = 0; n < 8; ++n) {
        term *= (exponent - n) / (exponent + 2 + n);
        color += row.in[static_cast<size_t>(kA1 + n)] * term;
    }
    outputs[kByRank] = std::max(0.0, color);

    auto unit = [](double x) { return std::min(1.0, std::max(0.0, x)); };
    const double x = unit((h + sigma * seen.mean + 4) / 8);
    const double y = std::sqrt(unit(sigma * std::sqrt(seen.variance) / 2));
    outputs[kMapU] = (x * 255 + 0.5) / 256;
    outputs[kMapV] = (y * 31 + 0.5) / 32;
}

void take_raw_lambda(const KernelCase& row, double lambda, Outputs<double>& outputs)
{
    const double above = std::max(lambda - static_cast<double>(row.in[kThreshold]), 0.0);
    const double log_exponent = std::log(above) * static_cast<double>(row.in[kPower]) +
                                std::log(static_cast<double>(row.in[kGain]));
    outputs[kMeasured] = std::min(std::exp(log_exponent), 1e6);
}

FacingMoments gaussian_facing_moments(const KernelCase& row, double spread, double from_s,
                                      double from_t)
{
    using Real = Number<60>;
    Setting<Real> g = setting_of<Real>(row);
    g.css *= spread, g.cst *= spread, g.ctt *= spread;
    g.wz -= g.wx * from_s + g.wy * from_t; // W as a function of the slope from there
    g.ms -= from_s, g.mt -= from_t;
    const Moments<Real> m = gaussian_moments(g);
    auto round = [](const Real& x) { return static_cast<double>(x); };
    return {round(m.area), round(m.s), round(m.t), round(m.ss), round(m.st), round(m.tt)};
}

double grazing_distance(const KernelCase& row)
{
    using Real = Number<60>;
    const auto g = setting_of<Real>(row);
    if (g.spread() <= 0)
        return std::numeric_limits<double>::infinity();
    return static_cast<double>(Real(g.facing() / sqrt(g.spread())));
}

} // namespace scree::test
