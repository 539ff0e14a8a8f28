// Coordinates for BRDFs of a half and a back vector: half/difference, orthographic and hybrid, both
// ways. One source for C++, GLSL and OSL: include after scree_filter.h, whose preludes and rules
// hold here too. docs/brdf-parametrizations.md derives the formulas.
//
// wo, wi are unit vectors to viewer and light, z >= 0 out of the surface, and
//
//   h = (wi + wo) / 2,  k = (wi - wo) / 2     h . k = 0,  |h|^2 + |k|^2 = 1
//
// A bar is the part in the surface's plane; phi_h and phi_k are the azimuths of those parts. Not
// all coordinates are of two directions above the surface: |k_z| <= h_z must hold. Of given h_bar
// (or theta_h) and azimuths the k that do form an interval from 0; the functions named _reach have
// its end, where one of the two directions is at the horizon. Beyond it the inverses move what
// would be below the horizon up to it, so that they always give unit vectors with z >= 0.
//
// Angles are in radians, in (-pi, pi]. The azimuth of a vector that has none is 0.
//
// source  Barla, Belcour, Pacanowski 2015; half/difference: Rusinkiewicz 1998

#ifndef SCREE_BRDF_COORDINATES_H
#define SCREE_BRDF_COORDINATES_H

// --- half and back vector ------------------------------------------------------------------------

/// h and k of two directions, at right angles to each other as they are of exact unit vectors.
///
/// The directions' own rounding leaves h . k of 1e-16 (1e-7 in single precision), which would turn
/// the direction of the shorter one by that over its length.
SCREE_FUNCTION void scree_half_and_back(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                        OUT(Real, hx), OUT(Real, hy), OUT(Real, hz), OUT(Real, kx),
                                        OUT(Real, ky), OUT(Real, kz))
{
    hx = LIT(0.5) * (wix + wox);
    hy = LIT(0.5) * (wiy + woy);
    hz = LIT(0.5) * (wiz + woz);
    kx = LIT(0.5) * (wix - wox);
    ky = LIT(0.5) * (wiy - woy);
    kz = LIT(0.5) * (wiz - woz);
    Real dot = hx * kx + hy * ky + hz * kz;
    Real hh = hx * hx + hy * hy + hz * hz;
    Real kk = kx * kx + ky * ky + kz * kz;
    if (hh < kk) {
        Real share = dot / kk;
        hx = hx - share * kx;
        hy = hy - share * ky;
        // h_z as it is: |k_z| is not larger, so the change would be less than its rounding.
    } else {
        Real share = dot / hh;
        kx = kx - share * hx;
        ky = ky - share * hy;
        kz = kz - share * hz;
    }
}

/// Cosine and sine of the azimuth of (x, y), and its length; 1, 0 where that is 0.
SCREE_FUNCTION void scree_azimuth(Real x, Real y, OUT(Real, length), OUT(Real, cosine),
                                  OUT(Real, sine))
{
    length = sqrt(x * x + y * y);
    cosine = length > LIT(0.0) ? x / length : LIT(1.0);
    sine = length > LIT(0.0) ? y / length : LIT(0.0);
}

/// What the three systems have in common, of two directions.
///
/// h_bar, hz     |h_bar| in [0, 1], h_z
/// cos_h, sin_h  of phi_h
/// h_length      |h| = cos theta_d
/// k_length      |k| = sin theta_d
/// k_along       the part of k in the surface's plane, along phi_h; k_across, across it
/// d_along       the part of k along the meridian of h, down; across it is k_across again, so that
///               tan phi_d = k_across / d_along = cos theta_h tan(phi_k - phi_h)
SCREE_FUNCTION void scree_half_frame(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                     OUT(Real, h_bar), OUT(Real, hz), OUT(Real, cos_h),
                                     OUT(Real, sin_h), OUT(Real, h_length), OUT(Real, k_length),
                                     OUT(Real, k_along), OUT(Real, k_across), OUT(Real, d_along))
{
    Real hx, hy, kx, ky, kz;
    scree_half_and_back(wox, woy, woz, wix, wiy, wiz, hx, hy, hz, kx, ky, kz);
    scree_azimuth(hx, hy, h_bar, cos_h, sin_h);
    h_length = sqrt(hx * hx + hy * hy + hz * hz);
    k_length = sqrt(kx * kx + ky * ky + kz * kz);
    k_along = kx * cos_h + ky * sin_h;
    k_across = ky * cos_h - kx * sin_h;
    Real upright = h_length > LIT(0.0) ? hz / h_length : LIT(1.0);
    Real lying = h_length > LIT(0.0) ? h_bar / h_length : LIT(0.0);
    d_along = upright * k_along - lying * kz;
}

