#pragma once

#include <Imath/ImathVec.h>

#include <random>

namespace scree::test {

/// A thin linear light and a point that reflects it, as the light sees the point at the origin:
/// lengths in any unit, directions unit vectors.
struct LinearScene {
    Imath::V3d from, to;     ///< the ends of the light
    Imath::V3d light_normal; ///< across the light: it sends to this side alone
    Imath::V3d normal, viewer;
    double sigma2 = 0.02; ///< Ward's
};

/// The part of a light that a surface sees, over the angle phi about the point, from the projection
/// of the viewer on the plane of light and point; first < last < first + pi. Empty: first == last.
struct LinearAngles {
    Imath::V3d u, e, w; ///< the frame, viewer . w >= 0
    double first = 0, last = 0;
    double centre = 0;   ///< of the middle of the whole light
    double distance = 1; ///< of the light's line
};

/// By plain vector algebra, in double.
LinearAngles angles_of(const LinearScene& scene);

/// tan^2 of the angle between normal and half vector at phi; infinite where that faces away.
double tan2_at(const LinearScene& scene, const LinearAngles& angles, double phi);

/// The angle of the smallest tan^2 over the whole circle (by scanning, then golden section), its
/// tan^2 and the source's k there (by differences).
struct ScannedPeak {
    double phi = 0, k = 0, tan2 = 0;
};
ScannedPeak scanned_peak(const LinearScene& scene, const LinearAngles& angles);

// What is reflected of a light of radiance 1 and width 1, with F = t = V = 1, by adaptive
// quadrature to 1e-9, and what each step of the source's section 2 makes of it.

/// Over the abscissa along the light, the integral that the source starts from (its eq. "exact").
double reflected_exactly(const LinearScene& scene);

/// Integral of exp(-tan^2 alpha / sigma^2) over phi (its W).
double lobe_integral(const LinearScene& scene, const LinearAngles& angles);

/// The terms before the exponential taken out at phi, as constants; of phi beyond the light at its
/// nearest end. with_root: with the square root of the cosines.
double constant_terms(const LinearScene& scene, const LinearAngles& angles, double phi,
                      bool with_root);

/// The source's Gaussian for W (its eq. "final"), exact error functions, periodic as it should be.
double gaussian_integral(const LinearAngles& angles, const ScannedPeak& peak, double sigma2);

/// Configurations at random: normal (0, 0, 1), viewer uniform over the hemisphere above
/// `lowest_cosine`, a light of length 0.2 to 20 at a distance 1 from the point in a uniform
/// direction above the surface, at a uniform angle in the plane across, facing the point within 60
/// degrees; clipped by the surface's horizon.
LinearScene random_scene(std::mt19937& random, double sigma2, double lowest_cosine);

} // namespace scree::test
