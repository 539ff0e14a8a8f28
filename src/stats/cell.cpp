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

struct SlopePlanes {
    SlopePlanes(const MomentLayout& layout, MomentRow row)
        : s(row.plane(layout.slope_s)), t(row.plane(layout.slope_t)),
          ss(row.plane(layout.slope_ss)), tt(row.plane(layout.slope_tt)),
          st(row.plane(layout.slope_st))
    {
    }
    double *s, *t, *ss, *tt, *st;
};

/// The four quarters of texel x: `north` and `south` by row, `west` and `east` by column.
inline void quarters(const HeightRows& rows, int x, double per_dx, double per_dy, Quarter out[4])
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
    out[0] = quarter(west_c, west_u, north_c, north_w);
    out[1] = quarter(east_c, east_u, north_c, north_e);
    out[2] = quarter(west_c, west_d, south_c, south_w);
    out[3] = quarter(east_c, east_d, south_c, south_e);
}

void bilinear(const MomentLayout& layout, HeightRows rows, int count, double per_dx, double per_dy,
              MomentRow moments)
{
    const SlopePlanes out(layout, moments);
    for (int x = 0; x < count; ++x) {
        Quarter q[4];
        quarters(rows, x, per_dx, per_dy, q);
        const double s = 0.25 * ((q[0].a + q[1].a) + (q[2].a + q[3].a));
        const double t = 0.25 * ((q[0].b + q[1].b) + (q[2].b + q[3].b));
        double ss = 0, tt = 0, st = 0;
        for (const Quarter& k : q) {
            ss += (k.a - s) * (k.a - s) + k.p * k.p * (1.0 / 3);
            tt += (k.b - t) * (k.b - t) + k.q * k.q * (1.0 / 3);
            st += (k.a - s) * (k.b - t);
        }
        out.s[x] = s;
        out.t[x] = t;
        out.ss[x] = 0.25 * ss;
        out.tt[x] = 0.25 * tt;
        out.st[x] = 0.25 * st;
    }
}

/// Third and fourth central moments, after bilinear() has set the means.
void bilinear_tail(const MomentLayout& layout, HeightRows rows, int count, double per_dx,
                   double per_dy, MomentRow moments)
{
    const SlopePlanes mean(layout, moments);
    double* tail[MomentLayout::kTailPlanes];
    for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
        tail[i] = moments.plane(layout.slope_tail + i);
    for (int x = 0; x < count; ++x) {
        Quarter quarter[4];
        quarters(rows, x, per_dx, per_dy, quarter);
        double sum[MomentLayout::kTailPlanes] = {};
        for (const Quarter& k : quarter) {
            // Moments 1 to 4 of s and of t about the texel's mean; independent within a quarter.
            const double a = k.a - mean.s[x], b = k.b - mean.t[x];
            const double pp = k.p * k.p, qq = k.q * k.q;
            const double s2 = a * a + pp * (1.0 / 3), t2 = b * b + qq * (1.0 / 3);
            const double s3 = a * (a * a + pp), t3 = b * (b * b + qq);
            sum[0] += s3;
            sum[1] += s2 * b;
            sum[2] += a * t2;
            sum[3] += t3;
            sum[4] += a * a * (a * a + 2 * pp) + pp * pp * 0.2;
            sum[5] += s3 * b;
            sum[6] += s2 * t2;
            sum[7] += a * t3;
            sum[8] += b * b * (b * b + 2 * qq) + qq * qq * 0.2;
        }
        for (int i = 0; i < MomentLayout::kTailPlanes; ++i)
            tail[i][x] = 0.25 * sum[i];
    }
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
    const SlopePlanes out(layout, moments);
    for (int x = 0; x < count; ++x) {
        out.s[x] = 0.5 * per_dx * (rows.center[x + 2] - rows.center[x]);
        out.t[x] = 0.5 * per_dy * (rows.below[x + 1] - rows.above[x + 1]);
    }
    zero_spread(layout, count, moments);
}

void sobel(const MomentLayout& layout, HeightRows rows, int count, double per_dx, double per_dy,
           MomentRow moments)
{
    const SlopePlanes out(layout, moments);
    const double *u = rows.above, *c = rows.center, *d = rows.below;
    for (int x = 0; x < count; ++x) {
        const double s = (u[x + 2] - u[x]) + 2 * (c[x + 2] - c[x]) + (d[x + 2] - d[x]);
        const double t = (d[x] - u[x]) + 2 * (d[x + 1] - u[x + 1]) + (d[x + 2] - u[x + 2]);
        out.s[x] = 0.125 * per_dx * s;
        out.t[x] = 0.125 * per_dy * t;
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
