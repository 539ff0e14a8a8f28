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

/// Half vector, not normalised, that comes closest to the normal.
///
/// Half vectors of v and of all l in the plane with normal w lie on a cone, 2 (h.v) (h.w) = v.w
/// h.h. In the frame of a, b, the bisectors of v and +-w, and e it reads a^2 = b^2 + q e^2, q = cos
/// theta_v. The ray closest to n is then (sqrt(n_b^2 + q y^2), n_b, y) with y = c n_e, c = 2 / ((1
/// + q) + (1 - q) t), where t is the one root of the rising function
///
///   T(t) = t sqrt(n_b^2 + q n_e^2 c^2) = n_a,
///
/// 1 where n lies on the cone. Newton's steps start from n_a / sqrt(n_b^2 + q n_e^2), which is
/// within O((t - 1)^2) there; whatever t, the result lies on the cone. Of two rays as close, n_b =
/// 0, it is that of n_b > 0: there and only there it jumps.
///
/// sin_v, cos_v    of theta_v, cos_v >= 0
/// nu, ne, nw      a unit vector
/// steps           of Newton; 4 leave 4e-5 of tan^2 alpha, 5 are exact in single precision
/// hu, he, hw      h . n > 0 unless no l has n.h > 0; then any vector that is not 0
/// source          derived in docs/linear-lights.md
SCREE_FUNCTION void scree_linear_half(Real sin_v, Real cos_v, Real nu, Real ne, Real nw, int steps,
                                      OUT(Real, hu), OUT(Real, he), OUT(Real, hw))
{
    Real ch = sqrt(LIT(0.5) * (LIT(1.0) + cos_v)); // of theta_v / 2
    Real sh = LIT(0.5) * sin_v / ch;
    Real na = nu * sh + nw * ch;
    Real nb = nu * ch - nw * sh;
    nb = nb < LIT(0.0) ? min(nb, LIT(-1.0e-6)) : max(nb, LIT(1.0e-6));
    Real bb = nb * nb;
    Real ee = cos_v * ne * ne;
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
    Real y = ne * LIT(2.0) / (sum + difference * t);
    Real a = sqrt(bb + cos_v * y * y);
    hu = a * sh + nb * ch;
    he = y;
    hw = a * ch - nb * sh;
}

/// What the Gaussian of a linear light is made of, at the half vector closest to the normal.
///
/// phi    of the light's point with that half vector, in (-pi, pi]
/// k      per radian: speed, at phi, of the half vector on the tangent plane of the unit sphere at
///        n: 4 k^2 = (1 + tan^2 alpha) (1 + (cos theta_v / A)^2), A = 1 + sin theta_v cos phi
/// tan2   tan^2 alpha, at most 1e6; 1e6 where no half vector faces the normal's side
/// source Bruneton, Rama, specular surfaces, section 2.3; in closed form in docs/linear-lights.md
SCREE_FUNCTION void scree_linear_peak(Real sin_v, Real cos_v, Real nu, Real ne, Real nw, int steps,
                                      OUT(Real, phi), OUT(Real, k), OUT(Real, tan2))
{
    Real hu, he, hw;
    scree_linear_half(sin_v, cos_v, nu, ne, nw, steps, hu, he, hw);
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

#endif
