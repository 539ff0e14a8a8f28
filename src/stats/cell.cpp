#include "stats/cell.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "stats/height_rows.h"
#include "stats/merge.h"

namespace scree {

namespace {

/// A quarter cell: the slope is uniform on [a - p, a + p] x [b - q, b + q].
struct Quarter {
    double a, b, p, q;
};

struct Quarters {
    Quarter nw, ne, sw, se;
};

/// Mean over the texel of a quantity of its quarters.
template <class F>
[[gnu::always_inline]] inline double mean_of(const Quarters& quarters, F f)
{
    return 0.25 * ((f(quarters.nw) + f(quarters.ne)) + (f(quarters.sw) + f(quarters.se)));
}

[[gnu::always_inline]] inline Quarters quarters_of(const HeightRows& rows, int x, double per_dx,
                                                   double per_dy)
{
    const double *u = rows.above + x, *c = rows.center + x, *d = rows.below + x;
    // Differences along s in the three rows, and along t in the three columns.
    const double west_u = (u[1] - u[0]) * per_dx, east_u = (u[2] - u[1]) * per_dx;
    const double west_c = (c[1] - c[0]) * per_dx, east_c = (c[2] - c[1]) * per_dx;
    const double west_d = (d[1] - d[0]) * per_dx, east_d = (d[2] - d[1]) * per_dx;
    const double north_w = (c[0] - u[0]) * per_dy, south_w = (d[0] - c[0]) * per_dy;
    const double north_c = (c[1] - u[1]) * per_dy, south_c = (d[1] - c[1]) * per_dy;
    const double north_e = (c[2] - u[2]) * per_dy, south_e = (d[2] - c[2]) * per_dy;
    auto quarter = [](double s_near, double s_far, double t_near, double t_far) {
        return Quarter{0.75 * s_near + 0.25 * s_far, 0.75 * t_near + 0.25 * t_far,
                       0.25 * (s_near - s_far), 0.25 * (t_near - t_far)};
    };
    return {quarter(west_c, west_u, north_c, north_w), quarter(east_c, east_u, north_c, north_e),
            quarter(west_c, west_d, south_c, south_w), quarter(east_c, east_d, south_c, south_e)};
}

using Run = double[kMergeRun];

// The loops below write to arrays of their own, which nothing else can alias, so that the compiler
// vectorises them; the clones give the same numbers on every machine (no fused multiply-add).

[[gnu::target_clones("avx2", "default")]] void bilinear(const MomentLayout& layout, HeightRows rows,
                                                        int count, double per_dx, double per_dy,
                                                        MomentRow moments)
{
    Run s, t, ss, tt, st;
    for (int x = 0; x < count; ++x) {
        const Quarters quarters = quarters_of(rows, x, per_dx, per_dy);
        const double a = mean_of(quarters, [](const Quarter& k) { return k.a; });
        const double b = mean_of(quarters, [](const Quarter& k) { return k.b; });
        s[x] = a;
        t[x] = b;
        ss[x] = mean_of(quarters, [a](const Quarter& k) {
            return (k.a - a) * (k.a - a) + k.p * k.p * (1.0 / 3);
        });
        tt[x] = mean_of(quarters, [b](const Quarter& k) {
            return (k.b - b) * (k.b - b) + k.q * k.q * (1.0 / 3);
        });
        st[x] = mean_of(quarters, [a, b](const Quarter& k) { return (k.a - a) * (k.b - b); });
    }
    std::copy_n(s, count, moments.plane(layout.slope_s));
    std::copy_n(t, count, moments.plane(layout.slope_t));
    std::copy_n(ss, count, moments.plane(layout.slope_ss));
    std::copy_n(tt, count, moments.plane(layout.slope_tt));
    std::copy_n(st, count, moments.plane(layout.slope_st));
}

/// Third and fourth central moments, after bilinear() has set the means.
[[gnu::target_clones("avx2", "default")]] void bilinear_tail(const MomentLayout& layout,
                                                             HeightRows rows, int count,
                                                             double per_dx, double per_dy,
                                                             MomentRow moments)
{
    const double* mean_s = moments.plane(layout.slope_s);
    const double* mean_t = moments.plane(layout.slope_t);
    Run tail[MomentLayout::kTailPlanes];
    for (int x = 0; x < count; ++x) {
        // Moments of s and of t about the texel's mean, independent within a quarter:
        // a, a^2 + p^2/3, a^3 + a p^2, a^4 + 2 a^2 p^2 + p^4/5.
        const Quarters about_zero = quarters_of(rows, x, per_dx, per_dy);
        const double s = mean_s[x], t = mean_t[x];
        auto centred = [s, t](const Quarter& k) { // and its half widths squared
            return Quarter{k.a - s, k.b - t, k.p * k.p, k.q * k.q};
        };
        const Quarters q{centred(about_zero.nw), centred(about_zero.ne), centred(about_zero.sw),
                         centred(about_zero.se)};
        auto second = [](double a, double pp) { return a * a + pp * (1.0 / 3); };
        auto third = [](double a, double pp) { return a * (a * a + pp); };
        auto fourth = [](double a, double pp) { return a * a * (a * a + 2 * pp) + pp * pp * 0.2; };
        tail[0][x] = mean_of(q, [&](const Quarter& k) { return third(k.a, k.p); });
        tail[1][x] = mean_of(q, [&](const Quarter& k) { return second(k.a, k.p) * k.b; });
        tail[2][x] = mean_of(q, [&](const Quarter& k) { return k.a * second(k.b, k.q); });
        tail[3][x] = mean_of(q, [&](const Quarter& k) { return third(k.b, k.q); });
        tail[4][x] = mean_of(q, [&](const Quarter& k) { return fourth(k.a, k.p); });
        tail[5][x] = mean_of(q, [&](const Quarter& k) { return third(k.a, k.p) * k.b; });
        tail[6][x] =
            mean_of(q, [&](const Quarter& k) { return second(k.a, k.p) * second(k.b, k.q); });
        tail[7][x] = mean_of(q, [&](const Quarter& k) { return k.a * third(k.b, k.q); });
        tail[8][x] = mean_of(q, [&](const Quarter& k) { return fourth(k.b, k.q); });
    }
    for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
        std::copy_n(tail[i], count, moments.plane(layout.slope_tail + i));
}

/// One slope a texel: no spread inside it.
void zero_spread(const MomentLayout& layout, int count, MomentRow moments)
{
    for (int plane : {layout.slope_ss, layout.slope_tt, layout.slope_st})
        std::fill_n(moments.plane(plane), count, 0.0);
    if (layout.slope_tail >= 0)
        for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
            std::fill_n(moments.plane(layout.slope_tail + i), count, 0.0);
}

void central(const MomentLayout& layout, HeightRows rows, int count, double per_dx, double per_dy,
             MomentRow moments)
{
    double* s = moments.plane(layout.slope_s);
    double* t = moments.plane(layout.slope_t);
    for (int x = 0; x < count; ++x) {
        s[x] = 0.5 * per_dx * (rows.center[x + 2] - rows.center[x]);
        t[x] = 0.5 * per_dy * (rows.below[x + 1] - rows.above[x + 1]);
    }
    zero_spread(layout, count, moments);
}

void sobel(const MomentLayout& layout, HeightRows rows, int count, double per_dx, double per_dy,
           MomentRow moments)
{
    double* out_s = moments.plane(layout.slope_s);
    double* out_t = moments.plane(layout.slope_t);
    const double *u = rows.above, *c = rows.center, *d = rows.below;
    for (int x = 0; x < count; ++x) {
        const double s = (u[x + 2] - u[x]) + 2 * (c[x + 2] - c[x]) + (d[x + 2] - d[x]);
        const double t = (d[x] - u[x]) + 2 * (d[x + 1] - u[x + 1]) + (d[x + 2] - u[x + 2]);
        out_s[x] = 0.125 * per_dx * s;
        out_t[x] = 0.125 * per_dy * t;
    }
    zero_spread(layout, count, moments);
}

} // namespace

void slope_moments(const MomentLayout& layout, Reconstruction reconstruction, HeightRows rows,
                   int count, double texel_width, double texel_height, MomentRow moments)
{
    assert(count <= kMergeRun && layout.slope_s >= 0);
    const double per_dx = 1 / texel_width;
    const double per_dy = 1 / texel_height;
    switch (reconstruction) {
    case Reconstruction::bilinear:
        bilinear(layout, rows, count, per_dx, per_dy, moments);
        if (layout.slope_tail >= 0)
            bilinear_tail(layout, rows, count, per_dx, per_dy, moments);
        break;
    case Reconstruction::central:
        central(layout, rows, count, per_dx, per_dy, moments);
        break;
    case Reconstruction::sobel:
        sobel(layout, rows, count, per_dx, per_dy, moments);
        break;
    }
}

void slope_moments_with_holes(const MomentLayout& layout, Reconstruction reconstruction,
                              HeightRows rows, int count, double texel_width, double texel_height,
                              MomentRow moments)
{
    for (int x = 0; x < count; ++x) {
        double h[3][3];
        for (int s = 0; s < 3; ++s) {
            h[0][s] = rows.above[x + s];
            h[1][s] = rows.center[x + s];
            h[2][s] = rows.below[x + s];
        }
        if (std::isnan(h[1][1]))
            std::fill_n(&h[0][0], 9, 0.0);
        else
            complete_neighbours(h);
        slope_moments(layout, reconstruction, {h[0], h[1], h[2]}, 1, texel_width, texel_height,
                      moments.from(x));
    }
}

} // namespace scree
