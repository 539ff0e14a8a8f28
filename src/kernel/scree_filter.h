// What a viewer sees of a filtered surface: one source for C++, GLSL and OSL.
//
// A prelude (prelude_cpp.h, prelude_glsl.h, prelude_osl.h) defines before this file
//   Real                  float, in C++ also double
//   LIT(x)                a literal of type Real
//   OUT(Real, name)       an output parameter
//   SCREE_FUNCTION        what stands before a function
//   scree_high_part, scree_opaque, scree_exp2_minus_nearest, scree_split   see prelude_cpp.h
// and everything below is arithmetic on scalars, so that three compilers read the same text; of the
// languages' own functions it calls abs, min, max, sqrt and pow. That is why it is one file.
// docs/filtering.md derives the formulas.
//
// Frame: x along +s (right), y along +t (down the image), z out of the surface. w = (wx, wy, wz) is
// a unit vector away from the surface, to the viewer or to a light. Slopes (s, t) = (dh/ds, dh/dt)
// have mean (ms, mt) and covariance (css, cst, ctt); the normal of a slope is (-s, -t, 1).
//
//   a = wz - wx ms - wy mt     projected area of the mean plane, per area of the texture plane
//   k = C (wx, wy),  b = sqrt((wx, wy) . k)     spread of that area over the facets
//   z = a / b                  how far the mean plane is from facing away, in spreads
//
// Ranges, in single precision: mean slopes to 1e6, variances 1e-18 to 1e12, less counts as none.
// There every result is finite. Inputs are numbers: what comes of a NaN is not defined. Contracted
// multiply-adds do no harm. A compiler that may reorder sums (-ffast-math) takes the exactness of
// scree_product_difference and scree_minus_products where they are computed as below; then long
// thin covariances, and z below -5, are no more accurate than in the textbook.

#ifndef SCREE_FILTER_H
#define SCREE_FILTER_H

// --- arithmetic ---------------------------------------------------------------------------------

/// a b - product, exactly, where product is a b rounded.
///
/// source  Dekker 1971
SCREE_FUNCTION Real scree_product_error(Real a, Real b, Real product)
{
    Real ah = scree_high_part(a);
    Real bh = scree_high_part(b);
    Real al = a - ah;
    Real bl = b - bh;
    return (((ah * bh - product) + ah * bl) + al * bh) + al * bl;
}

/// a + b - sum, exactly, where sum is a + b rounded.
///
/// source  Knuth, The Art of Computer Programming 2, section 4.2.2
SCREE_FUNCTION Real scree_sum_error(Real a, Real b, Real sum)
{
    Real total = scree_opaque(sum);
    Real of_b = scree_opaque(total - a);
    return (a - (total - of_b)) + (b - of_b);
}

/// a b - c d, rounded once: covariances, determinants and projections of long thin covariances are
/// such differences, and in the plain expression all their digits can cancel.
///
/// In C++ single precision the prelude has the same by way of double.
SCREE_FUNCTION Real scree_product_difference(Real a, Real b, Real c, Real d)
{
    // Opaque: contracted into p - q, the product would not be the one whose error is known.
    Real p = scree_opaque(a * b);
    Real q = scree_opaque(c * d);
    Real difference = p - q;
    Real error = scree_sum_error(p, -q, difference);
    return difference + (error + (scree_product_error(a, b, p) - scree_product_error(c, d, q)));
}

/// x - a b - c d, rounded once; likewise.
SCREE_FUNCTION Real scree_minus_products(Real x, Real a, Real b, Real c, Real d)
{
    Real p = scree_opaque(a * b);
    Real q = scree_opaque(c * d);
    Real first = x - p;
    Real second = first - q;
    Real error = scree_sum_error(x, -p, first) + scree_sum_error(first, -q, second);
    return second + (error - (scree_product_error(a, b, p) + scree_product_error(c, d, q)));
}

/// exp(r) to 1e-8 relative or rounding for |r| <= ln(2) / 2, 4e-8 for |r| <= 0.37: a minimax
/// polynomial.
SCREE_FUNCTION Real scree_exp_small(Real r)
{
    Real p = LIT(0.0013901298496059652);
    p = p * r + LIT(0.008363200039986536);
    p = p * r + LIT(0.04166685423024811);
    p = p * r + LIT(0.16666576962372753);
    p = p * r + LIT(0.4999999954996815);
    return (LIT(1.0) + r) + r * r * p;
}

/// exp(-x) for x in [0, 1e4], to 1e-8 relative or rounding of x; 0 below 2^-118 in single
/// precision, 2^-1000 in double.
///
/// Not the language's own exp: compilers do not vectorise it, and shading languages promise little
/// of it. exp(-x) = 2^-n exp(n ln(2) - x), and n ln(2) is taken in two parts, the first with so few
/// digits that its product with n is exact (Cody and Waite 1980).
/// [tests/kernel/arithmetic_test.cpp]
SCREE_FUNCTION Real scree_exp_minus(Real x)
{
    Real n = LIT(0.0);
    Real power = scree_exp2_minus_nearest(x * LIT(1.44269504088896341), n);
    Real r = (n * LIT(0.693359375) - x) - n * LIT(0.000212194440054690583);
    return power * scree_exp_small(r);
}

/// Density of a standard normal number at y >= 0, to 5e-7 relative in single precision; 0 where
/// scree_exp_minus is.
///
/// y^2 / 2 is taken in two parts, the first exact: its rounding alone would be 5e-6 of the density
/// at y = 12.
SCREE_FUNCTION Real scree_normal_pdf(Real y)
{
    Real c = min(y, LIT(120.0));
    Real h = scree_high_part(c);
    Real n = LIT(0.0);
    Real power = scree_exp2_minus_nearest(c * c * LIT(0.721347520444481704), n);
    Real r = (n * LIT(0.693359375) - LIT(0.5) * h * h) -
             (n * LIT(0.000212194440054690583) + (c - h) * (LIT(0.5) * (c + h)));
    return (LIT(0.398942280401432678) * power) * scree_exp_small(r);
}

/// Angle of (x, y) in (-pi, pi], to rounding; 0 for (0, 0).
SCREE_FUNCTION Real scree_atan2(Real y, Real x)
{
    Real ax = abs(x);
    Real ay = abs(y);
    Real longer = max(ax, ay);
    Real shorter = min(ax, ay);
    // atan(q) = pi / 4 - atan((1 - q) / (1 + q)) above tan(pi / 8)
    Real turn = shorter > LIT(0.414213562373095049) * longer ? LIT(0.785398163397448310) : LIT(0.0);
    Real part = turn > LIT(0.0) ? shorter - longer : shorter;
    Real whole = turn > LIT(0.0) ? shorter + longer : longer;
    Real q = whole > LIT(0.0) ? part / whole : LIT(0.0);
    Real qq = q * q;
    Real p = LIT(-0.0191754047111049337);
    p = p * qq + LIT(0.0392304477847930952);
    p = p * qq - LIT(0.0508540783458948426);
    p = p * qq + LIT(0.0585814090486632828);
    p = p * qq - LIT(0.066645105255089366);
    p = p * qq + LIT(0.0769218312537689209);
    p = p * qq - LIT(0.0909090457530648908);
    p = p * qq + LIT(0.111111110151870187);
    p = p * qq - LIT(0.142857142846656808);
    p = p * qq + LIT(0.199999999999955165);
    p = p * qq - LIT(0.333333333333333302);
    Real angle = turn + (q + q * qq * p);
    angle = ay > ax ? LIT(1.57079632679489662) - angle : angle;
    angle = x < LIT(0.0) ? LIT(3.14159265358979324) - angle : angle;
    return y < LIT(0.0) ? -angle : angle;
}

