// The K0 law of slopes: one source for C++, GLSL and OSL, to be read after scree_filter.h, whose
// words, frame and ranges hold here too. docs/k0.md derives the formulas.
//
// A slope of mean m and covariance C is K0 distributed if it is normal of covariance e C, with e
// exponential of mean 1. With d^2 = (slope - m)' C^-1 (slope - m) its density is
//
//   P22 = K0(sqrt(2) d) / (pi sqrt(det C)),   D = P22 / cos^4
//
// infinite at d = 0 like -ln(d). Isotropic and of mean 0 that is d'Eon's NDF (2020) of
// alpha^2 = 2 variance. Along any direction such slopes are Laplace distributed.
//
// Random numbers u1, u2, ... are uniform in [0, 1) and independent.

#ifndef SCREE_K0_H
#define SCREE_K0_H

// --- functions ----------------------------------------------------------------------------------

/// ln(x) of a normal number x > 0.
///
/// error  relative, near x = 1 too: 1e-9 in double, 3e-7 in single precision
///        [tests/kernel/k0_functions_test.cpp]
/// source atanh((m - 1) / (m + 1)) by a minimax polynomial, ln(2) in two parts as in
/// scree_exp_minus
SCREE_FUNCTION Real scree_log(Real x)
{
    Real n = LIT(0.0);
    Real m = scree_split(x, n);
    Real s = (m - LIT(1.0)) / (m + LIT(1.0));
    Real ss = s * s;
    Real p = LIT(0.1496431710818712);
    p = p * ss + LIT(0.19987342515532125);
    p = p * ss + LIT(0.333334084611468);
    p = p * ss + LIT(0.9999999993047033);
    return n * LIT(0.693359375) + (LIT(2.0) * s * p - n * LIT(0.000212194440054690583));
}

// Bessel functions come as a value and a growth, F(x) = value exp(growth), so that products of
// large and small ones stay in range. For small x growth is 0 and the value a minimax polynomial in
// x^2, for K with the logarithm apart; beyond, sqrt(x) times the value is a ratio of polynomials in
// 1 / x. docs/fit_kernel.py makes the constants.
//
// x      in [0, 1e4]; 0 counts as 1e-30
// error  relative, of the value: 3e-8 in double, 1e-6 in single precision
//        [tests/kernel/k0_functions_test.cpp]

/// (I0(x) - 1) / x^2, x in [0, 4].
SCREE_FUNCTION Real scree_bessel_i0_rise(Real x)
{
    Real xx = x * x;
    Real p = LIT(2.9670746253018313e-12);
    p = p * xx + LIT(4.5861109565562066e-10);
    p = p * xx + LIT(6.794734606019862e-08);
    p = p * xx + LIT(6.780987663784229e-06);
    p = p * xx + LIT(0.00043402951587696674);
    p = p * xx + LIT(0.015624998408871786);
    return p * xx + LIT(0.2500000002306788);
}

/// I0(x).
SCREE_FUNCTION Real scree_bessel_i0(Real x, OUT(Real, growth))
{
    Real far = max(x, LIT(4.0));
    Real t = LIT(4.0) / far;
    Real p = LIT(-0.015795546228621508);
    p = p * t + LIT(0.0397174288709913);
    p = p * t + LIT(0.31945166243367884);
    p = p * t - LIT(0.61461623665706);
    p = p * t + LIT(0.39894227077485644);
    Real q = LIT(-0.04388129569436103);
    q = q * t + LIT(0.07868951986263455);
    q = q * t + LIT(0.8455086937415146);
    q = q * t - LIT(1.571866698203753);
    q = q * t + LIT(1.0);
    Real near = min(x, LIT(4.0));
    growth = x > LIT(4.0) ? x : LIT(0.0);
    return x > LIT(4.0) ? p / (q * sqrt(far)) : LIT(1.0) + near * near * scree_bessel_i0_rise(near);
}

/// I1(x) / x, x in [0, 4].
SCREE_FUNCTION Real scree_bessel_i1_near(Real x)
{
    Real xx = x * x;
    Real p = LIT(4.255411835327586e-11);
    p = p * xx + LIT(5.461259938912013e-09);
    p = p * xx + LIT(6.801142155619358e-07);
    p = p * xx + LIT(5.424351887470243e-05);
    p = p * xx + LIT(0.002604190193545936);
    p = p * xx + LIT(0.062499979948183404);
    return p * xx + LIT(0.500000002641114);
}