/// (x, y, max(z, 0)) made a unit vector; (1, 0, 0) of straight down.
SCREE_FUNCTION void scree_above_horizon(Real x, Real y, Real z, OUT(Real, wx), OUT(Real, wy),
                                        OUT(Real, wz))
{
    Real up = max(z, LIT(0.0));
    Real length = sqrt(x * x + y * y + up * up);
    Real scale = length > LIT(0.0) ? LIT(1.0) / length : LIT(0.0);
    wx = length > LIT(0.0) ? x * scale : LIT(1.0);
    wy = y * scale;
    wz = up * scale;
}

/// Two directions of h = (h_bar, 0, hz) and k = (along, across, kz) in the frame of phi_h.
SCREE_FUNCTION void scree_from_half_frame(Real h_bar, Real hz, Real phi_h, Real along, Real across,
                                          Real kz, OUT(Real, wox), OUT(Real, woy), OUT(Real, woz),
                                          OUT(Real, wix), OUT(Real, wiy), OUT(Real, wiz))
{
    Real sine, cosine;
    scree_sine_cosine(phi_h, sine, cosine);
    Real i = h_bar + along;
    Real o = h_bar - along;
    scree_above_horizon(i * cosine - across * sine, i * sine + across * cosine, hz + kz, wix, wiy,
                        wiz);
    scree_above_horizon(o * cosine + across * sine, o * sine - across * cosine, hz - kz, wox, woy,
                        woz);
}

// --- half/difference -----------------------------------------------------------------------------

/// theta_h  in [0, pi/2], of h from the normal;  phi_h  its azimuth
/// theta_d  in [0, pi/2], of wi from h;  phi_d  azimuth of wi about h, from the meridian of h down
///
/// phi_h is 0 where h is upright, phi_d where wi = wo.
/// source  Barla et al. 2015, section 2; Rusinkiewicz 1998
SCREE_FUNCTION void scree_to_half_difference(Real wox, Real woy, Real woz, Real wix, Real wiy,
                                             Real wiz, OUT(Real, theta_h), OUT(Real, phi_h),
                                             OUT(Real, theta_d), OUT(Real, phi_d))
{
    Real h_bar, hz, cos_h, sin_h, h_length, k_length, k_along, k_across, d_along;
    scree_half_frame(wox, woy, woz, wix, wiy, wiz, h_bar, hz, cos_h, sin_h, h_length, k_length,
                     k_along, k_across, d_along);
    theta_h = scree_atan2(h_bar, hz);
    phi_h = scree_atan2(sin_h, cos_h);
    theta_d = scree_atan2(k_length, h_length);
    phi_d = scree_atan2(k_across, d_along);
}

/// The largest theta_d of two directions above the surface: tan = 1 / (tan theta_h |cos phi_d|).
SCREE_FUNCTION Real scree_half_difference_reach(Real theta_h, Real phi_d)
{
    Real sin_h, cos_h, sin_d, cos_d;
    scree_sine_cosine(theta_h, sin_h, cos_h);
    scree_sine_cosine(phi_d, sin_d, cos_d);
    // k across h stays in the plane, h at the horizon too: pi/2, whatever cos(pi/2) is rounded to.
    Real along = abs(cos_d) > LIT(1.0e-7) ? sin_h * abs(cos_d) : LIT(0.0);
    return scree_atan2(max(cos_h, LIT(1.0e-30)), along);
}

/// Directions of half/difference coordinates, theta_h and theta_d in [0, pi/2].
///
/// error  absolute, a few roundings everywhere
/// source Barla et al. 2015, eq. 1 and 2; here wi = h + k and wo = h - k instead of two rotations
SCREE_FUNCTION void scree_from_half_difference(Real theta_h, Real phi_h, Real theta_d, Real phi_d,
                                               OUT(Real, wox), OUT(Real, woy), OUT(Real, woz),
                                               OUT(Real, wix), OUT(Real, wiy), OUT(Real, wiz))
{
    Real upright, lying, h_length, k_length, sine, cosine;
    scree_sine_cosine(theta_h, lying, upright);
    scree_sine_cosine(theta_d, k_length, h_length);
    scree_sine_cosine(phi_d, sine, cosine);
    Real down = k_length * cosine;
    scree_from_half_frame(h_length * lying, h_length * upright, phi_h, down * upright,
                          k_length * sine, -down * lying, wox, woy, woz, wix, wiy, wiz);
}

// --- orthographic --------------------------------------------------------------------------------