/// sin and cos to rounding (2e-16 in double), |angle| <= 20: two minimax polynomials on a quarter
/// of the circle. Not the languages' own, which promise less than float holds.
SCREE_FUNCTION void scree_sine_cosine(Real angle, OUT(Real, sine), OUT(Real, cosine))
{
    Real quarters = floor(angle * LIT(0.636619772367581343) + LIT(0.5));
    // pi / 2 in two parts, the first with so few digits that its product is exact.
    Real r = (angle - quarters * LIT(1.5703125)) - quarters * LIT(0.000483826794896619231);
    Real rr = r * r;
    Real s = LIT(1.59181152632659752e-10);
    s = s * rr - LIT(2.50511316502351815e-8);
    s = s * rr + LIT(2.75573161016178744e-6);
    s = s * rr - LIT(0.000198412698367567725);
    s = s * rr + LIT(0.00833333333333094729);
    s = s * rr - LIT(0.166666666666666646);
    s = r + r * rr * s;
    Real c = LIT(-1.13826236474746046e-11);
    c = c * rr + LIT(2.08761461465586116e-9);
    c = c * rr - LIT(2.7557317271145146e-7);
    c = c * rr + LIT(0.0000248015872987645608);
    c = c * rr - LIT(0.00138888888888873965);
    c = c * rr + LIT(0.0416666666666666654);
    c = LIT(1.0) - rr * (LIT(0.5) - rr * c);
    Real quarter = quarters - LIT(4.0) * floor(quarters * LIT(0.25));
    Real odd = abs(quarter - LIT(2.0)); // 1 for quarters 1 and 3
    sine = odd == LIT(1.0) ? c : s;
    cosine = odd == LIT(1.0) ? s : c;
    sine = quarter >= LIT(2.0) ? -sine : sine;
    cosine = quarter == LIT(1.0) || quarter == LIT(2.0) ? -cosine : cosine;
}

// --- from filtered moments ----------------------------------------------------------------------

/// E[x y] - E[x] E[y] of filtered raw moments: the covariance of two quantities, or with y = x a
/// variance that filtering and rounding may have left slightly negative.
SCREE_FUNCTION Real scree_central(Real xy, Real x, Real y)
{
    return scree_product_difference(xy, LIT(1.0), x, y);
}

/// Covariance of the slope from its raw moments, made positive semi-definite.
///
/// s, t, ss, st, tt   E[s], E[t], E[ss], E[st], E[tt], in any filter's mixture
/// css, cst, ctt      css, ctt in [0, 1e12]; cst^2 <= css ctt up to rounding: negative variances
///                    become 0, a too large |cst| becomes sqrt(css ctt). An infinite second moment
///                    (overflown half) counts as the largest variance.
SCREE_FUNCTION void scree_covariance(Real s, Real t, Real ss, Real st, Real tt, OUT(Real, css),
                                     OUT(Real, cst), OUT(Real, ctt))
{
    Real largest = LIT(1.0e12);
    css = min(max(scree_central(min(ss, LIT(1.0e18)), s, s), LIT(0.0)), largest);
    ctt = min(max(scree_central(min(tt, LIT(1.0e18)), t, t), LIT(0.0)), largest);
    Real bound = sqrt(css) * sqrt(ctt);
    cst = min(max(scree_central(st, s, t), -bound), bound);
}

// --- what a direction sees ----------------------------------------------------------------------

/// a = wz - wx ms - wy mt: projected area of the mean plane, rounded once even where the three
/// terms cancel.
///
/// Where z is -12 the projected area goes as exp(-z^2 / 2): an error of 1e-6 in z is 1e-5 there,
/// and a is compared with b, which for long thin covariances is very small.
SCREE_FUNCTION Real scree_facing(Real wx, Real wy, Real wz, Real ms, Real mt)
{
    return scree_minus_products(wz, wx, ms, wy, mt);
}

/// The covariance seen along a direction: b, u = C w / b, and the part that w does not see,
///
///   C - u u' = (det C / b^2) (-wy, wx) (-wy, wx)'
///
/// which in two dimensions is of rank one and never negative.
///
/// wx, wy       the direction's horizontal part
/// b            sqrt(w' C w) >= 0; 0 where C does not spread along w (flat, or w upright)
/// per_b        1 / b; 1e18 where b is 0
/// us, ut       u, a slope; 0 where b is 0
/// det          det C >= 0
/// error        relative, a few roundings for any anisotropy and correlation
/// source       derived in docs/filtering.md
SCREE_FUNCTION void scree_spread(Real wx, Real wy, Real css, Real cst, Real ctt, OUT(Real, b),
                                 OUT(Real, per_b), OUT(Real, us), OUT(Real, ut), OUT(Real, det))
{
    Real ks = scree_product_difference(css, wx, -cst, wy);
    Real kt = scree_product_difference(ctt, wy, -cst, wx);
    det = max(scree_product_difference(css, ctt, cst, cst), LIT(0.0));
    // trace(C) w'Cw = |Cw|^2 + det |w|^2 (Cayley-Hamilton): a sum of squares, where the sum
    // css wx^2 + 2 cst wx wy + ctt wy^2 may cancel.
    Real trace = css + ctt;
    Real trace_bb = (ks * ks + kt * kt) + det * (wx * wx + wy * wy);
    b = LIT(0.0);
    per_b = LIT(1.0e18);
    us = LIT(0.0);
    ut = LIT(0.0);
    if (trace > LIT(1.0e-18) && trace_bb > LIT(1.0e-37) * (LIT(1.0) + trace)) {
        per_b = sqrt(trace / trace_bb);
        b = LIT(1.0) / per_b;
        us = ks * per_b;
        ut = kt * per_b;
    }
}

// What a direction sees of slopes that are standard normal (or K0) along it, weighted with the
// projected area W = max(z - x, 0) of slope x, in four numbers:
//
//   tail       E[W] - max(z, 0): the area that masking hides, in units of b
//   shift      E[x W] / E[W], never positive: visible slopes lean towards the viewer
//   narrowing  variance of x under the weight W, in (0, 1]; of a mixture up to 1.02
//   widening   variance across the direction, relative to its own; 1 for a Gaussian

