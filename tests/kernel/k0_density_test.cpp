// K0 slopes: density, pixel averages, projected area and masking, against their definitions by
// quadrature with Boost's Bessel functions.

#include <gtest/gtest.h>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>
#include <vector>

#include "kernel/k0.h"

namespace scree::filter {

std::ostream& operator<<(std::ostream& out, const Slopes<double>& slopes)
{
    const auto& [ss, st, tt] = slopes.covariance;
    return out << "mean " << slopes.mean << " covariance " << ss << ' ' << st << ' ' << tt;
}

} // namespace scree::filter

namespace scree::test {
namespace {

using boost::math::cyl_bessel_k;
using filter::Slopes;
using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;

const double kPi = std::acos(-1.0);

/// The constants of the kernel's Bessel functions hold 3e-8 in double.
constexpr double kFit = 3e-8;

/// Isotropic, anisotropic, correlated; mean 0, tilted, steep.
std::vector<Slopes<double>> laws()
{
    std::vector<Slopes<double>> all;
    for (const Vec2& mean : {Vec2(0, 0), Vec2(0.3, -0.2), Vec2(1.5, 0.7)}) {
        all.push_back({mean, {0.09, 0, 0.09}, 1});
        all.push_back({mean, {0.25, 0.05, 0.04}, 1});
        all.push_back({mean, {0.02, -0.03, 0.06}, 1});
    }
    return all;
}

Vec3 toward(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Views from straight above to grazing and on below the texture plane.
std::vector<Vec3> views()
{
    std::vector<Vec3> all = {{0, 0, 1}};
    for (const double theta : {0.3, 1.0, 1.4, 1.55, kPi / 2, 1.7, 2.2, 3.0})
        for (const double phi : {0.4, 2.1, -1.7})
            all.push_back(toward(theta, phi));
    return all;
}

double determinant(const Slopes<double>& law)
{
    const auto& [ss, st, tt] = law.covariance;
    return ss * tt - st * st;
}

/// (slope - m)' C^-1 (slope - m)
double distance_squared(const Vec2& slope, const Slopes<double>& law)
{
    const auto& [ss, st, tt] = law.covariance;
    const Vec2 p = slope - law.mean;
    return (tt * p.x * p.x - 2 * st * p.x * p.y + ss * p.y * p.y) / determinant(law);
}

/// Integral over a finite interval, with or without singularities at its ends.
template <typename F>
double over_interval(const F& f, double from, double to, double tolerance)
{
    // Boost 1.74 asserts that no abscissa rounds to an end, but not on (-1, 1).
    const double middle = (from + to) / 2, half = (to - from) / 2;
    boost::math::quadrature::tanh_sinh<double> rule;
    return half * rule.integrate([&](double u) { return f(middle + half * u); }, tolerance);
}

/// Integral of f over all slopes, in polar coordinates about the mean, where the density is
/// infinite.
template <typename F>
double over_slopes(const Slopes<double>& law, const F& f)
{
    boost::math::quadrature::exp_sinh<double> rule;
    const int rays = 256; // smooth and periodic: the error falls exponentially
    double sum = 0;
    for (int i = 0; i < rays; ++i) {
        const double phi = 2 * kPi * (i + 0.5) / rays;
        const Vec2 ray(std::cos(phi), std::sin(phi));
        const auto along = [&](double r) {
            const double value = r * f(law.mean + ray * r);
            return std::isfinite(value) ? value : 0;
        };
        sum += rule.integrate(along, 0.0, std::numeric_limits<double>::infinity(), 1e-9);
    }
    return sum * 2 * kPi / rays;
}

TEST(K0Density, IsTheExponentialMixtureOfGaussians)
{
    boost::math::quadrature::exp_sinh<double> over;
    for (const auto& law : laws())
        for (const double d : {1e-3, 0.1, 0.7, 2.0, 6.0, 15.0}) {
            const double sigma = std::sqrt(law.covariance.ss);
            const Vec2 slope =
                law.mean + Vec2(sigma, law.covariance.st / sigma) * d; // d deviations away
            const double dd = distance_squared(slope, law);
            ASSERT_NEAR(dd, d * d, 1e-9 * d * d);
            // e = exp(x), for the width of the integrand does not change then
            const auto mixed = [&](double x) {
                return std::exp(-std::exp(x) - dd / (2 * std::exp(x)));
            };
            const double inf = std::numeric_limits<double>::infinity();
            const double want = (over.integrate([&](double x) { return mixed(x); }, 0.0, inf) +
                                 over.integrate([&](double x) { return mixed(-x); }, 0.0, inf)) /
                                (2 * kPi * std::sqrt(determinant(law)));
            EXPECT_NEAR(k0::slope_pdf(slope, law) / want, 1, kFit + 1e-8 * d) << law << " d " << d;
        }
}

TEST(K0Density, IntegratesToOneAndHasTheMeanAndCovarianceAsked)
{
    for (const auto& law : laws()) {
        const auto moment = [&](auto of) {
            return over_slopes(
                law, [&](const Vec2& p) { return of(p - law.mean) * k0::slope_pdf(p, law); });
        };
        const auto& [ss, st, tt] = law.covariance;
        // 1e-7: the fit, and what the distances lose far out
        EXPECT_NEAR(moment([](const Vec2&) { return 1.0; }), 1, 1e-7) << law;
        EXPECT_NEAR(moment([](const Vec2& p) { return p.x; }), 0, 1e-7) << law;
        EXPECT_NEAR(moment([](const Vec2& p) { return p.x * p.x; }), ss, 1e-7 * ss) << law;
        EXPECT_NEAR(moment([](const Vec2& p) { return p.x * p.y; }), st, 1e-7 * ss) << law;
        EXPECT_NEAR(moment([](const Vec2& p) { return p.y * p.y; }), tt, 1e-7 * tt) << law;
    }
}

/// Mean of K0(sqrt(2) r) / pi over a disk: shells about the centre, each with its share of angle.
double disk_mean(double d, double rho)
{
    const auto shell = [&](double r, double angle) {
        return r > 0 ? 2 * angle * r * cyl_bessel_k(0, std::sqrt(2.0) * r) : 0;
    };
    const auto whole = [&](double r) { return shell(r, kPi); };
    const auto cut = [&](double v) { // r = d + v, so that nothing cancels in a small disk far out
        const double r = d + v;
        const double half = std::sqrt((rho - v) * std::max(0.0, rho + v) / (4 * r * d));
        return shell(r, 2 * std::asin(std::min(half, 1.0)));
    };
    double sum = rho > d ? over_interval(whole, 0.0, rho - d, 1e-12) : 0;
    if (d > 0)
        sum += over_interval(cut, rho > d ? rho - 2 * d : -rho, rho, 1e-12);
    return sum / (kPi * kPi * rho * rho);
}

template <typename Real>
class K0Profile : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(K0Profile, Reals);

TYPED_TEST(K0Profile, IsTheMeanOverADiskWhereverItLies)
{
    using Real = TypeParam;
    const double tolerance = sizeof(Real) == 4 ? 1e-6 : 6e-8;
    double worst = 0;
    for (const double rho : {1e-6, 1e-3, 0.05, 0.3, 1.0, 1.41, 1.42, 2.0, 2.9, 5.0, 12.0})
        for (const double d :
             {0.0, 1e-7, 1e-3, 0.04, 0.29, 0.31, 0.99, 1.01, 1.4, 2.0, 2.8, 4.0, 8.0, 20.0}) {
            const Real r = static_cast<Real>(rho), at = static_cast<Real>(d);
            const double want = disk_mean(static_cast<double>(at), static_cast<double>(r));
            const double got = static_cast<double>(kernel::scree_k0_profile(at, r));
            const double error = std::abs(got / want - 1) / (1 + d);
            worst = std::max(worst, error);
            EXPECT_LE(error, tolerance)
                << "d " << d << " rho " << rho << ": " << got << ' ' << want;
        }
    this->RecordProperty("worst", std::to_string(worst * 1e9));
}

TYPED_TEST(K0Profile, OfRadiusZeroIsTheDensityItselfAndFiniteInTheMiddle)
{
    using Real = TypeParam;
    for (double d = 1e-6; d < 50; d *= 1.3) {
        const Real at = static_cast<Real>(d);
        const double want = cyl_bessel_k(0, std::sqrt(2.0) * static_cast<double>(at)) / kPi;
        EXPECT_NEAR(static_cast<double>(kernel::scree_k0_profile(at, Real(0))) / want, 1,
                    (sizeof(Real) == 4 ? 1e-6 + 1e-7 * d : kFit + 1e-9))
            << d;
    }
    EXPECT_NEAR(static_cast<double>(kernel::scree_k0_profile(Real(0), Real(0))), 22, 0.1);
}

// Of a huge disk about the middle everything lies inside: 1 / (pi rho^2).
TYPED_TEST(K0Profile, OfAHugeDiskIsOnePerArea)
{
    using Real = TypeParam;
    for (const double rho : {100.0, 3000.0, 5000.0})
        for (const double d : {0.0, 1.0, 50.0})
            EXPECT_NEAR(static_cast<double>(kernel::scree_k0_profile(static_cast<Real>(d),
                                                                     static_cast<Real>(rho))) *
                            kPi * rho * rho,
                        1, 3e-7)
                << rho << ' ' << d;
}

TEST(K0Density, MeanOverAPixelKeepsItsShapeAndItsSum)
{
    // Averaging does not change the integral, whatever the covariance.
    for (const auto& law : laws())
        EXPECT_NEAR(over_slopes(law, [&](const Vec2& p) { return k0::slope_pdf(p, law, 0.4); }), 1,
                    1e-4) // the seam at d = rho is a kink for the quadrature
            << law;
}

TEST(K0Density, InSinglePrecisionIsThatOfTheNumbersGiven)
{
    std::mt19937 random(5);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
        const double s = std::exp(uniform(-6, 0)), t = s * std::exp(uniform(-3, 3));
        const double r = i % 4 == 0 ? uniform(0.99, 0.9999) : uniform(-0.95, 0.95);
        Slopes<float> law{
            {static_cast<float>(uniform(-1, 1)), static_cast<float>(uniform(-1, 1))},
            {static_cast<float>(s * s), static_cast<float>(r * s * t), static_cast<float>(t * t)},
            1};
        const Imath::V2f slope(law.mean.x + static_cast<float>(uniform(-4, 4) * s),
                               law.mean.y + static_cast<float>(uniform(-4, 4) * t));
        const auto& [ss, st, tt] = law.covariance;
        const Slopes<double> exact{{law.mean.x, law.mean.y}, {ss, st, tt}, 1};
        const double d = std::sqrt(distance_squared(Vec2(slope.x, slope.y), exact));
        if (d > 50)
            continue;
        const double want =
            cyl_bessel_k(0, std::sqrt(2.0) * d) / (kPi * std::sqrt(determinant(exact)));
        const double error = std::abs(static_cast<double>(k0::slope_pdf(slope, law)) / want - 1);
        // What the rounding of slope - mean and of d is worth; more across a thin covariance.
        const double rounding = 1e-6 + 3e-7 * d / std::sqrt(1 - r * r);
        worst = std::max(worst, error / rounding);
        EXPECT_LE(error, rounding) << exact << " d " << d;
    }
    RecordProperty("worst", std::to_string(worst));
}

TEST(K0Density, OfNormalsIsThatOfSlopesPerCosineToTheFourth)
{
    for (const auto& law : laws())
        for (const double theta : {0.0, 0.2, 0.8, 1.3})
            for (const double phi : {0.1, 2.0, -2.4}) {
                const Vec3 m = toward(theta, phi);
                const double dd = distance_squared(Vec2(-m.x / m.z, -m.y / m.z), law);
                if (dd == 0)
                    continue;
                const double want = cyl_bessel_k(0, std::sqrt(2 * dd)) /
                                    (kPi * std::sqrt(determinant(law)) * std::pow(m.z, 4));
                EXPECT_NEAR(k0::ndf(m, law) / want, 1, kFit + 1e-8 * std::sqrt(dd)) << law;
            }
    EXPECT_EQ(k0::ndf(toward(2.0, 0.3), laws()[0]), 0);
    EXPECT_EQ(k0::ndf(Vec3(1, 0, 0), laws()[0]), 0);
    EXPECT_EQ(k0::ndf(Vec3(0, 0, -1), laws()[0]), 0); // where the slope would be that of (0, 0, 1)
}

// D, sigma and Lambda of the source, u = cos theta, alpha^2 = 2 variance; sigma below the plane
// too.
TEST(K0Density, IsotropicItIsTheSources)
{
    for (const double alpha : {0.1, 0.4, 1.0}) {
        const Slopes<double> law{{0, 0}, {alpha * alpha / 2, 0, alpha * alpha / 2}, 1};
        for (double u = -0.95; u < 1; u += 0.05) {
            const double tangent = std::sqrt(1 - u * u) / u;
            const Vec3 w = toward(std::acos(u), 0.8);
            const double hidden =
                std::exp(-2 / (std::abs(tangent) * alpha)) * std::sqrt(1 - u * u) * alpha / 4;
            EXPECT_NEAR(k0::projected_area(w, law) / (std::max(u, 0.0) + hidden), 1, 1e-7) << u;
            if (u < 0.01)
                continue;
            const double d =
                2 * cyl_bessel_k(0, 2 * tangent / alpha) / (kPi * std::pow(u, 4) * alpha * alpha);
            if (d > 1e-100) {
                EXPECT_NEAR(k0::ndf(w, law) / d, 1, 1e-7 + 2e-8 * tangent / alpha) << u;
            }
            const double x = 1 / (tangent * alpha);
            EXPECT_NEAR(k0::masking(w, law).lambda / (std::exp(-2 * x) / (4 * x)), 1, 1e-7) << u;
        }
    }
}

/// Integral of max(w . slope - wz, 0) P22: of the facets that w sees from behind. Requires a >= 0;
/// rays from the mean, in the half plane where they lead to such facets, and from there on.
double averted_area(const Vec3& w, const Slopes<double>& law)
{
    using Azimuths = boost::math::quadrature::gauss_kronrod<double, 61>;
    const double length = std::hypot(w.x, w.y);
    const double a = w.z - w.x * law.mean.x - w.y * law.mean.y;
    if (length == 0)
        return 0;
    boost::math::quadrature::exp_sinh<double> rule;
    const auto along = [&](double azimuth) {
        const double phi = std::atan2(w.y, w.x) + azimuth;
        const double fall = length * std::cos(azimuth), start = a / fall;
        const Vec2 ray(std::cos(phi), std::sin(phi));
        const auto facet = [&](double r) {
            const double value =
                r * fall * (start + r) * k0::slope_pdf(law.mean + ray * (start + r), law);
            return std::isfinite(value) ? value : 0;
        };
        // In steps of the deviation along the ray, of which the density is a function.
        const double step = 1 / std::sqrt(distance_squared(law.mean + ray, law));
        return step * rule.integrate([&](double r) { return facet(step * r); }, 0.0,
                                     std::numeric_limits<double>::infinity(), 1e-9);
    };
    return Azimuths::integrate(along, -kPi / 2, kPi / 2, 3, 1e-8);
}

TEST(K0Area, IsTheIntegralOfFacingFacetsAboveTheTexturePlaneAndBelow)
{
    int below = 0, turned_away = 0;
    for (const auto& law : laws())
        for (const Vec3& w : views()) {
            const double a = w.z - w.x * law.mean.x - w.y * law.mean.y;
            // What faces w is what -w sees from behind.
            const double want = a >= 0 ? a + averted_area(w, law) : averted_area(-w, law);
            EXPECT_NEAR(k0::projected_area(w, law), want, 1e-7 * want + 1e-20)
                << law << " view " << w;
            below += w.z < 0 ? 1 : 0;
            turned_away += a < 0 && w.z > 0 ? 1 : 0;
        }
    EXPECT_GT(below, 50);
    EXPECT_GT(turned_away, 5);
}

TEST(K0Area, OfADirectionAndItsOppositeDifferByTheMeanPlane)
{
    for (const auto& law : laws())
        for (const Vec3& w : views())
            EXPECT_NEAR(k0::projected_area(w, law) - k0::projected_area(-w, law),
                        w.z - w.x * law.mean.x - w.y * law.mean.y, 1e-12)
                << law << " view " << w;
}

TEST(K0Area, AndMaskingAreThoseOfAMixtureThatIsAllK0)
{
    for (const auto& law : laws())
        for (const Vec3& w : views()) {
            EXPECT_EQ(k0::projected_area(w, law), filter::projected_area(w, law));
            const auto got = k0::masking(w, law), want = filter::masking(w, law);
            EXPECT_EQ(got.lambda, want.lambda);
            EXPECT_EQ(got.g1, want.g1);
        }
}

// Over normals m of the upper hemisphere: G1 times the integral of max(w . m, 0) D(m) is cos theta,
// for mean 0. Azimuths as far as m faces w.
TEST(K0Masking, WhiteFurnaceOfMaskingReturnsTheCosine)
{
    using Azimuths = boost::math::quadrature::gauss_kronrod<double, 31>;
    for (const auto& law : laws()) {
        if (law.mean != Vec2(0, 0))
            continue;
        for (const double theta : {0.1, 0.8, 1.3, 1.5, 1.56})
            for (const double phi : {0.3, 2.0}) {
                const Vec3 w = toward(theta, phi);
                const auto ring = [&](double normal_theta) {
                    const double c = std::cos(normal_theta) * std::cos(theta);
                    const double s = std::sin(normal_theta) * std::sin(theta);
                    const double reach = c >= s ? kPi : std::acos(-c / s);
                    const auto facet = [&](double azimuth) {
                        return (c + s * std::cos(azimuth)) *
                               k0::ndf(toward(normal_theta, phi + azimuth), law);
                    };
                    const double area = Azimuths::integrate(facet, -reach, 0.0, 6, 1e-9) +
                                        Azimuths::integrate(facet, 0.0, reach, 6, 1e-9);
                    return area * std::sin(normal_theta);
                };
                // The seam where rings begin to be cut off.
                const double seam = kPi / 2 - theta;
                const double area =
                    over_interval(ring, 0.0, seam, 1e-8) + over_interval(ring, seam, kPi / 2, 1e-8);
                EXPECT_NEAR(k0::masking(w, law).g1 * area / w.z, 1, 1e-6)
                    << law << " theta " << theta << " phi " << phi;
            }
    }
}

TEST(K0Density, OfAMixtureIsBetweenItsParts)
{
    auto law = laws()[4];
    for (const double d : {0.0, 0.3, 2.0})
        for (const double tau : {-1.0, 0.0, 0.25, 1.0, 3.0}) {
            const Vec2 slope = law.mean + Vec2(d * 0.4, d * 0.1);
            const double gauss = std::exp(-distance_squared(slope, law) / 2) /
                                 (2 * kPi * std::sqrt(determinant(law)));
            const double weight = std::clamp(tau, 0.0, 1.0);
            const double want = (1 - weight) * gauss +
                                weight * disk_mean(std::sqrt(distance_squared(slope, law)), 0.1) /
                                    std::sqrt(determinant(law));
            law.tau = tau;
            EXPECT_NEAR(k0::mixture_slope_pdf(slope, law, 0.1) / want, 1, 2e-7) << tau << ' ' << d;
        }
}

} // namespace
} // namespace scree::test
