// Reflection of thin linear lights on filtered surfaces: one source for C++, GLSL and OSL, to be
// read after scree_filter.h, with the same prelude. docs/linear-lights.md derives the formulas.
//
// A linear light is a segment of width far below its distance. Seen from the point that is shaded
// it lies in a plane with normal w; (u, e, w) is an orthonormal frame with u along the projection
// of the viewer on that plane, so that
//
//   v = (sin theta_v, 0, cos theta_v)   the viewer, cos theta_v in [0, 1]
//   l = (cos phi, sin phi, 0)           a point of the light
//   n = (nu, ne, nw)                    the normal of the surface
//   alpha                               angle between n and the half vector of v and l
//
// The lobe is Ward's: exp(-tan^2 alpha / sigma^2), sigma^2 twice the variance of the slopes along
// each axis.

#ifndef SCREE_LINEAR_LIGHT_H
#define SCREE_LINEAR_LIGHT_H

/// The normal as the cone of half vectors sees it.
///
/// Half vectors of v and of all l in the plane with normal w lie on a cone, 2 (h.v) (h.w) = v.w
/// h.h. In the frame of a, b, the bisectors of v and +-w, and e it reads a^2 = b^2 + q e^2 with q =
/// cos theta_v. What follows depends on q and on na / radius and side alone.
///
/// sin_v, cos_v   of theta_v, cos_v >= 0
/// nu, ne, nw     a unit vector
/// ch, sh         cosine and sine of theta_v / 2
/// na, nb         of the normal along a and b; nb at least 1e-6 away from 0: there are two closest
///                half vectors there, and it is that of nb > 0
/// radius         sqrt(nb^2 + q ne^2): na of a normal on the cone
SCREE_FUNCTION void scree_linear_cone(Real sin_v, Real cos_v, Real nu, Real ne, Real nw,
                                      OUT(Real, ch), OUT(Real, sh), OUT(Real, na), OUT(Real, nb),
                                      OUT(Real, radius))
{
    ch = sqrt(LIT(0.5) * (LIT(1.0) + cos_v));
    sh = LIT(0.5) * sin_v / ch;
    na = nu * sh + nw * ch;
    nb = nu * ch - nw * sh;
    nb = nb < LIT(0.0) ? min(nb, LIT(-1.0e-6)) : max(nb, LIT(1.0e-6));
    radius = sqrt(nb * nb + cos_v * ne * ne);
}

/// Half vector closest to the normal, not normalised, by its component along e: y = stretch ne.
/// Whatever stretch, it lies on the cone.
SCREE_FUNCTION void scree_linear_half(Real stretch, Real cos_v, Real ne, Real ch, Real sh, Real nb,
                                      OUT(Real, hu), OUT(Real, he), OUT(Real, hw))
{
    he = stretch * ne;
    Real ha = sqrt(nb * nb + cos_v * he * he);
    hu = ha * sh + nb * ch;
    hw = ha * ch - nb * sh;
}

/// Stretch of that half vector: 2 / ((1 + q) + (1 - q) t), t the one root of the rising function
///
///   t sqrt(nb^2 + q ne^2 stretch(t)^2) = na,
///
/// 1 where n lies on the cone. Newton's steps start from na / radius, which is within O((t - 1)^2).
///
/// bb, ee   nb^2 and q ne^2
/// steps    4 leave 5e-5 + 1e-3 tan^2 alpha of that at worst; 8 are exact in double
/// returns  > 0; where all half vectors face away from the normal, any such number
/// source   derived in docs/linear-lights.md
SCREE_FUNCTION Real scree_linear_stretch(Real cos_v, Real na, Real bb, Real ee, int steps)
{
    Real sum = LIT(1.0) + cos_v;
    Real difference = LIT(1.0) - cos_v;
    Real t = max(na / sqrt(bb + ee), LIT(-0.98));
    for (int i = 0; i < steps; ++i) {
        Real c = LIT(2.0) / (sum + difference * t);
        Real cc = c * c;
        Real root = sqrt(bb + ee * cc);
        Real slope = (bb + LIT(0.5) * ee * cc * c * sum) / root;
        t = max(t - (t * root - na) / slope, LIT(-0.98));
    }
    return LIT(2.0) / (sum + difference * t);
}