/// h_bar  |h_bar| in [0, 1];  phi_h  its azimuth
/// k_bar  |k_bar| in [0, 1];  phi_k  its azimuth
///
/// phi_h is 0 where h is upright, phi_k where wi = wo.
/// source  Barla et al. 2015, section 2; Neumann et al. 1999
SCREE_FUNCTION void scree_to_orthographic(Real wox, Real woy, Real wix, Real wiy, OUT(Real, h_bar),
                                          OUT(Real, phi_h), OUT(Real, k_bar), OUT(Real, phi_k))
{
    Real cosine, sine;
    scree_azimuth(LIT(0.5) * (wix + wox), LIT(0.5) * (wiy + woy), h_bar, cosine, sine);
    phi_h = scree_atan2(sine, cosine);
    scree_azimuth(LIT(0.5) * (wix - wox), LIT(0.5) * (wiy - woy), k_bar, cosine, sine);
    phi_k = scree_atan2(sine, cosine);
}

/// The largest |k_bar| of two directions above the surface, azimuth = phi_k - phi_h.
///
///   q - a,   a = |h_bar| |cos|,  q = sqrt(1 - |h_bar|^2 sin^2)
SCREE_FUNCTION Real scree_orthographic_reach(Real h_bar, Real azimuth)
{
    Real sine, cosine;
    scree_sine_cosine(azimuth, sine, cosine);
    Real h = min(h_bar, LIT(1.0));
    Real across = h * sine;
    Real q = sqrt(max((LIT(1.0) - across) * (LIT(1.0) + across), LIT(0.0)));
    // (q - a) (q + a) = 1 - h^2: as a quotient nothing cancels.
    return (LIT(1.0) - h) * (LIT(1.0) + h) / max(q + h * abs(cosine), LIT(1.0e-30));
}

/// Directions of orthographic coordinates.
///
/// error  of x and y a few roundings; of a small z rounding / z, for the lengths do not know more
/// source Barla et al. 2015, eq. 3 and 4
SCREE_FUNCTION void scree_from_orthographic(Real h_bar, Real phi_h, Real k_bar, Real phi_k,
                                            OUT(Real, wox), OUT(Real, woy), OUT(Real, woz),
                                            OUT(Real, wix), OUT(Real, wiy), OUT(Real, wiz))
{
    Real sine, cosine;
    scree_sine_cosine(phi_h, sine, cosine);
    Real hx = h_bar * cosine;
    Real hy = h_bar * sine;
    scree_sine_cosine(phi_k, sine, cosine);
    Real kx = k_bar * cosine;
    Real ky = k_bar * sine;
    Real iz = sqrt(max(LIT(1.0) - (hx + kx) * (hx + kx) - (hy + ky) * (hy + ky), LIT(0.0)));
    Real oz = sqrt(max(LIT(1.0) - (hx - kx) * (hx - kx) - (hy - ky) * (hy - ky), LIT(0.0)));
    scree_above_horizon(hx + kx, hy + ky, iz, wix, wiy, wiz);
    scree_above_horizon(hx - kx, hy - ky, oz, wox, woy, woz);
}

// --- hybrid --------------------------------------------------------------------------------------

/// h_bar  |h_bar| in [0, 1];  phi_h  its azimuth
/// k      |k| in [0, 1];  phi_k  azimuth of k
///
/// phi_h is 0 where h is upright, phi_k where wi = wo.
/// source  Barla et al. 2015, section 2; Stark et al. 2005
SCREE_FUNCTION void scree_to_hybrid(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                    OUT(Real, h_bar), OUT(Real, phi_h), OUT(Real, k),
                                    OUT(Real, phi_k))
{
    Real hx, hy, hz, kx, ky, kz, k_bar, cosine, sine;
    scree_half_and_back(wox, woy, woz, wix, wiy, wiz, hx, hy, hz, kx, ky, kz);
    scree_azimuth(hx, hy, h_bar, cosine, sine);
    phi_h = scree_atan2(sine, cosine);
    scree_azimuth(kx, ky, k_bar, cosine, sine);
    phi_k = scree_atan2(sine, cosine);
    k = sqrt(kx * kx + ky * ky + kz * kz);
}

/// The largest |k| of two directions above the surface, azimuth = phi_k - phi_h: sqrt(q (q - a)),
/// q and a as in scree_orthographic_reach.
SCREE_FUNCTION Real scree_hybrid_reach(Real h_bar, Real azimuth)
{
    Real sine, cosine;
    scree_sine_cosine(azimuth, sine, cosine);
    Real r = scree_orthographic_reach(h_bar, azimuth);
    return sqrt(r * (r + min(h_bar, LIT(1.0)) * abs(cosine)));
}