/// The four numbers for Gaussian slopes (widening is 1).
///
///   z >= 0:  tail = phi - z Phi(-z),  shift = -Phi / n,  narrowing = 1 - shift^2 + phi / n,
///            n = z + tail
///   z < 0:   with K2 = 1 / (y + 3 K3), y = -z:  shift = -(y + 2 K2),
///            narrowing = 2 K2 (3 K3 - 2 K2),  tail = phi K1 / (y + K1),  K1 = 1 / (y + 2 K2)
///
/// where Phi(-y) / phi(y) = 1 / (y + 1 / (y + 2 / (y + 3 / (y + ...)))) is Laplace's continued
/// fraction and K3(y) = 1 / (y + 4 / (y + 5 / ...)) its rest, here a rational minimax function. So
/// nothing cancels on the far side, where the textbook form loses every digit.
///
/// z      any
/// error  relative, z >= -1e4: in double 4e-8; in single precision 1e-6 for shift, tail where z >
/// -8,
///        5e-6 for narrowing [tests/kernel/view_test.cpp]
/// limits z -> +inf: 0, -1 / z, 1;  z -> -inf: 0, z, 2 / z^2 (kept above 2e-8)
/// source derived in docs/filtering.md
SCREE_FUNCTION void scree_gaussian_view(Real z, OUT(Real, tail), OUT(Real, shift),
                                        OUT(Real, narrowing))
{
    Real y = abs(z);
    Real yc = min(y, LIT(10000.0));
    Real yy = yc * yc;
    Real p = yc + LIT(14.938073704786133);
    p = p * yc + LIT(115.13415732232644);
    p = p * yc + LIT(543.3554044234369);
    p = p * yc + LIT(1573.1392419003637);
    p = p * yc + LIT(2370.404870634954);
    Real q = yc + LIT(14.938070693429644);
    q = q * yc + LIT(119.13473122800038);
    q = q * yc + LIT(603.0709719142551);
    q = q * yc + LIT(2014.8300333143318);
    q = q * yc + LIT(4223.943158734694);
    q = q * yc + LIT(4456.29292412552);
    // K3 = p / q; K2 = q / q2, K1 = q2 / q1 and the Mills ratio q1 / q0 follow.
    Real q2 = yc * q + LIT(3.0) * p;
    Real q1 = (yy + LIT(2.0)) * q + LIT(3.0) * yc * p;
    Real q0 = yc * (yy + LIT(3.0)) * q + LIT(3.0) * (yy + LIT(1.0)) * p;

    Real phi = scree_normal_pdf(y);
    Real per_q0 = LIT(1.0) / q0;
    tail = phi * (q2 * per_q0);
    if (z >= LIT(0.0)) {
        Real per_area = LIT(1.0) / (y + tail);
        Real facing = LIT(1.0) - phi * (q1 * per_q0); // Phi(z)
        Real lean = facing * per_area;
        shift = -lean;
        narrowing = LIT(1.0) + (phi - facing * lean) * per_area;
    } else {
        Real per_q2 = LIT(1.0) / q2;
        Real k2 = q * per_q2;
        shift = -(y + LIT(2.0) * k2);
        narrowing = LIT(6.0) * (p * per_q2) - LIT(4.0) * (k2 * k2); // p / q2 is K2 K3
    }
}

/// The four numbers for K0 slopes, which are Laplace distributed along every direction.
///
/// With B = 1 / sqrt(2), e = exp(-|z| / B):
///   z >= 0:  n = z + B e / 2,  shift = (-1 + e (z B + 1) / 2) / n,
///            narrowing = (z + e (z^2 B + 2 z + 3 B) / 2) / n - shift^2,
///            widening = 1/2 + B (z B + e (z B + 1) / 2) / n
///   z < 0:   shift = z - sqrt(2),  narrowing = 1,  widening = 3/2 - z B (z >= -5000): the tail of
///            an exponential looks the same from everywhere
///
/// error   in single precision 5e-6 of each number [tests/kernel/view_test.cpp]
/// source  after d'Eon's K0 NDF; derived in docs/filtering.md
SCREE_FUNCTION void scree_k0_view(Real z, OUT(Real, tail), OUT(Real, shift), OUT(Real, narrowing),
                                  OUT(Real, widening))
{
    Real root_half = LIT(0.707106781186547524);
    Real y = abs(z);
    Real yc = min(y, LIT(5000.0)); // e is 0 there already, and squares must not overflow
    Real e = scree_exp_minus(yc * LIT(1.41421356237309505));
    tail = LIT(0.5) * root_half * e;

    Real area = max(y + tail, LIT(1.0e-30));
    Real lean = (LIT(1.0) - LIT(0.5) * e * (yc * root_half + LIT(1.0))) / area;
    Real square =
        (y + LIT(0.5) * e * (yc * yc * root_half + LIT(2.0) * yc + LIT(3.0) * root_half)) / area;
    Real spread = (y * root_half + LIT(0.5) * e * (yc * root_half + LIT(1.0))) / area;
    shift = z >= LIT(0.0) ? -lean : -(y + LIT(1.41421356237309505));
    narrowing = z >= LIT(0.0) ? square - lean * lean : LIT(1.0);
    widening = z >= LIT(0.0) ? LIT(0.5) + root_half * spread : LIT(1.5) + root_half * yc;
}

/// The four numbers for a mixture, (1 - tau) Gaussian + tau K0 of the same covariance.
///
/// Areas mix linearly; means and variances mix with the areas each part shows, and their means'
/// distance adds to the variance.
///
/// tau  in [0, 1]; 0 and less is Gaussian
SCREE_FUNCTION void scree_mixture_view(Real z, Real tau, OUT(Real, tail), OUT(Real, shift),
                                       OUT(Real, narrowing), OUT(Real, widening))
{
    scree_gaussian_view(z, tail, shift, narrowing);
    widening = LIT(1.0);
    if (tau > LIT(0.0)) {
        Real k0_tail, k0_shift, k0_narrowing, k0_widening;
        scree_k0_view(z, k0_tail, k0_shift, k0_narrowing, k0_widening);
        Real facing = max(z, LIT(0.0));
        Real weight = min(tau, LIT(1.0));
        tail = (LIT(1.0) - weight) * tail + weight * k0_tail;
        // Far on the averted side both areas underflow; only K0 shows there long before.
        Real share = weight * (facing + k0_tail) / max(facing + tail, LIT(1.0e-36));
        share = z < LIT(-40.0) ? LIT(1.0) : min(share, LIT(1.0));
        Real apart = shift - k0_shift;
        narrowing = (LIT(1.0) - share) * narrowing + share * k0_narrowing +
                    share * (LIT(1.0) - share) * apart * apart;
        shift = (LIT(1.0) - share) * shift + share * k0_shift;
        widening = (LIT(1.0) - share) * widening + share * k0_widening;
    }
}