/// What the Gaussian of a linear light is made of, at a half vector.
///
/// hu, he, hw  of scree_linear_half
/// phi    of the light's point with that half vector, in (-pi, pi]
/// k      per radian: speed, at phi, of the half vector on the tangent plane of the unit sphere at
///        n: 4 k^2 = (1 + tan^2 alpha) (1 + (cos theta_v / A)^2), A = 1 + sin theta_v cos phi
/// tan2   tan^2 alpha, at most 1e6; 1e6 where no half vector faces the normal's side
/// source Bruneton, Rama, specular surfaces, section 2.3; in closed form in docs/linear-lights.md
SCREE_FUNCTION void scree_linear_peak_at(Real sin_v, Real cos_v, Real nu, Real ne, Real nw, Real hu,
                                         Real he, Real hw, OUT(Real, phi), OUT(Real, k),
                                         OUT(Real, tan2))
{
    Real hh = hu * hu + he * he + hw * hw;
    Real hv = sin_v * hu + cos_v * hw;
    Real hn = nu * hu + ne * he + nw * hw;
    Real twice = LIT(2.0) * hv / hh;
    phi = scree_atan2(twice * he, twice * hu - sin_v);
    // By the cross product: 1 / cos^2 - 1 has no digits left at a small angle.
    Real cu = ne * hw - nw * he;
    Real ce = nw * hu - nu * hw;
    Real cw = nu * he - ne * hu;
    Real cross = cu * cu + ce * ce + cw * cw;
    tan2 = hn > LIT(0.0) ? min(cross / max(hn * hn, LIT(1.0e-30)), LIT(1.0e6)) : LIT(1.0e6);
    // With v in the plane (cos_v = 0) the light behind it, l = -v, has every half vector across v
    // at once: A is 0 there, k without bound.
    Real spread = max(cos_v, LIT(1.0e-6)) / max(twice * hv, LIT(1.0e-12));
    k = LIT(0.5) * sqrt((LIT(1.0) + tan2) * (LIT(1.0) + spread * spread));
}

/// The same at the half vector closest to the normal. Of two as close phi jumps from one to the
/// other, and nowhere else: where n, a and e lie in one plane, nb = 0, between the foci of the
/// cone.
///
/// steps  of scree_linear_stretch
SCREE_FUNCTION void scree_linear_peak(Real sin_v, Real cos_v, Real nu, Real ne, Real nw, int steps,
                                      OUT(Real, phi), OUT(Real, k), OUT(Real, tan2))
{
    Real ch, sh, na, nb, radius;
    scree_linear_cone(sin_v, cos_v, nu, ne, nw, ch, sh, na, nb, radius);
    Real stretch = scree_linear_stretch(cos_v, na, nb * nb, cos_v * ne * ne, steps);
    Real hu, he, hw;
    scree_linear_half(stretch, cos_v, ne, ch, sh, nb, hu, he, hw);
    scree_linear_peak_at(sin_v, cos_v, nu, ne, nw, hu, he, hw, phi, k, tan2);
}

// --- tables -------------------------------------------------------------------------------------

/// Texture coordinate of x in [0, 1] where the first texel's centre holds 0 and the last one's 1.
SCREE_FUNCTION Real scree_texel_centres(Real x, Real texels)
{
    return (min(max(x, LIT(0.0)), LIT(1.0)) * (texels - LIT(1.0)) + LIT(0.5)) / texels;
}

/// Texture coordinates in the table of `scree table linear-light` over angles: a lookup there,
/// linear in all three, gives (Phi, k, tan^2 alpha); of negative `ne` Phi has the other sign.
SCREE_FUNCTION void scree_linear_angle_coordinates(Real cos_v, Real nu, Real ne, Real nw,
                                                   Real views, Real normals, Real azimuths,
                                                   OUT(Real, x), OUT(Real, y), OUT(Real, z))
{
    x = scree_texel_centres(cos_v, views);
    y = scree_texel_centres(LIT(0.5) + LIT(0.5) * nw, normals);
    z = scree_texel_centres(scree_atan2(abs(ne), nu) * LIT(0.318309886183790672), azimuths);
}

/// Texture coordinates in the table over the cone, which holds the stretch: na / radius from -1
/// (the first texel) to infinity (the last) as (r + 1) / (r + 3), and |nb| / radius.
///
/// Folded by the cone's planes of symmetry: the jumps of Phi lie on a side of the table, and no
/// lookup blends across them.
SCREE_FUNCTION void scree_linear_cone_coordinates(Real cos_v, Real na, Real nb, Real radius,
                                                  Real views, Real ratios, Real sides, OUT(Real, x),
                                                  OUT(Real, y), OUT(Real, z))
{
    Real r = max(na / radius, LIT(-1.0));
    x = scree_texel_centres(cos_v, views);
    y = scree_texel_centres((r + LIT(1.0)) / (r + LIT(3.0)), ratios);
    z = scree_texel_centres(abs(nb) / radius, sides);
}