/// Directions of hybrid coordinates.
///
/// k is at right angles to h, so it is along (h_z cos, h_z sin, -|h_bar| cos(phi_k - phi_h)): no
/// angle theta_k, and nothing to divide by where h is upright or k across it.
///
/// error  rounding / h_z, so large only where both are at the horizon: the lengths know no more
/// source Barla et al. 2015, eq. 5 and 6, appendix
SCREE_FUNCTION void scree_from_hybrid(Real h_bar, Real phi_h, Real k, Real phi_k, OUT(Real, wox),
                                      OUT(Real, woy), OUT(Real, woz), OUT(Real, wix),
                                      OUT(Real, wiy), OUT(Real, wiz))
{
    Real sine, cosine;
    scree_sine_cosine(phi_k - phi_h, sine, cosine);
    Real hz = sqrt(max((LIT(1.0) - h_bar) * (LIT(1.0) + h_bar) - k * k, LIT(0.0)));
    Real down = h_bar * cosine;
    Real length = sqrt(hz * hz + down * down);
    // At the horizon rounding may leave h_z = 0, and the direction of k to chance: |k_z| <= h_z.
    Real kz = length > LIT(0.0) ? max(-hz, min(hz, -k * down / length)) : LIT(0.0);
    Real k_bar = sqrt(max((k - kz) * (k + kz), LIT(0.0)));
    scree_from_half_frame(h_bar, hz, phi_h, k_bar * cosine, k_bar * sine, kz, wox, woy, woz, wix,
                          wiy, wiz);
}

// --- isotropic reduction -------------------------------------------------------------------------

/// What is left of the coordinates where neither turning the surface, nor a mirror image, nor a
/// change of viewer and light makes a difference: phi_h dropped, the other azimuth, from phi_h,
/// folded to [0, pi/2].
///
/// theta_h, theta_d, phi_d   half/difference
/// h_bar, k_bar, k, azimuth  orthographic (h_bar, k_bar, azimuth) and hybrid (h_bar, k, azimuth)
SCREE_FUNCTION void scree_isotropic_coordinates(Real wox, Real woy, Real woz, Real wix, Real wiy,
                                                Real wiz, OUT(Real, theta_h), OUT(Real, theta_d),
                                                OUT(Real, phi_d), OUT(Real, h_bar),
                                                OUT(Real, k_bar), OUT(Real, k), OUT(Real, azimuth))
{
    Real hz, cos_h, sin_h, h_length, k_along, k_across, d_along;
    scree_half_frame(wox, woy, woz, wix, wiy, wiz, h_bar, hz, cos_h, sin_h, h_length, k, k_along,
                     k_across, d_along);
    theta_h = scree_atan2(h_bar, hz);
    theta_d = scree_atan2(k, h_length);
    phi_d = scree_atan2(abs(k_across), abs(d_along));
    k_bar = sqrt(k_along * k_along + k_across * k_across);
    azimuth = scree_atan2(abs(k_across), abs(k_along));
}

// --- lookups in tables ---------------------------------------------------------------------------

/// Where the table of `scree table brdf` with its own axes (hybrid, angle, fitted) has a pair of
/// directions.
///
/// x, y, z  in [0, 1]: x^2 and y times 90 degrees are the angles whose sines are |h_bar| and
///          |k| / reach, z times 90 degrees is the azimuth. First and last texel of an axis are 0
///          and 1, so n texels are looked up at (x (n - 1) + 1/2) / n.
SCREE_FUNCTION void scree_hybrid_place(Real wox, Real woy, Real woz, Real wix, Real wiy, Real wiz,
                                       OUT(Real, x), OUT(Real, y), OUT(Real, z))
{
    Real theta_h, theta_d, phi_d, h_bar, k_bar, k, azimuth;
    scree_isotropic_coordinates(wox, woy, woz, wix, wiy, wiz, theta_h, theta_d, phi_d, h_bar, k_bar,
                                k, azimuth);
    Real per_quarter = LIT(0.636619772367581343);
    Real h = min(h_bar, LIT(1.0));
    x = sqrt(per_quarter * scree_atan2(h, sqrt((LIT(1.0) - h) * (LIT(1.0) + h))));
    // At the far end of h nothing is left of k: any share is right.
    Real share = min(k / max(scree_hybrid_reach(h, azimuth), LIT(1.0e-12)), LIT(1.0));
    y = per_quarter * scree_atan2(share, sqrt((LIT(1.0) - share) * (LIT(1.0) + share)));
    z = min(per_quarter * azimuth, LIT(1.0));
}

#endif
