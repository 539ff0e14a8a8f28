#include "kernel/linear_light_oracle.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

namespace scree::test {

namespace {

using Imath::V3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kTolerance = 1e-10;

/// In pieces, so that no narrow lobe falls between the first points.
template <class F>
double integrate(const F& f, double first, double last)
{
    constexpr int kPieces = 24;
    double sum = 0;
    for (int i = 0; i < kPieces; ++i)
        sum += boost::math::quadrature::gauss_kronrod<double, 21>::integrate(
            f, first + (last - first) * i / kPieces, first + (last - first) * (i + 1) / kPieces, 6,
            kTolerance);
    return sum;
}

V3d light_direction(const LinearAngles& angles, double phi)
{
    return angles.u * std::cos(phi) + angles.e * std::sin(phi);
}

double periodic_difference(double a, double b) { return std::remainder(a - b, 2 * kPi); }

double angle_about(const LinearAngles& angles, const V3d& p)
{
    return std::atan2(p.dot(angles.e), p.dot(angles.u));
}

/// The light's ends where it is above the horizon; false where it is not.
bool clip(const V3d& normal, V3d& from, V3d& to)
{
    const double a = from.dot(normal), b = to.dot(normal);
    if (a <= 0 && b <= 0)
        return false;
    const V3d crossing = from + (to - from) * (a / (a - b));
    if (a <= 0)
        from = crossing;
    if (b <= 0)
        to = crossing;
    return true;
}

} // namespace

LinearAngles angles_of(const LinearScene& scene)
{
    LinearAngles out;
    V3d from = scene.from, to = scene.to;
    const V3d across = from.cross(to);
    out.distance = across.length() / (to - from).length();
    out.w = across.normalized();
    if (out.w.dot(scene.viewer) < 0)
        out.w = -out.w;
    out.u = (scene.viewer - out.w * out.w.dot(scene.viewer)).normalized();
    out.e = out.w.cross(out.u);
    out.centre = angle_about(out, 0.5 * (from + to));
    if (!clip(scene.normal, from, to) || -from.dot(scene.light_normal) <= 0)
        return out;
    const double a = angle_about(out, from);
    const double turn = periodic_difference(angle_about(out, to), a);
    out.first = std::min(a, a + turn);
    out.last = std::max(a, a + turn);
    return out;
}

double tan2_at(const LinearScene& scene, const LinearAngles& angles, double phi)
{
    const V3d half = light_direction(angles, phi) + scene.viewer;
    const double up = half.dot(scene.normal);
    const V3d across = half.cross(scene.normal);
    return up > 0 ? across.dot(across) / (up * up) : std::numeric_limits<double>::infinity();
}

ScannedPeak scanned_peak(const LinearScene& scene, const LinearAngles& angles)
{
    constexpr int kSamples = 720;
    constexpr double kStep = 2 * kPi / kSamples, kGolden = 0.6180339887498949;
    double best = 0;
    for (int i = 0; i < kSamples; ++i)
        if (tan2_at(scene, angles, i * kStep) < tan2_at(scene, angles, best))
            best = i * kStep;
    double low = best - kStep, high = best + kStep;
    while (high - low > 1e-9) {
        const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
        (tan2_at(scene, angles, a) < tan2_at(scene, angles, b) ? high : low) =
            tan2_at(scene, angles, a) < tan2_at(scene, angles, b) ? b : a;
    }
    const double phi = 0.5 * (low + high);
    auto on_plane = [&](double x) {
        const V3d half = light_direction(angles, x) + scene.viewer;
        return half / half.dot(scene.normal);
    };
    constexpr double kSmall = 1e-5;
    return {phi, (on_plane(phi + kSmall) - on_plane(phi - kSmall)).length() / (2 * kSmall),
            tan2_at(scene, angles, phi)};
}

double reflected_exactly(const LinearScene& scene)
{
    const LinearAngles angles = angles_of(scene);
    if (angles.first == angles.last || scene.viewer.dot(scene.normal) <= 0)
        return 0;
    const V3d along = (scene.to - scene.from).normalized();
    const V3d foot = scene.from - along * scene.from.dot(along);
    auto integrand = [&](double x) {
        const V3d to_light = foot + along * x;
        const double length2 = to_light.dot(to_light);
        const V3d l = to_light / std::sqrt(length2);
        const V3d half = l + scene.viewer;
        const double up = half.dot(scene.normal), cosine = l.dot(scene.normal);
        if (up <= 0 || cosine <= 0)
            return 0.0;
        const double tan2 = half.dot(half) / (up * up) - 1;
        return std::sqrt(cosine / scene.viewer.dot(scene.normal)) * std::exp(-tan2 / scene.sigma2) *
               -l.dot(scene.light_normal) / length2;
    };
    // In steps of equal angle about the point, from x = d tan(beta).
    const V3d ends[2] = {light_direction(angles, angles.first),
                         light_direction(angles, angles.last)};
    const double a = std::atan2(ends[0].dot(along), ends[0].dot(foot) / foot.length());
    const double b = std::atan2(ends[1].dot(along), ends[1].dot(foot) / foot.length());
    constexpr int kPieces = 24;
    double sum = 0;
    for (int i = 0; i < kPieces; ++i)
        sum += boost::math::quadrature::gauss_kronrod<double, 21>::integrate(
            integrand, foot.length() * std::tan(std::min(a, b) + std::abs(b - a) * i / kPieces),
            foot.length() * std::tan(std::min(a, b) + std::abs(b - a) * (i + 1) / kPieces), 6,
            kTolerance);
    return sum / (4 * kPi * scene.sigma2);
}

double lobe_integral(const LinearScene& scene, const LinearAngles& angles)
{
    if (angles.first == angles.last)
        return 0;
    return integrate(
        [&](double phi) { return std::exp(-tan2_at(scene, angles, phi) / scene.sigma2); },
        angles.first, angles.last);
}

double constant_terms(const LinearScene& scene, const LinearAngles& angles, double phi,
                      bool with_root)
{
    const double middle = 0.5 * (angles.first + angles.last);
    const double reach = 0.5 * (angles.last - angles.first);
    const double inside = middle + std::clamp(periodic_difference(phi, middle), -reach, reach);
    const V3d l = light_direction(angles, inside);
    const double root =
        std::sqrt(std::max(l.dot(scene.normal), 0.0) / scene.viewer.dot(scene.normal));
    return (with_root ? root : 1) * -l.dot(scene.light_normal) /
           (4 * kPi * scene.sigma2 * angles.distance);
}

double gaussian_integral(const LinearAngles& angles, const ScannedPeak& peak, double sigma2)
{
    const double scale = peak.k / std::sqrt(sigma2);
    auto between = [&](double a, double b) {
        // Tails by erfc: erf has no digits there.
        const double sign = a + b < 0 ? -1 : 1;
        const double low = sign < 0 ? -b : a, high = sign < 0 ? -a : b;
        return std::sqrt(kPi) / (2 * scale) * (std::erfc(scale * low) - std::erfc(scale * high));
    };
    const double a = periodic_difference(angles.first, peak.phi);
    const double b = a + (angles.last - angles.first);
    const double both = b > kPi ? between(a, kPi) + between(-kPi, b - 2 * kPi) : between(a, b);
    return std::exp(-peak.tan2 / sigma2) * both;
}

LinearScene random_scene(std::mt19937& random, double sigma2, double lowest_cosine)
{
    std::uniform_real_distribution<double> unit(0, 1);
    auto direction = [&](double lowest) {
        const double z = lowest + (1 - lowest) * unit(random), turn = 2 * kPi * unit(random);
        const double r = std::sqrt(1 - z * z);
        return V3d(r * std::cos(turn), r * std::sin(turn), z);
    };
    LinearScene scene;
    scene.sigma2 = sigma2;
    scene.normal = V3d(0, 0, 1);
    scene.viewer = direction(lowest_cosine);
    const V3d centre = direction(0);
    const V3d side =
        centre.cross(std::abs(centre.z) < 0.9 ? V3d(0, 0, 1) : V3d(1, 0, 0)).normalized();
    const V3d other = centre.cross(side);
    const double turn = 2 * kPi * unit(random), half = 0.1 * std::pow(100.0, unit(random));
    const V3d along = side * std::cos(turn) + other * std::sin(turn);
    const double tilt = (2 * unit(random) - 1) * kPi / 3;
    scene.from = centre - along * half;
    scene.to = centre + along * half;
    scene.light_normal = -centre * std::cos(tilt) + centre.cross(along) * std::sin(tilt);
    return scene;
}

} // namespace scree::test