// --- the integral -------------------------------------------------------------------------------

/// erfc(x) for x >= 0, to 6e-6 relative; 0 where scree_exp_minus is. Constants: docs/fit_kernel.py.
SCREE_FUNCTION Real scree_erfc(Real x)
{
    Real c = min(x, LIT(90.0));
    Real t = LIT(1.0) / (LIT(1.0) + LIT(0.55) * c);
    Real p = LIT(0.09739193639073973);
    p = p * t - LIT(0.29774691881990256);
    p = p * t + LIT(0.17281540340235443);
    p = p * t + LIT(0.14079139174661387);
    p = p * t + LIT(0.26620821560404007);
    p = p * t + LIT(0.31023710591016124);
    p = p * t + LIT(0.3103028657659933);
    return scree_exp_minus(c * c) * (t * p);
}

/// Integral of exp(-x^2) from a to b >= a, to 5e-5 relative for |a|, |b| < 3, 5e-4 to 5.
///
/// Of two tails on one side and of short steps the error functions would cancel.
SCREE_FUNCTION Real scree_gaussian_step(Real a, Real b)
{
    Real step = b - a;
    Real m = LIT(0.5) * (a + b);
    Real whole = LIT(0.0);
    if (step < LIT(0.1)) {
        Real mm = min(m * m, LIT(8100.0));
        whole = step * scree_exp_minus(mm) *
                (LIT(1.0) + step * step * (LIT(2.0) * mm - LIT(1.0)) / LIT(12.0));
    } else {
        Real qa = scree_erfc(abs(a));
        Real qb = scree_erfc(abs(b));
        Real same_side = abs(qa - qb);
        Real both_sides = LIT(2.0) - (qa + qb);
        whole = LIT(0.886226925452758014) * (a < LIT(0.0) && b > LIT(0.0) ? both_sides : same_side);
    }
    return whole;
}

/// Integral of x exp(-x^2) over [a, b].
SCREE_FUNCTION Real scree_gaussian_moment(Real a, Real b)
{
    return LIT(0.5) *
           (scree_exp_minus(min(a * a, LIT(1.0e4))) - scree_exp_minus(min(b * b, LIT(1.0e4))));
}

/// x plus the multiple of 2 pi that brings it to [-pi, pi).
SCREE_FUNCTION Real scree_periodic_angle(Real x)
{
    return x - LIT(6.28318530717958648) * floor(x * LIT(0.159154943091895336) + LIT(0.5));
}

/// Integral of exp(-tan^2 alpha / sigma^2) over [first, last] by its Gaussian, repeated every turn.
///
/// An interval that reaches beyond phi + pi has two parts, the second about the next turn's peak.
/// (The source wraps both bounds and takes the absolute value of the difference, which is the
/// integral over the rest of the circle: where there should be nothing, the whole peak.)
///
/// first, last    radians, first <= last <= first + 2 pi
/// phi, k, tan2   of scree_linear_peak
/// sigma2         Ward's, > 0
/// centre         mean angle under the Gaussian within [first, last], of both parts where there are
///                two: where to take the other terms
/// error          against the integral, over configurations at random (docs/linear-lights.md): 1 %
///                of the rms at sigma2 = 0.002, 3.3 % at 0.02, 13 % at 0.3
/// source         Bruneton, Rama, specular surfaces, eq. "final"
SCREE_FUNCTION Real scree_linear_integral(Real first, Real last, Real phi, Real k, Real tan2,
                                          Real sigma2, OUT(Real, centre))
{
    Real pi = LIT(3.14159265358979324);
    Real turn = LIT(6.28318530717958648);
    Real scale = k / sqrt(sigma2);
    Real from = scree_periodic_angle(first - phi);
    Real to = from + (last - first);
    Real a = scale * from;
    Real b = scale * min(to, pi);
    Real step = scree_gaussian_step(a, b);
    Real moment = scree_gaussian_moment(a, b);
    // Nothing but the end that is nearest counts where the whole lobe is elsewhere.
    Real shift = min(max(LIT(0.0), a), b);
    if (to > pi) {
        Real c = -scale * pi;
        Real d = scale * (to - turn);
        Real next = scree_gaussian_step(c, d);
        moment += scree_gaussian_moment(c, d) + scale * turn * next;
        step += next;
        shift = turn - to < from ? scale * to : shift;
    }
    if (step > LIT(1.0e-12))
        shift = min(max(moment / step, a), scale * to);
    centre = first + (shift / scale - from);
    return scree_exp_minus(min(tan2 / sigma2, LIT(1.0e4))) * step / scale;
}