/// I1(x) / x.
SCREE_FUNCTION Real scree_bessel_i1_per_x(Real x, OUT(Real, growth))
{
    Real far = max(x, LIT(4.0));
    Real t = LIT(4.0) / far;
    Real p = LIT(-0.0004240708442552342);
    p = p * t - LIT(0.09023145483435818);
    p = p * t + LIT(0.514613767192153);
    p = p * t - LIT(0.7246931104708147);
    p = p * t + LIT(0.39894229128127);
    Real q = LIT(-0.0077354633604886916);
    q = q * t - LIT(0.1304959003683876);
    q = q * t + LIT(1.1357199105721805);
    q = q * t - LIT(1.7227837532044188);
    q = q * t + LIT(1.0);
    growth = x > LIT(4.0) ? x : LIT(0.0);
    return x > LIT(4.0) ? p / (q * far * sqrt(far)) : scree_bessel_i1_near(min(x, LIT(4.0)));
}

/// K0(x).
SCREE_FUNCTION Real scree_bessel_k0(Real x, OUT(Real, growth))
{
    Real far = max(x, LIT(2.0));
    Real t = LIT(2.0) / far;
    Real p = LIT(0.02294519421778932);
    p = p * t + LIT(0.5901906725381842);
    p = p * t + LIT(1.8953889709056833);
    p = p * t + LIT(1.2533141362869284);
    Real q = LIT(0.03423620545820008);
    q = q * t + LIT(0.5517540426159101);
    q = q * t + LIT(1.5748014719640722);
    q = q * t + LIT(1.0);
    Real near = max(min(x, LIT(2.0)), LIT(1.0e-30));
    Real xx = near * near;
    Real r = LIT(1.2799410631241086e-07);
    r = r * xx + LIT(1.0149903035846882e-05);
    r = r * xx + LIT(0.0005453498619885228);
    r = r * xx + LIT(0.014418311476952236);
    r = r * xx + LIT(0.10569618377464782);
    r = r * xx - LIT(0.5772156789601847);
    Real i0 = LIT(1.0) + xx * scree_bessel_i0_rise(near);
    growth = x > LIT(2.0) ? -x : LIT(0.0);
    return x > LIT(2.0) ? p / (q * sqrt(far)) : r - scree_log(LIT(0.5) * near) * i0;
}

/// (1 - x K1(x)) / x^2, x in [0, 2]: what K0 has within a radius, per area.
SCREE_FUNCTION Real scree_bessel_k1_fall(Real x)
{
    Real near = max(x, LIT(1.0e-30));
    Real xx = near * near;
    Real r = LIT(1.0988045481122741e-08);
    r = r * xx + LIT(1.0848499273310492e-06);
    r = r * xx + LIT(7.494074200852192e-05);
    r = r * xx + LIT(0.0028371003739562062);
    r = r * xx + LIT(0.04204902631991702);
    r = r * xx - LIT(0.03860783307139191);
    return r - scree_log(LIT(0.5) * near) * scree_bessel_i1_near(near);
}

/// x K1(x); 1 at x = 0.
SCREE_FUNCTION Real scree_bessel_x_k1(Real x, OUT(Real, growth))
{
    Real far = max(x, LIT(2.0));
    Real t = LIT(2.0) / far;
    Real p = LIT(0.06606040282093668);
    p = p * t + LIT(0.7440682280188743);
    p = p * t + LIT(1.9435368394791068);
    p = p * t + LIT(1.253314139121443);
    Real q = LIT(0.01099580964455552);
    q = q * t + LIT(0.3673688439437024);
    q = q * t + LIT(1.3632182526974852);
    q = q * t + LIT(1.0);
    Real near = min(x, LIT(2.0));
    growth = x > LIT(2.0) ? -x : LIT(0.0);
    return x > LIT(2.0) ? sqrt(far) * p / q : LIT(1.0) - near * near * scree_bessel_k1_fall(near);
}

// --- density ------------------------------------------------------------------------------------