/// All of the above for one direction: a, z, what scree_spread gives of C, and the four numbers.
SCREE_FUNCTION void scree_view(Real wx, Real wy, Real wz, Real ms, Real mt, Real css, Real cst,
                               Real ctt, Real tau, OUT(Real, a), OUT(Real, z), OUT(Real, b),
                               OUT(Real, per_b), OUT(Real, us), OUT(Real, ut), OUT(Real, det),
                               OUT(Real, tail), OUT(Real, shift), OUT(Real, narrowing),
                               OUT(Real, widening))
{
    a = scree_facing(wx, wy, wz, ms, mt);
    scree_spread(wx, wy, css, cst, ctt, b, per_b, us, ut, det);
    z = a * per_b;
    scree_mixture_view(z, tau, tail, shift, narrowing, widening);
}

/// N: projected area of the facets that face the direction, per area of the texture plane.
///
///   N = E[max(0, wz - w . slope)] = b (z + tail(z))
///
/// returns N >= max(a, 0); 0 where z < -12.7 in single precision: the smallest normal numbers
///         end there
SCREE_FUNCTION Real scree_projected_area(Real wx, Real wy, Real wz, Real ms, Real mt, Real css,
                                         Real cst, Real ctt, Real tau)
{
    Real a, z, b, per_b, us, ut, det, tail, shift, narrowing, widening;
    scree_view(wx, wy, wz, ms, mt, css, cst, ctt, tau, a, z, b, per_b, us, ut, det, tail, shift,
               narrowing, widening);
    return max(a, LIT(0.0)) + b * tail;
}

/// Smith's Lambda and G1 where z and tail(z) are known; see scree_masking.
SCREE_FUNCTION void scree_smith(Real z, Real tail, OUT(Real, lambda), OUT(Real, g1))
{
    Real safe = max(z, LIT(1.0e-30));
    lambda = z > LIT(0.0) ? min(tail / safe, LIT(1.0e6)) : LIT(1.0e6);
    g1 = z > LIT(0.0) ? safe / (safe + tail) : LIT(0.0);
}

/// Smith masking of a direction: Lambda, and G1 = 1 / (1 + Lambda), the share of the facing area
/// that is not hidden by other facets.
///
///   Lambda = N / a - 1 = tail(z) / z,   G1 = a / N
///
/// lambda  in [0, 1e6]: hidden area per visible; 1e6 stands for infinity, also where the mean plane
///         faces away (a <= 0), so that colors stay finite there
/// g1      in [0, 1]; 0 where a <= 0; 1 where the slope does not spread along the direction
/// source  Smith 1967; off-centre slopes as in LEADR mapping (Dupuy et al. 2013)
/// not modelled: neighbouring heights and slopes are correlated on real surfaces
SCREE_FUNCTION void scree_masking(Real wx, Real wy, Real wz, Real ms, Real mt, Real css, Real cst,
                                  Real ctt, Real tau, OUT(Real, lambda), OUT(Real, g1))
{
    Real a, z, b, per_b, us, ut, det, tail, shift, narrowing, widening;
    scree_view(wx, wy, wz, ms, mt, css, cst, ctt, tau, a, z, b, per_b, us, ut, det, tail, shift,
               narrowing, widening);
    scree_smith(z, tail, lambda, g1);
}

/// Masking-shadowing of view and light together, heights correlated: 1 / (1 + Lambda_o + Lambda_i).
///
/// source  Ross, Dion and Potvin 2005; Heitz 2014
SCREE_FUNCTION Real scree_g2(Real lambda_o, Real lambda_i)
{
    return LIT(1.0) / (LIT(1.0) + lambda_o + lambda_i);
}

/// Smith's Lambda of the slopes' second moments about the texture plane: mean 0, covariance
/// (E[ss], E[st], E[tt]).
///
/// Unlike Lambda of the footprint's own mean and covariance it does not blow up where the mean
/// plane tilts away from the direction.
///
/// ss, st, tt  as filtered; made a covariance as in scree_covariance
/// tau         weight of K0, as in scree_masking
/// returns     in [0, 1e6]; 1e6 where wz <= 0
SCREE_FUNCTION Real scree_raw_lambda(Real wx, Real wy, Real wz, Real ss, Real st, Real tt, Real tau)
{
    Real css, cst, ctt, lambda, g1;
    scree_covariance(LIT(0.0), LIT(0.0), ss, st, tt, css, cst, ctt);
    scree_masking(wx, wy, wz, LIT(0.0), LIT(0.0), css, cst, ctt, tau, lambda, g1);
    return lambda;
}

/// Exponent of the visible height as an asset was measured to have it: what takes the place of
/// Smith's Lambda in color by height,
///
///   gain max(lambda - threshold, 0)^power
///
/// lambda     of scree_raw_lambda
/// gain       in [0, 8]; 0 is the mean color
/// power      in [0.1, 3];  threshold  in [0, 0.3]
/// returns    in [0, 1e6]; 0 up to the threshold. For view and light together add those of the two
/// error      in C++ a few roundings; elsewhere that of the language's pow (docs/filtering.md)
/// source     chosen by measured error; docs/filtering.md
SCREE_FUNCTION Real scree_measured_exponent(Real lambda, Real gain, Real power, Real threshold)
{
    Real above = lambda - threshold;
    Real raised = above > LIT(0.0) ? pow(above, power) : LIT(0.0);
    return min(gain * raised, LIT(1.0e6));
}

/// Mean and covariance of the visible slopes, and the projected area.
///
///   N = a Phi(z) + b phi(z)
///   m_vis = m + u shift
///   C_vis = widening (C - u u') + narrowing u u'
///
/// The exact moments of the density max(0, wz - w . slope) p(slope) / N, for Gaussian slopes, K0
/// or a mixture.
///
/// tau            weight of K0 in [0, 1]
/// area           N, as scree_projected_area
/// vs, vt         m_vis
/// vss, vst, vtt  C_vis, positive semi-definite as the numbers stand: vst^2 <= vss vtt exactly
/// limits         b = 0 (flat, or a viewer straight above): m and C unchanged. z -> -inf: facets on
///                the plane wz = w . slope nearest the mean, narrow along the view.
/// error          single precision, |z| <= 40, ratio of sigmas to 1e4 with correlation to 0.9999:
///                1e-4 of N, of sigma, of trace(C_vis) [tests/kernel/visible_slopes_test.cpp]
/// source         moments of D_s in Heitz et al. 2014, section 4, as one rank-one update; see
///                docs/filtering.md
SCREE_FUNCTION void scree_visible_slopes(Real wx, Real wy, Real wz, Real ms, Real mt, Real css,
                                         Real cst, Real ctt, Real tau, OUT(Real, area),
                                         OUT(Real, vs), OUT(Real, vt), OUT(Real, vss),
                                         OUT(Real, vst), OUT(Real, vtt))
{
    Real a, z, b, per_b, us, ut, det, tail, shift, narrowing, widening;
    scree_view(wx, wy, wz, ms, mt, css, cst, ctt, tau, a, z, b, per_b, us, ut, det, tail, shift,
               narrowing, widening);
    area = max(a, LIT(0.0)) + b * tail;
    vs = ms + us * shift;
    vt = mt + ut * shift;
    vss = css;
    vtt = ctt;
    vst = cst;
    if (b > LIT(0.0)) {
        Real across = widening * det;
        Real xs = wx * per_b;
        Real xt = wy * per_b;
        vss = across * (xt * xt) + narrowing * (us * us);
        vtt = across * (xs * xs) + narrowing * (ut * ut);
        vst = narrowing * (us * ut) - across * (xs * xt);
    }
    // Where the two rank-one parts are very unequal, rounding may leave a determinant of -1e-7.
    Real raise = vst * vst > vss * vtt * LIT(0.9999990) ? LIT(1.0000010) : LIT(1.0);
    vss = vss * raise;
    vtt = vtt * raise;
}