/// k with the bend of the curve of half vectors: (1 / 2) d^2 tan^2 alpha / d phi^2, where k of
/// scree_linear_peak takes the curve as a straight line.
///
/// vn, ln   cosines of viewer and light, at phi, with the normal
/// returns  k itself where the two are equal, in the mirror's direction; at least half of it: a
///          bend that flattens the peak altogether leaves no Gaussian
/// source   derived in docs/linear-lights.md
SCREE_FUNCTION Real scree_linear_curved_k(Real k, Real tan2, Real vn, Real ln)
{
    Real bend = (LIT(1.0) + tan2) * (vn - ln) / max(LIT(2.0) * (vn + ln), LIT(1.0e-6));
    return sqrt(max(k * k - bend, LIT(0.25) * k * k));
}

// --- a light and a surface ----------------------------------------------------------------------

/// Ward's sigma^2 of a baked footprint: twice the variance of its slopes per axis, the mean of both
/// axes, and the roughness of the facets themselves.
///
/// css, ctt     variances of the slope
/// base_alpha   isotropic Beckmann roughness of the facets, >= 0
/// returns      >= 1e-8: no Gaussian is narrower than that
/// not modelled anisotropy: Ward's lobe is isotropic, so of a brushed surface it is the mean
SCREE_FUNCTION Real scree_ward_sigma2(Real css, Real ctt, Real base_alpha)
{
    return max(base_alpha * base_alpha + max(css + ctt, LIT(0.0)), LIT(1.0e-8));
}

/// The part of a segment that is on the upper side of a plane through the origin.
///
/// from, to     heights of the two ends above the plane
/// begin, end   shares of the way, 0 <= begin <= end <= 1; 0 and 0 where nothing is above
SCREE_FUNCTION void scree_clip_segment(Real from, Real to, OUT(Real, begin), OUT(Real, end))
{
    begin = LIT(0.0);
    end = LIT(0.0);
    if (from > LIT(0.0) || to > LIT(0.0)) {
        begin = from < LIT(0.0) ? from / (from - to) : LIT(0.0);
        end = to < LIT(0.0) ? from / (from - to) : LIT(1.0);
    }
}