/// Mean of K0(sqrt(2) |p|) / pi over the disk of radius rho about a point at distance d from the
/// centre: the density of slopes at d deviations, averaged over a pixel, times sqrt(det C).
///
///   d >= rho:  K0(y) 2 I1(x) / (pi x),   x = sqrt(2) rho, y = sqrt(2) d
///   d < rho:   2 (1 - x K1(x) I0(y)) / (pi x^2)
///
/// At d = 0 that is the share 1 - x K1(x) of slopes inside, per area. Both are exact: K0 solves
/// (Laplace - 2) f = 0 but at the centre, and the means of such functions over disks are these.
///
/// d        in [0, 5000], above counts as 5000
/// rho      in deviations, 0 to 5000 likewise; 0 is the density itself, at most 22 where d = 0
/// returns  > 0, 0 where exp(-y) is below 2^-118 (double: 2^-1000)
/// error    relative, per 1 + d: 1e-6 in single precision, 6e-8 in double
///          [tests/kernel/k0_density_test.cpp]
/// source   derived in docs/k0.md
SCREE_FUNCTION Real scree_k0_profile(Real d, Real rho)
{
    Real per_pi = LIT(0.318309886183790672);
    Real x = LIT(1.41421356237309505) * min(max(rho, LIT(0.0)), LIT(5000.0));
    Real y = LIT(1.41421356237309505) * min(max(d, LIT(0.0)), LIT(5000.0));
    Real mean = LIT(0.0);
    if (y >= x) {
        Real fall, growth;
        Real k0 = scree_bessel_k0(y, fall);
        Real i1 = scree_bessel_i1_per_x(x, growth);
        mean = LIT(2.0) * k0 * i1 * scree_exp_minus(-fall - growth);
    } else if (x <= LIT(2.0)) {
        // 1 - x K1 I0 = (1 - x K1) - x K1 (I0 - 1): for small x both are small.
        Real fall = scree_bessel_k1_fall(x);
        Real ratio = y / x;
        mean =
            LIT(2.0) * (fall - ratio * ratio * (LIT(1.0) - x * x * fall) * scree_bessel_i0_rise(y));
    } else {
        Real fall, growth;
        Real xk1 = scree_bessel_x_k1(x, fall);
        Real i0 = scree_bessel_i0(y, growth);
        mean = LIT(2.0) * (LIT(1.0) - xk1 * i0 * scree_exp_minus(-fall - growth)) / (x * x);
    }
    return per_pi * mean;
}

/// Density of K0 slopes at (s, t), or its mean over a pixel.
///
/// css, cst, ctt  covariance with a determinant above 0; variances of 1e-9 and more
/// rho            radius of the pixel, in deviations: it covers the slopes p with
///                (p - slope)' C^-1 (p - slope) < rho^2, an area of pi rho^2 sqrt(det C);
///                0 is the density itself, which is infinite in the middle (finite here)
/// returns        >= 0
/// error          relative, single precision: 1e-6, and what the rounding of the slope and of d
///                becomes, 3e-7 d / sqrt(1 - correlation^2) [tests/kernel/k0_density_test.cpp]
SCREE_FUNCTION Real scree_k0_slope_pdf(Real s, Real t, Real ms, Real mt, Real css, Real cst,
                                       Real ctt, Real rho)
{
    Real x, y, root_det;
    scree_slope_place(s, t, ms, mt, css, cst, ctt, x, y, root_det);
    x = min(x, LIT(5000.0));
    y = min(y, LIT(5000.0));
    return scree_k0_profile(sqrt(x * x + y * y), rho) / root_det;
}

/// Density of the slopes of a footprint, (1 - tau) Gaussian + tau K0 of the same mean and
/// covariance, K0 averaged over a pixel of radius rho as above.
///
/// tau  in [0, 1], as of NAME.tail.exr
SCREE_FUNCTION Real scree_mixture_slope_pdf(Real s, Real t, Real ms, Real mt, Real css, Real cst,
                                            Real ctt, Real tau, Real rho)
{
    Real weight = min(max(tau, LIT(0.0)), LIT(1.0));
    Real pdf = (LIT(1.0) - weight) * scree_slope_pdf(s, t, ms, mt, css, cst, ctt);
    if (weight > LIT(0.0))
        pdf = pdf + weight * scree_k0_slope_pdf(s, t, ms, mt, css, cst, ctt, rho);
    return pdf;
}

/// D(m) = P22 / mz^4: area of facets per solid angle of their normals m, per area of the texture
/// plane. rho as above.
///
/// m        unit
/// returns  >= 0; 0 where mz <= 0
/// source   d'Eon 2020
SCREE_FUNCTION Real scree_k0_ndf(Real mx, Real my, Real mz, Real ms, Real mt, Real css, Real cst,
                                 Real ctt, Real rho)
{
    Real up = max(mz, LIT(1.0e-9));
    Real p = scree_k0_slope_pdf(-mx / up, -my / up, ms, mt, css, cst, ctt, rho);
    Real per_up2 = LIT(1.0) / (up * up);
    return mz > LIT(0.0) ? p * per_up2 * per_up2 : LIT(0.0);
}

// --- projected area, masking --------------------------------------------------------------------

