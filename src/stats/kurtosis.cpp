#include "stats/kurtosis.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// A variance below this share of the mean square is what rounding leaves of a plane.
constexpr double kRounding = 1e-28;

/// det / trace^2 below which C has no inverse worth using: the inverse multiplies the rounding of
/// the fourth moments by (trace^2 / det)^2, here 1e12 * 1e-16.
constexpr double kThin = 1e-6;

double clamp_weight(double tau) { return std::clamp(tau, 0.0, 1.0); }

} // namespace

Tail tail_of(const MomentLayout& layout, MomentRow row, int x)
{
    const double ss = row.plane(layout.slope_ss)[x];
    const double tt = row.plane(layout.slope_tt)[x];
    const double st = row.plane(layout.slope_st)[x];
    double fourth[5]; // ssss ssst sstt sttt tttt
    for (int i = 0; i < 5; ++i)
        fourth[i] = row.plane(layout.slope_tail + 4 + i)[x];

    const double s = row.plane(layout.slope_s)[x];
    const double t = row.plane(layout.slope_t)[x];
    const double trace = ss + tt;
    const double det = ss * tt - st * st;
    if (!(trace > kRounding * (s * s + t * t)))
        return {0, 0};
    if (det <= kThin * trace * trace) {
        // Along the eigenvector of the larger eigenvalue, the trace.
        const double length =
            std::hypot(ss, st) > std::hypot(st, tt) ? std::hypot(ss, st) : std::hypot(st, tt);
        const bool by_s = std::hypot(ss, st) > std::hypot(st, tt);
        const double u = (by_s ? ss : st) / length;
        const double v = (by_s ? st : tt) / length;
        const double x4 = u * u * u * u * fourth[0] + 4 * u * u * u * v * fourth[1] +
                          6 * u * u * v * v * fourth[2] + 4 * u * v * v * v * fourth[3] +
                          v * v * v * v * fourth[4];
        const double k1 = x4 / (trace * trace);
        return {8 * k1 / 3, clamp_weight((k1 - 3) / 3)};
    }
    // d' C^-1 d = a s^2 + 2 b s t + c t^2
    const double a = tt / det, b = -st / det, c = ss / det;
    const double kurtosis = a * a * fourth[0] + 4 * a * b * fourth[1] +
                            (2 * a * c + 4 * b * b) * fourth[2] + 4 * b * c * fourth[3] +
                            c * c * fourth[4];
    return {kurtosis, clamp_weight((kurtosis - 8) / 8)};
}

} // namespace scree