/// Frame and angles of a linear light, as all of the above takes them.
///
/// fx..fz, tx..tz  the two ends of the light, from the point that is shaded
/// nx..nz          unit normal of the surface: what is below its horizon is cut off
/// vx..vz          unit vector to the viewer
/// ux..wz          the frame: u along the projection of the viewer on the plane of light and point,
///                 w across with v . w >= 0, e = w x u. A viewer along w has no projection: there u
///                 is towards the light; in the plane itself, either side does.
/// first, last     the light's angles from u, last - first < pi; equal where nothing is to be seen:
///                 light below the horizon, on a line with the point, or of no length
/// distance        of the light's line from the point
SCREE_FUNCTION void scree_linear_frame(Real fx, Real fy, Real fz, Real tx, Real ty, Real tz,
                                       Real nx, Real ny, Real nz, Real vx, Real vy, Real vz,
                                       OUT(Real, ux), OUT(Real, uy), OUT(Real, uz), OUT(Real, ex),
                                       OUT(Real, ey), OUT(Real, ez), OUT(Real, wx), OUT(Real, wy),
                                       OUT(Real, wz), OUT(Real, first), OUT(Real, last),
                                       OUT(Real, distance))
{
    Real dx = tx - fx;
    Real dy = ty - fy;
    Real dz = tz - fz;
    wx = scree_product_difference(fy, dz, fz, dy);
    wy = scree_product_difference(fz, dx, fx, dz);
    wz = scree_product_difference(fx, dy, fy, dx);
    Real across = sqrt(wx * wx + wy * wy + wz * wz);
    Real length = sqrt(dx * dx + dy * dy + dz * dz);
    distance = across / max(length, LIT(1.0e-18));
    Real side = wx * vx + wy * vy + wz * vz < LIT(0.0) ? LIT(-1.0) : LIT(1.0);
    Real per_across = side / max(across, LIT(1.0e-18));
    wx *= per_across;
    wy *= per_across;
    wz *= per_across;

    Real begin = LIT(0.0);
    Real end = LIT(0.0);
    scree_clip_segment(fx * nx + fy * ny + fz * nz, tx * nx + ty * ny + tz * nz, begin, end);
    // The projection of the viewer, or what rounding leaves of it.
    Real vw = vx * wx + vy * wy + vz * wz;
    ux = vx - vw * wx;
    uy = vy - vw * wy;
    uz = vz - vw * wz;
    if (ux * ux + uy * uy + uz * uz < LIT(1.0e-10)) {
        ux = fx + LIT(0.5) * dx;
        uy = fy + LIT(0.5) * dy;
        uz = fz + LIT(0.5) * dz;
    }
    Real uw = ux * wx + uy * wy + uz * wz;
    ux -= uw * wx;
    uy -= uw * wy;
    uz -= uw * wz;
    Real per_u = LIT(1.0) / max(sqrt(ux * ux + uy * uy + uz * uz), LIT(1.0e-18));
    ux *= per_u;
    uy *= per_u;
    uz *= per_u;
    ex = wy * uz - wz * uy;
    ey = wz * ux - wx * uz;
    ez = wx * uy - wy * ux;

    Real fu = fx * ux + fy * uy + fz * uz;
    Real fe = fx * ex + fy * ey + fz * ez;
    Real du = dx * ux + dy * uy + dz * uz;
    Real de = dx * ex + dy * ey + dz * ez;
    Real bu = fu + begin * du;
    Real be = fe + begin * de;
    Real cu = fu + end * du;
    Real ce = fe + end * de;
    // Between the two ends by their cross product: a difference of two angles loses short lights.
    Real width = scree_atan2((end - begin) * distance * length, bu * cu + be * ce);
    first = LIT(0.0);
    last = LIT(0.0);
    if (end > begin && across > LIT(1.0e-12) * length * length) {
        // Seen from the side of w it runs from one end or from the other.
        first = side > LIT(0.0) ? scree_atan2(be, bu) : scree_atan2(ce, cu);
        last = first + width;
    }
}

/// What stands before the exponential and goes with the angle: sqrt(l.n / v.n) (-l.n_s).
///
/// vn       cosine of the viewer and the normal, > 0
/// nu, ne   of the normal in the frame, su, se of the light's own
/// returns  >= 0; 0 where the light is below the horizon or seen from behind
SCREE_FUNCTION Real scree_linear_terms(Real phi, Real vn, Real nu, Real ne, Real su, Real se)
{
    Real sine, cosine;
    scree_sine_cosine(phi, sine, cosine);
    Real ln = max(cosine * nu + sine * ne, LIT(0.0));
    return sqrt(ln / max(vn, LIT(1.0e-6))) * max(-(cosine * su + sine * se), LIT(0.0));
}

/// Radiance that a thin linear light reflects to the viewer, per its own radiance and width: by the
/// Gaussian about the half vector closest to the normal.
///
/// Beyond the source: k with the bend of the curve, the terms before the exponential at the mean
/// angle under the Gaussian instead of the middle of the light, with their square root.
///
/// sin_v .. ne, nw      viewer and normal in the frame, as scree_linear_frame makes it
/// su, se               the light's own normal in the frame
/// first, last          of scree_linear_frame
/// distance             likewise
/// phi, k, tan2         of scree_linear_peak, or looked up
/// sigma2               scree_ward_sigma2
/// returns  per unit of radiance and of width; times Fresnel, transmittance and visibility
/// error    of the rms: 0.5 % at sigma2 = 0.002, 3.5 % at 0.02, 26 % at 0.3
///          [tests/kernel/linear_light_test.cpp, docs/linear-lights.md]
SCREE_FUNCTION Real scree_linear_reflection(Real sin_v, Real cos_v, Real nu, Real ne, Real nw,
                                            Real su, Real se, Real first, Real last, Real distance,
                                            Real phi, Real k, Real tan2, Real sigma2)
{
    Real result = LIT(0.0);
    Real vn = sin_v * nu + cos_v * nw;
    if (last > first && vn > LIT(0.0)) {
        Real sine, cosine;
        scree_sine_cosine(phi, sine, cosine);
        Real curved = scree_linear_curved_k(k, tan2, vn, cosine * nu + sine * ne);
        Real centre = LIT(0.0);
        Real lobe = scree_linear_integral(first, last, phi, curved, tan2, sigma2, centre);
        result = lobe * scree_linear_terms(centre, vn, nu, ne, su, se) /
                 (LIT(12.5663706143591730) * sigma2 * max(distance, LIT(1.0e-18)));
    }
    return result;
}