// --- visible height -----------------------------------------------------------------------------

/// Mean mu(L) and variance nu(L) of the visible height of Gaussian heights, in standard deviations
/// from the mean: moments of the density proportional to phi Phi^L.
///
/// L       Lambda of the view, plus Lambda of the light for what is seen and lit, in [0, 1e6]
/// mean    0 at L = 0, 1 / sqrt(pi) at 1, 4.863 at 1e6
/// variance 1 at L = 0, 1 - 1 / pi at 1, 0.0615 at 1e6
/// error   relative, 1e-6 (mean) and 2e-6 (variance) [tests/kernel/visible_height_test.cpp]
/// source  rational minimax functions of (1 + L)^(1/4) - 1, made by docs/fit_kernel.py
SCREE_FUNCTION void scree_visible_height(Real L, OUT(Real, mean), OUT(Real, variance))
{
    Real exponent = min(max(L, LIT(0.0)), LIT(1.0e6));
    Real root = sqrt(LIT(1.0) + exponent);
    Real fourth_root = sqrt(root);
    Real u = exponent / ((LIT(1.0) + fourth_root) * (LIT(1.0) + root));

    Real p = LIT(5.2664394498224024e-06);
    p = p * u + LIT(0.010272702988174015);
    p = p * u + LIT(0.4179568463627705);
    p = p * u + LIT(3.1539143833389707);
    p = p * u + LIT(6.177415599803327);
    p = p * u + LIT(3.6127879823305538);
    Real q = LIT(0.0016779929633315982);
    q = q * u + LIT(0.089773732576411);
    q = q * u + LIT(0.9205956832859097);
    q = q * u + LIT(2.711608869028208);
    q = q * u + LIT(2.8484949104305737);
    q = q * u + LIT(1.0);
    mean = u * (p / q);

    p = LIT(0.00012370586977972355);
    p = p * u + LIT(0.01611271371157856);
    p = p * u + LIT(0.28342821742531393);
    p = p * u + LIT(1.1451888849110987);
    p = p * u + LIT(1.50139751181761);
    p = p * u + LIT(1.0);
    q = LIT(0.0036928637009075228);
    q = q * u + LIT(0.2831887667479099);
    q = q * u + LIT(2.8364478665569877);
    q = q * u + LIT(5.369516656390726);
    q = q * u + LIT(3.8838493919787895);
    q = q * u + LIT(1.0);
    variance = p / q;
}

/// Standard deviation of a filtered height: sqrt(E[hh] - E[h]^2).
SCREE_FUNCTION Real scree_height_sigma(Real h, Real hh)
{
    return sqrt(max(scree_central(hh, h, h), LIT(0.0)));
}

// --- visible color, one channel at a time -------------------------------------------------------

/// Color that goes linearly with height: E[c] + cov(c, hn) / sigma mu(L).
///
/// Where sigma^2 is below 2^-10 of E[hh] this fades out: half floats hold no more, and a covariance
/// of rounding errors divided by their deviation would show as color. The factor is
/// 1 / (1 + (2^-10 E[hh] / sigma^2)^2). [tests/kernel/half_set_test.cpp]
///
/// c, ch    E[c], E[c hn], filtered
/// h, hh    E[hn], E[hn hn], filtered
/// mean     mu(L) of scree_visible_height
/// returns  at least 0: a line may leave the range of the colors it was fitted to
/// source   docs/filtering.md; but for the fading, exact where (c, h) are jointly Gaussian
SCREE_FUNCTION Real scree_color_by_height(Real c, Real ch, Real h, Real hh, Real mean)
{
    Real variance = max(scree_central(hh, h, h), LIT(0.0));
    Real noise = LIT(0.0009765625) * hh;
    Real square = variance * variance + noise * noise;
    Real shift = LIT(0.0);
    if (square > LIT(1.0e-30)) {
        shift = scree_central(ch, c, h) * (variance * sqrt(variance) / square) * mean;
    }
    return max(c + shift, LIT(0.0));
}

/// Color by the height's rank, in shifted Legendre polynomials:
///
///   c + sum_n a_n prod_{j < n} (L - j) / (L + 2 + j)
///
/// exact for any distribution of heights where the color is a polynomial of the rank, of degree up
/// to 8. Unused coefficients are 0.
///
/// c         E[c];  a1..a8 as baked: a_n = (2 n + 1) E[c P_n(2 q - 1)]
/// L         as in scree_visible_height, in [0, 1e6]
/// returns   at least 0
/// source    derived in docs/filtering.md
SCREE_FUNCTION Real scree_color_by_rank(Real c, Real a1, Real a2, Real a3, Real a4, Real a5,
                                        Real a6, Real a7, Real a8, Real L)
{
    Real e = min(max(L, LIT(0.0)), LIT(1.0e6));
    Real sum = a8 * (e - LIT(7.0)) / (e + LIT(9.0));
    sum = (a7 + sum) * (e - LIT(6.0)) / (e + LIT(8.0));
    sum = (a6 + sum) * (e - LIT(5.0)) / (e + LIT(7.0));
    sum = (a5 + sum) * (e - LIT(4.0)) / (e + LIT(6.0));
    sum = (a4 + sum) * (e - LIT(3.0)) / (e + LIT(5.0));
    sum = (a3 + sum) * (e - LIT(2.0)) / (e + LIT(4.0));
    sum = (a2 + sum) * (e - LIT(1.0)) / (e + LIT(3.0));
    sum = (a1 + sum) * e / (e + LIT(2.0));
    return max(c + sum, LIT(0.0));
}