/// a, z, b of a direction and its tail: area of the facets that masking hides, in units of b.
SCREE_FUNCTION void scree_k0_facing(Real wx, Real wy, Real wz, Real ms, Real mt, Real css, Real cst,
                                    Real ctt, OUT(Real, a), OUT(Real, z), OUT(Real, b),
                                    OUT(Real, tail))
{
    Real per_b, us, ut, det, shift, narrowing, widening;
    a = scree_facing(wx, wy, wz, ms, mt);
    scree_spread(wx, wy, css, cst, ctt, b, per_b, us, ut, det);
    z = a * per_b;
    scree_k0_view(z, tail, shift, narrowing, widening);
}

/// N: projected area of the K0 facets that face the direction, per area of the texture plane, from
/// above it (wz > 0) as from below: the same as scree_projected_area for tau = 1, which a mixture
/// wants.
///
///   N = max(a, 0) + b exp(-sqrt(2) |z|) / (2 sqrt(2))
///
/// source  d'Eon 2020 (sigma), there for mean 0 and isotropic
SCREE_FUNCTION Real scree_k0_area(Real wx, Real wy, Real wz, Real ms, Real mt, Real css, Real cst,
                                  Real ctt)
{
    Real a, z, b, tail;
    scree_k0_facing(wx, wy, wz, ms, mt, css, cst, ctt, a, z, b, tail);
    return max(a, LIT(0.0)) + b * tail;
}

/// Smith masking of K0 slopes: scree_masking for tau = 1.
///
///   Lambda = exp(-sqrt(2) z) / (2 sqrt(2) z) = exp(-2 x) / (4 x),   x = z / sqrt(2)
///
/// x is cot(theta) / alpha for mean 0 and isotropic: the form that does not depend on the shape.
///
/// source  d'Eon 2020
SCREE_FUNCTION void scree_k0_masking(Real wx, Real wy, Real wz, Real ms, Real mt, Real css,
                                     Real cst, Real ctt, OUT(Real, lambda), OUT(Real, g1))
{
    Real a, z, b, tail;
    scree_k0_facing(wx, wy, wz, ms, mt, css, cst, ctt, a, z, b, tail);
    scree_smith(z, tail, lambda, g1);
}

/// Density of the slopes that a direction faces, max(wz - w . slope, 0) P22 / N: what
/// scree_k0_sample_visible draws from. rho as above.
///
/// returns  >= 0; 0 where N is below 1e-30
SCREE_FUNCTION Real scree_k0_visible_pdf(Real s, Real t, Real wx, Real wy, Real wz, Real ms,
                                         Real mt, Real css, Real cst, Real ctt, Real rho)
{
    Real area = scree_k0_area(wx, wy, wz, ms, mt, css, cst, ctt);
    Real weight = max(scree_facing(wx, wy, wz, s, t), LIT(0.0));
    Real pdf = scree_k0_slope_pdf(s, t, ms, mt, css, cst, ctt, rho);
    return area > LIT(1.0e-30) ? weight * pdf / area : LIT(0.0);
}

// --- sampling -----------------------------------------------------------------------------------

/// An exponential number of mean 1.
SCREE_FUNCTION Real scree_exponential(Real u)
{
    return max(-scree_log(max(LIT(1.0) - u, LIT(1.0e-30))), LIT(0.0));
}

/// Two axes in which a covariance is round: slopes m + x (us, ut) + v (ps, pt) have covariance C
/// where x and v have 1 each and are uncorrelated, and w . slope depends on x alone,
///
///   w . (us, ut) = b,   w . (ps, pt) = 0
///
/// b  sqrt(w' C w); per_b  1 / b, 1e18 where b is 0: there the axes are those of s or t
SCREE_FUNCTION void scree_slope_axes(Real wx, Real wy, Real css, Real cst, Real ctt,
                                     OUT(Real, per_b), OUT(Real, us), OUT(Real, ut), OUT(Real, ps),
                                     OUT(Real, pt))
{
    Real b, det;
    scree_spread(wx, wy, css, cst, ctt, b, per_b, us, ut, det);
    Real across = sqrt(det) * per_b;
    ps = -wy * across;
    pt = wx * across;
    if (b <= LIT(0.0)) {
        Real ds = css >= ctt ? LIT(1.0) : LIT(0.0);
        Real dt = LIT(1.0) - ds;
        Real per_other;
        scree_spread(ds, dt, css, cst, ctt, b, per_other, us, ut, det);
        across = b > LIT(0.0) ? sqrt(det) * per_other : LIT(0.0);
        ps = -dt * across;
        pt = ds * across;
    }
}