/// The integrand over phi: exp(-tan^2 alpha / sigma^2) and the terms before it.
SCREE_FUNCTION Real scree_linear_integrand(Real phi, Real sin_v, Real cos_v, Real nu, Real ne,
                                           Real nw, Real su, Real se, Real sigma2)
{
    Real sine, cosine;
    scree_sine_cosine(phi, sine, cosine);
    Real hu = cosine + sin_v;
    Real vn = sin_v * nu + cos_v * nw;
    Real ln = cosine * nu + sine * ne;
    Real hn = ln + vn;
    Real cu = ne * cos_v - nw * sine;
    Real ce = nw * hu - nu * cos_v;
    Real cw = nu * sine - ne * hu;
    Real tan2 = (cu * cu + ce * ce + cw * cw) / max(hn * hn, LIT(1.0e-12));
    Real facing = max(-(cosine * su + sine * se), LIT(0.0));
    return sqrt(max(ln, LIT(0.0)) / max(vn, LIT(1.0e-6))) * facing *
           scree_exp_minus(min(tan2 / sigma2, LIT(1.0e4)));
}

/// The same radiance as scree_linear_reflection by a quadrature of a few points about the peak: for
/// surfaces too rough for the Gaussian.
///
/// Gauss's four points in each of equal panels, over the part of the light within 3 sigma / k +
/// 4 sigma^2 (1 + 2 tan^2 alpha) of the peak, or of the light's end nearest to it: the second term
/// reaches the whole light where the lobe is no Gaussian any more, and where the peak that was
/// found is not the only one.
///
/// panels   a whole number, 1 or more; 4 points a panel. 2 leave 0.5 % of the rms at any sigma2 up
///          to 0.3, 3 leave 0.05 % [tests/kernel/linear_light_test.cpp]
SCREE_FUNCTION Real scree_linear_quadrature(Real sin_v, Real cos_v, Real nu, Real ne, Real nw,
                                            Real su, Real se, Real first, Real last, Real distance,
                                            Real phi, Real k, Real tan2, Real sigma2, Real panels)
{
    Real sum = LIT(0.0);
    Real vn = sin_v * nu + cos_v * nw;
    if (last > first && vn > LIT(0.0)) {
        Real middle = LIT(0.5) * (first + last);
        Real nearest = middle + scree_periodic_angle(phi - middle);
        Real at = min(max(nearest, first), last);
        Real sine, cosine;
        scree_sine_cosine(phi, sine, cosine);
        Real curved = scree_linear_curved_k(k, tan2, vn, cosine * nu + sine * ne);
        Real reach =
            LIT(3.0) * sqrt(sigma2) / curved + LIT(4.0) * sigma2 * (LIT(1.0) + LIT(2.0) * tan2);
        Real low = max(first, at - reach);
        Real high = min(last, at + reach);
        Real half_panel = LIT(0.5) * (high - low) / panels;
        Real inner = LIT(0.339981043584856265) * half_panel;
        Real outer = LIT(0.861136311594052575) * half_panel;
        Real panel = LIT(0.0);
        while (panel < panels) {
            Real m = low + half_panel * (LIT(2.0) * panel + LIT(1.0));
            sum += LIT(0.652145154862546143) *
                   (scree_linear_integrand(m - inner, sin_v, cos_v, nu, ne, nw, su, se, sigma2) +
                    scree_linear_integrand(m + inner, sin_v, cos_v, nu, ne, nw, su, se, sigma2));
            sum += LIT(0.347854845137453857) *
                   (scree_linear_integrand(m - outer, sin_v, cos_v, nu, ne, nw, su, se, sigma2) +
                    scree_linear_integrand(m + outer, sin_v, cos_v, nu, ne, nw, su, se, sigma2));
            panel += LIT(1.0);
        }
        sum *= half_panel / (LIT(12.5663706143591730) * sigma2 * max(distance, LIT(1.0e-18)));
    }
    return sum;
}

#endif