/// Where a color-map table T(mean, deviation) = E[map(X)], X normal, is to be looked up.
///
/// Columns are means from `low` (centre of the first) to `high` (centre of the last), rows are
/// roots of the deviation from 0 to sqrt(widest) likewise: the narrower, the more detail.
///
/// mean, deviation  of what the map is applied to, in the map's units; for a height-mapped color
///                  h + sigma mu(L) and sigma sqrt(nu(L)), for a slope-mapped one the visible slope
///                  (scree_slope_along)
/// columns, rows    size of the table, at least 1
/// u, v             texture coordinates in (0, 1), clamped to the centres of the border
/// source           docs/filtering.md
SCREE_FUNCTION void scree_color_map_coordinates(Real mean, Real deviation, Real low, Real high,
                                                Real widest, Real columns, Real rows, OUT(Real, u),
                                                OUT(Real, v))
{
    Real x = high > low ? (mean - low) / (high - low) : LIT(0.0);
    Real y = widest > LIT(0.0) ? deviation / widest : LIT(0.0);
    x = min(max(x, LIT(0.0)), LIT(1.0));
    y = sqrt(min(max(y, LIT(0.0)), LIT(1.0)));
    u = (x * (columns - LIT(1.0)) + LIT(0.5)) / columns;
    v = (y * (rows - LIT(1.0)) + LIT(0.5)) / rows;
}

/// Mean and deviation of the slope along a direction (ds, dt) of length 1 in the texture plane.
SCREE_FUNCTION void scree_slope_along(Real ds, Real dt, Real ms, Real mt, Real css, Real cst,
                                      Real ctt, OUT(Real, mean), OUT(Real, deviation))
{
    Real per_deviation, us, ut, det;
    mean = ds * ms + dt * mt;
    scree_spread(ds, dt, css, cst, ctt, deviation, per_deviation, us, ut, det);
}

/// What a color map by the steepness of the slope is looked up with: the length of the mean slope,
/// and its deviation along an average direction, sqrt(trace(C) / 2).
///
/// not modelled: a spread that differs between directions
SCREE_FUNCTION void scree_slope_magnitude(Real ms, Real mt, Real css, Real ctt, OUT(Real, mean),
                                          OUT(Real, deviation))
{
    mean = sqrt(ms * ms + mt * mt);
    deviation = sqrt(LIT(0.5) * max(css + ctt, LIT(0.0)));
}

/// How strongly a direction pulls color that goes with slope: shift / b, so that the visible color
/// is E[c] + pull (cov(c, s) wx + cov(c, t) wy).
///
/// That is cov(c, slope) C^-1 (m_vis - m) with m_vis - m = C w shift / b: the inverse is gone, and
/// grooves, whose covariance has none, need no special case. Two bounds keep the rounding of the
/// moments from showing as color: a spread along w below 1e-4 of the largest fades out, and where
/// the mean plane faces away the pull is that of the horizon (z = 0).
///
/// returns  pull <= 0; 0 where the slope does not spread along the direction
/// source   derived in docs/filtering.md
SCREE_FUNCTION Real scree_slope_pull(Real wx, Real wy, Real wz, Real ms, Real mt, Real css,
                                     Real cst, Real ctt, Real tau)
{
    Real b, per_b, us, ut, det, tail, shift, narrowing, widening;
    scree_spread(wx, wy, css, cst, ctt, b, per_b, us, ut, det);
    Real facing = max(scree_facing(wx, wy, wz, ms, mt), LIT(0.0));
    scree_mixture_view(facing * per_b, tau, tail, shift, narrowing, widening);
    Real least = LIT(1.0e-8) * (wx * wx + wy * wy) * (css + ctt);
    return b > LIT(0.0) ? shift * b / (b * b + least) : LIT(0.0);
}

/// Color that goes linearly with slope.
///
/// c, cs, ct  E[c], E[c s], E[c t], filtered;  s, t  E[s], E[t]
/// pull       of scree_slope_pull
/// returns    at least 0
SCREE_FUNCTION Real scree_color_by_slope(Real c, Real cs, Real ct, Real s, Real t, Real wx, Real wy,
                                         Real pull)
{
    Real along = scree_central(cs, c, s) * wx + scree_central(ct, c, t) * wy;
    return max(c + along * pull, LIT(0.0));
}

// --- visibility tables --------------------------------------------------------------------------

// What a set measured of its own height field: of a direction w, with v = E[V W] / cos theta (V 1
// where w sees the surface, W the projected area of its facets), the moments
//
//   a = v - 1,   beta = E[c (v - 1)], one a channel
//
// at a few angles theta, the nodes, each as the mean over the azimuth and its harmonics, or as what
// is alike from all sides and what goes along two axes across each other. Straight above both are
// 0: a node that is in no file. Light is told by the same numbers as view.

/// What tables are interpolated along, linearly: tan theta, 0 straight above.
///
/// Where nothing is hidden v = 1 - tan(theta) (w's azimuth . mean slope), so that a and beta are
/// linear in it.
///
/// z        cos theta; above 1 counts as 1, below 0.01 as 0.01: directions under the texture plane
///          and those 0.6 degrees above it are alike
/// returns  in [0, 99.995], a few roundings off; z = 1 - 6e-8, the next to 1 in single precision,
///          gives 3.5e-4
SCREE_FUNCTION Real scree_node_coordinate(Real z)
{
    Real c = min(max(z, LIT(0.01)), LIT(1.0));
    return sqrt((LIT(1.0) - c) * (LIT(1.0) + c)) / c; // not 1 - c c: keeps digits near 1
}

/// Share of the farther of two neighbouring nodes, 1 minus that of the nearer.
///
/// z              cos theta of the direction
/// z_near, z_far  cos theta of the nodes, z_near > z_far; z_near = 1 is straight above
/// returns        in [0, 1], linear in the coordinate; beyond a node that node alone
SCREE_FUNCTION Real scree_node_share(Real z, Real z_near, Real z_far)
{
    Real from = scree_node_coordinate(z_near);
    Real apart = scree_node_coordinate(z_far) - from;
    Real share = (scree_node_coordinate(z) - from) / max(apart, LIT(1.0e-6));
    return min(max(share, LIT(0.0)), LIT(1.0));
}

/// Cosines and sines of once and twice the azimuth phi of (wx, wy), from +s towards +t.
///
/// c1, c2  cos phi, cos 2 phi;  s1, s2  sin phi, sin 2 phi; all 0 where the direction is upright
///         (wx^2 + wy^2 below 1e-30)
/// error   a few roundings, relative
SCREE_FUNCTION void scree_azimuth_harmonics(Real wx, Real wy, OUT(Real, c1), OUT(Real, c2),
                                            OUT(Real, s1), OUT(Real, s2))
{
    Real square = wx * wx + wy * wy;
    Real per_length = square > LIT(1.0e-30) ? LIT(1.0) / sqrt(square) : LIT(0.0);
    c1 = wx * per_length;
    s1 = wy * per_length;
    c2 = ((wx - wy) * per_length) * ((wx + wy) * per_length); // not c1 c1 - s1 s1: keeps digits
    s2 = LIT(2.0) * c1 * s1;
}

