#pragma once

namespace scree::test {

/// The published way to the visible slopes of Gaussian slopes, written anew from the equations of
/// Heitz et al. 2013 (supplement to Filtering Color Mapped Textures and Surfaces, sections 3 to 5):
/// rotation into the frame of the view, nine integrals, moments less squares of means, rotation
/// back. A slow twin that shows what it does well and where it fails; nothing in src/ uses it.

/// Line 36 of the printed pseudocode (eq. 68) lacks the factor E1 of its first term, and with it
/// the sign of its square; mended it is what eq. 68 says.
enum class Form { as_printed, mended };

/// Normal slopes in the frame of the view: o along its azimuth, p (perp) across.
struct ViewFrame {
    double mean_o, mean_p, var_o, cov, var_p, cot_theta;
};

/// Eq. 30 to 38: integrals of s_o^i s_p^j p_s over the facing half plane s_o < cot theta.
struct NineIntegrals {
    double one, o, p, oo, op, pp, ooo, oop, opp;
};

/// Eq. 61 to 69, with E1 = +sigma_o^2 p(cot theta).
NineIntegrals nine_integrals(const ViewFrame& frame, Form form);

struct PublishedResult {
    double area, s, t, ss, st, tt; ///< N, mean and covariance of the visible slopes
};

/// mean_s .. ctt of the surface, direction theta, phi of the view.
PublishedResult published_visible_slopes(double mean_s, double mean_t, double css, double cst,
                                         double ctt, double theta, double phi, Form form);

} // namespace scree::test