/// A K0 slope.
///
/// u1       gives the variance of the mixture, u2 and u3 a normal slope of that variance
/// source   the mixture (d'Eon 2020), Box and Muller 1958
SCREE_FUNCTION void scree_k0_sample(Real u1, Real u2, Real u3, Real ms, Real mt, Real css, Real cst,
                                    Real ctt, OUT(Real, s), OUT(Real, t))
{
    Real per_b, us, ut, ps, pt, cosine, sine;
    scree_slope_axes(LIT(0.0), LIT(0.0), css, cst, ctt, per_b, us, ut, ps, pt);
    Real d = sqrt(LIT(2.0) * scree_exponential(u1) * scree_exponential(u2));
    scree_sine_cosine(LIT(6.28318530717958648) * u3, sine, cosine);
    s = ms + d * (cosine * us + sine * ps);
    t = mt + d * (cosine * ut + sine * pt);
}

/// The part along the direction of a slope that it faces, in deviations: a number x of density
///
///   max(z - x, 0) exp(-|x| / B) / (2 B (z + tail(z))),   B = 1 / sqrt(2)
///
/// without inversion or rejection. For z > 0, |x| = y of either sign has weights that add up to
/// 2 z exp(-y / B) for all y, and (y - z) exp(-y / B) more from y = z on, where x = -y for certain:
/// an exponential number or, as rarely as masking hides area, z plus two of them.
///
/// source  docs/k0.md
SCREE_FUNCTION Real scree_k0_visible_along(Real z, Real u1, Real u2)
{
    Real scale = LIT(0.707106781186547524);
    Real facing = max(z, LIT(0.0));
    Real tail, shift, narrowing, widening;
    scree_k0_view(z, tail, shift, narrowing, widening);
    tail = max(tail, LIT(1.0e-30));
    Real share = z > LIT(0.0) ? facing / (facing + tail) : LIT(0.0);
    Real y = scale * scree_exponential(u2);
    Real x = LIT(0.0);
    if (u1 < share) {
        Real side = u1 / share; // what is left of u1 is uniform again
        x = side * (LIT(2.0) * facing) < facing - y ? y : -y;
    } else {
        Real rest = (u1 - share) / (LIT(1.0) - share);
        x = -(abs(z) + y + scale * scree_exponential(rest));
    }
    return x;
}

/// Root of the mixture's variance e for a slope x along one direction: e has a density proportional
/// to e^-1/2 exp(-e - x^2 / (2 e)), the reciprocal of an inverse Gaussian number.
///
/// gauss    a normal number: it gives the roots of (e - q)^2 = e gauss^2 / 2, q = |x| / sqrt(2)
/// u        chooses one of them
/// source   Michael, Schucany and Haas 1976, in a form that x = 0 does no harm; docs/k0.md
SCREE_FUNCTION Real scree_k0_deviation(Real x, Real gauss, Real u)
{
    Real q = abs(x) * LIT(0.707106781186547524);
    Real h = abs(gauss) * LIT(0.353553390593273762);
    Real larger = max(h + sqrt(h * h + q), LIT(1.0e-15));
    Real square = larger * larger;
    return u * (square + q) < square ? larger : q / larger;
}

/// A K0 slope as a direction faces it, with density scree_k0_visible_pdf: the visible normals of
/// Smith's model are those of these slopes.
///
/// wx, wy, wz  from above the mean plane (a > 0) or below
/// u1, u2      the part along the direction;  u3, u4, u5  the part across
/// s, t        as of scree_k0_sample where all facets face the direction, or none (b = 0)
/// error       rounding may leave wz - w . slope below 0, by 1e-6 of b
/// source      docs/k0.md
SCREE_FUNCTION void scree_k0_sample_visible(Real u1, Real u2, Real u3, Real u4, Real u5, Real wx,
                                            Real wy, Real wz, Real ms, Real mt, Real css, Real cst,
                                            Real ctt, OUT(Real, s), OUT(Real, t))
{
    Real per_b, us, ut, ps, pt, cosine, sine;
    scree_slope_axes(wx, wy, css, cst, ctt, per_b, us, ut, ps, pt);
    // Where the slope does not spread along the direction all of it shows, or nothing.
    Real z = per_b < LIT(1.0e18) ? scree_facing(wx, wy, wz, ms, mt) * per_b : LIT(1.0e18);
    Real x = scree_k0_visible_along(z, u1, u2);
    Real radius = sqrt(LIT(2.0) * scree_exponential(u3));
    scree_sine_cosine(LIT(6.28318530717958648) * u4, sine, cosine);
    Real v = scree_k0_deviation(x, radius * cosine, u5) * (radius * sine);
    s = ms + (x * us + v * ps);
    t = mt + (x * ut + v * pt);
}

#endif