/// Cosine of a direction's angle from the normal as seen along an axis of the texture plane, across
/// which it may lean as it likes: what tables along axes are looked up with, a side at a time.
///
/// along    the direction's part along the axis;  z  cos theta
/// returns  in [0, 1]: 1 where it does not lean along the axis, 0 below the texture plane
SCREE_FUNCTION Real scree_axis_cosine(Real along, Real z)
{
    Real up = max(z, LIT(0.0));
    Real square = along * along + up * up;
    return square > LIT(1.0e-30) ? up / sqrt(square) : LIT(1.0);
}

/// E[V W]: area that a direction sees, projected, per area of the texture plane.
///
/// z        cos theta, 0 below the texture plane
/// returns  v z >= 0; filters with negative lobes and few harmonics may take v = 1 + a below 0,
///          which counts as 0
SCREE_FUNCTION Real scree_visible_area(Real z, Real a)
{
    return max(LIT(1.0) + a, LIT(0.0)) * max(z, LIT(0.0));
}

/// Visible color by measured visibility: E[c v] / v, with v = 1 + a of at least 1/4,
///
///   max(c + (beta - a c) / max(|v|, 1/4), 0)
///
/// Where less than 1/4 is seen the mean color stands in for what is missing: with d = 1/4 this is
/// (E[c v] + (d - v) c) / d. So it is continuous and finite for v = 0 and below, where harmonics
/// and filters with negative lobes may take it, and a color that visibility does not depend on
/// (beta = a c) is seen as it is, whatever a. Far below 0, where nothing is known, the shift stays
/// in proportion. A smaller d was measured to be worse on fine levels, where few harmonics ring the
/// most, and no better on coarse ones.
///
/// c        E[c];  beta, a  as above: all three filtered alike
/// returns  at least 0
/// error    at v = 1/4 four times that of beta and of a c as stored, and a few roundings of them
/// source   docs/filtering.md
SCREE_FUNCTION Real scree_color_by_visibility(Real c, Real beta, Real a)
{
    return max(c + (beta - a * c) / max(abs(LIT(1.0) + a), LIT(0.25)), LIT(0.0));
}

/// How much of what view and light both do to the color counts once, not twice.
///
///   0.45 + 0.4 (wox wix + woy wiy)
///
/// A view beside the light sees what the light lights: the horizontal parts agree.
///
/// wo, wi   unit, to viewer and light; the same with the two exchanged
/// returns  in [0.05, 0.85]
/// source   fitted to the reference renderer; docs/filtering.md
SCREE_FUNCTION Real scree_view_light_overlap(Real wox, Real woy, Real wix, Real wiy)
{
    return LIT(0.45) + LIT(0.4) * (wox * wix + woy * wiy);
}

/// Color of what is both seen and lit, from those of what is seen and of what is lit: both shifts
/// from the mean color, but where they agree in sign only part of the smaller one,
///
///   max(c + o + i - together overlap, 0),   o = c_view - c,  i = c_light - c,
///   overlap = the smaller of o and i where they have one sign, else 0
///
/// c         E[c];  c_view, c_light  of scree_color_by_visibility, >= 0
/// together  of scree_view_light_overlap
/// returns   >= 0, and the same with view and light exchanged; c_view where c_light is c, up to
///           rounding
/// source    chosen by measured error; docs/filtering.md
/// not modelled: what view and light hide together, other than by the angle between them
SCREE_FUNCTION Real scree_color_seen_and_lit(Real c, Real c_view, Real c_light, Real together)
{
    Real o = c_view - c;
    Real i = c_light - c;
    Real overlap = max(min(o, i), LIT(0.0)) + min(max(o, i), LIT(0.0));
    return max(c + ((o + i) - together * overlap), LIT(0.0));
}

// --- reflection ---------------------------------------------------------------------------------

/// Anisotropic Beckmann roughness of a covariance plus a base roughness.
///
/// base_alpha        of the facets themselves, isotropic Beckmann, >= 0
/// alpha_x, alpha_y  along the direction of most and of least spread, alpha_x >= alpha_y:
///                   alpha^2 = base_alpha^2 + 2 variance
/// angle_rad         from +s to the direction of most spread, towards +t, in (-pi/2, pi/2]; 0 where
///                   no direction stands out
/// source            alpha = sqrt(2) sigma: Heitz 2014; axes of a symmetric 2x2 matrix
SCREE_FUNCTION void scree_beckmann_roughness(Real css, Real cst, Real ctt, Real base_alpha,
                                             OUT(Real, alpha_x), OUT(Real, alpha_y),
                                             OUT(Real, angle_rad))
{
    Real difference = LIT(0.5) * (css - ctt);
    Real scale = max(max(abs(difference), abs(cst)), LIT(1.0e-30));
    Real d = difference / scale;
    Real o = cst / scale;
    Real most = LIT(0.5) * (css + ctt) + scale * sqrt(d * d + o * o);
    // The smaller one from the determinant: the difference would cancel.
    Real det = max(scree_product_difference(css, ctt, cst, cst), LIT(0.0));
    Real least = det / max(most, LIT(1.0e-30));
    Real base = base_alpha * base_alpha;
    alpha_x = sqrt(base + LIT(2.0) * max(most, LIT(0.0)));
    alpha_y = min(sqrt(base + LIT(2.0) * least), alpha_x);
    angle_rad = LIT(0.5) * scree_atan2(cst, difference);
}

/// Where a slope lies among slopes of that mean and covariance: distances from the mean along two
/// axes, in standard deviations, so that x^2 + y^2 = (slope - m)' C^-1 (slope - m).
///
/// css, cst, ctt  covariance with a determinant above 0; variances of 1e-9 and more
/// x, y           >= 0;  root_det  sqrt(det C), at least 1e-15
SCREE_FUNCTION void scree_slope_place(Real s, Real t, Real ms, Real mt, Real css, Real cst,
                                      Real ctt, OUT(Real, x), OUT(Real, y), OUT(Real, root_det))
{
    Real pivot = max(max(css, ctt), LIT(1.0e-15));
    Real first = css >= ctt ? s - ms : t - mt;
    Real second = css >= ctt ? t - mt : s - ms;
    root_det = sqrt(max(scree_product_difference(css, ctt, cst, cst), LIT(1.0e-30)));
    x = abs(first) / sqrt(pivot);
    Real cross = scree_product_difference(second, pivot, cst, first);
    y = abs(cross) / (sqrt(pivot) * root_det);
}

/// Density of Gaussian slopes at (s, t).
///
/// css, cst, ctt  covariance with a determinant above 0
/// returns        >= 0, finite for variances of 1e-9 and more
SCREE_FUNCTION Real scree_slope_pdf(Real s, Real t, Real ms, Real mt, Real css, Real cst, Real ctt)
{
    Real x, y, root_det;
    scree_slope_place(s, t, ms, mt, css, cst, ctt, x, y, root_det);
    // Nothing is left of the density a hundred deviations away.
    x = min(x, LIT(100.0));
    y = min(y, LIT(100.0));
    return LIT(0.159154943091895336) * scree_exp_minus(LIT(0.5) * (x * x + y * y)) / root_det;
}

/// Specular reflection of a footprint under a directional light: what multiplies Fresnel times the
/// irradiance on a plane facing the light, that is BRDF times cosine.
///
///   D(h) G2 / (4 a_o) = D(h) / (4 (N_o + a_o Lambda_i)),   D(h) = p(slope of h) / cos^4
///
/// with the base roughness added to the covariance throughout, so masking and lobe agree.
///
/// wo, wi      to viewer and light, above the texture plane: a light below it is the renderer's to
///             leave out
/// base_alpha  Beckmann roughness of the facets; below 1e-4 counts as 1e-4
/// returns     in [0, 1e30]; 0 where the mean plane faces away from the light. Where it faces away
///             from the viewer a_o counts as 0: the few facets that do face him reflect on, until
///             their area is below 1e-24
/// source      LEADR mapping (Dupuy et al. 2013), its non-centred Beckmann lobe; G2 as in scree_g2.
///             a_o, not the geometric cosine: the footprint's own mean plane is what is seen
SCREE_FUNCTION Real scree_specular(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                   Real ms, Real mt, Real css, Real cst, Real ctt, Real base_alpha)
{
    Real base = max(base_alpha, LIT(1.0e-4));
    Real rss = css + LIT(0.5) * base * base;
    Real rtt = ctt + LIT(0.5) * base * base;
    Real facing_o = max(scree_facing(wox, woy, woz, ms, mt), LIT(0.0));
    Real facing_i = scree_facing(wix, wiy, wiz, ms, mt);
    Real hx = wox + wix;
    Real hy = woy + wiy;
    Real hz = woz + wiz;
    Real result = LIT(0.0);
    if (facing_i > LIT(0.0) && hz > LIT(1.0e-6) * (abs(hx) + abs(hy))) {
        Real lambda_i = LIT(0.0);
        Real g1 = LIT(0.0);
        scree_masking(wix, wiy, wiz, ms, mt, rss, cst, rtt, LIT(0.0), lambda_i, g1);
        Real seen = scree_projected_area(wox, woy, woz, ms, mt, rss, cst, rtt, LIT(0.0));
        Real s = -hx / hz;
        Real t = -hy / hz;
        Real per_cos2 = LIT(1.0) + s * s + t * t;
        Real d = scree_slope_pdf(s, t, ms, mt, rss, cst, rtt) * (per_cos2 * per_cos2);
        Real share = LIT(4.0) * (seen + facing_o * lambda_i);
        result = share > LIT(1.0e-24) ? min(d / share, LIT(1.0e30)) : LIT(0.0);
    }
    return result;
}

/// E[(1 + |slope|^2)^(-1/2)] of Gaussian slopes: mean cosine between facets and the plane's normal.
///
/// A seven-point cubature, exact for polynomials of degree five: the middle, and six points at
/// two deviations.
/// source  Stroud 1971, E_n^{r^2} 5-1 for n = 2
SCREE_FUNCTION Real scree_mean_cosine(Real ms, Real mt, Real css, Real cst, Real ctt)
{
    // The symmetric root of C, (C + sqrt(det) I) / sqrt(trace + 2 sqrt(det)): any root would do,
    // but this one changes continuously with C.
    Real det = max(scree_product_difference(css, ctt, cst, cst), LIT(0.0));
    Real root_det = sqrt(det);
    Real scale = LIT(1.0) / sqrt(max(css + ctt + LIT(2.0) * root_det, LIT(1.0e-30)));
    Real rss = (css + root_det) * scale;
    Real rst = cst * scale;
    Real rtt = (ctt + root_det) * scale;
    Real sum = LIT(6.0) / sqrt(LIT(1.0) + ms * ms + mt * mt);
    for (int i = 0; i < 3; ++i) { // directions 0, 60 and 120 degrees, and their opposites
        Real x = i == 0 ? LIT(2.0) : (i == 1 ? LIT(1.0) : LIT(-1.0));
        Real y = i == 0 ? LIT(0.0) : LIT(1.73205080756887729);
        Real ds = rss * x + rst * y;
        Real dt = rst * x + rtt * y;
        Real ahead = (ms + ds) * (ms + ds) + (mt + dt) * (mt + dt);
        Real behind = (ms - ds) * (ms - ds) + (mt - dt) * (mt - dt);
        sum = sum + LIT(1.0) / sqrt(LIT(1.0) + ahead) + LIT(1.0) / sqrt(LIT(1.0) + behind);
    }
    return sum / LIT(12.0);
}

/// Diffuse reflection of a footprint under a directional light: what multiplies albedo / pi times
/// the irradiance on a plane facing the light.
///
///   G2 / G1_o E_vis[max(0, wi . n)],   n = (-s, -t, 1) / sqrt(1 + s^2 + t^2)
///
/// The visible slopes are taken as the Gaussian of their own mean and covariance. Weighting them
/// with the light's projected area is the same step as weighting with the viewer's, so
/// E_vis[...] = N_i of those slopes, times the mean cosine of the slopes seen and lit.
///
/// wo, wi   to viewer and light, above the texture plane
/// tau      weight of K0 for what the viewer sees
/// returns  in [0, 1]
/// error    absolute, angles to 85 degrees, sigma to 0.6: below 0.02 for tau 0, 0.05 for tau 1
///          [tests/kernel/reflection_test.cpp]; growing with sigma
/// source   the integral of LEADR mapping (Dupuy et al. 2013); closed form derived in
///          docs/filtering.md
/// not modelled: the Gaussian of the visible slopes is the viewer's, so view and light cannot
///          change places exactly
SCREE_FUNCTION Real scree_diffuse(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                  Real ms, Real mt, Real css, Real cst, Real ctt, Real tau)
{
    Real area, vs, vt, vss, vst, vtt;
    scree_visible_slopes(wox, woy, woz, ms, mt, css, cst, ctt, tau, area, vs, vt, vss, vst, vtt);
    Real lit, ls, lt, lss, lst, ltt;
    scree_visible_slopes(wix, wiy, wiz, vs, vt, vss, vst, vtt, LIT(0.0), lit, ls, lt, lss, lst,
                         ltt);
    Real lambda_o, lambda_i, g1;
    scree_masking(wox, woy, woz, ms, mt, css, cst, ctt, tau, lambda_o, g1);
    scree_masking(wix, wiy, wiz, ms, mt, css, cst, ctt, tau, lambda_i, g1);
    Real shadowing = (LIT(1.0) + lambda_o) * scree_g2(lambda_o, lambda_i);
    return min(shadowing * lit * scree_mean_cosine(ls, lt, lss, lst, ltt), LIT(1.0));
}

#endif
