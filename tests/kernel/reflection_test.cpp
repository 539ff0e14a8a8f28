// Roughness, the specular and the diffuse term, against definitions and quadrature.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>

#include "kernel/filter.h"

namespace scree::test {
namespace {

using filter::Covariance;
using filter::Slopes;
using Imath::V2d;
using Imath::V3d;

const double kPi = std::acos(-1.0);

V3d toward(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Slopes<double> gaussian(double ms, double mt, const Covariance<double>& covariance)
{
    Slopes<double> slopes;
    slopes.mean = {ms, mt};
    slopes.covariance = covariance;
    return slopes;
}

/// Sum of f(slope) p(slope) over a grid of +-6 deviations in the frame of the covariance's Cholesky
/// factor; the trapezoidal rule on a smooth density. The clamp at 0 of an area costs h^2: 400^2
/// points give 1e-5.
template <typename F>
double over_slopes(const Slopes<double>& slopes, F f)
{
    constexpr int kPoints = 400;
    const auto& [ss, st, tt] = slopes.covariance;
    const double l = std::sqrt(ss), m = l > 0 ? st / l : 0,
                 r = std::sqrt(std::max(0.0, tt - m * m));
    const double step = 12.0 / kPoints;
    double sum = 0;
    for (int j = 0; j < kPoints; ++j)
        for (int i = 0; i < kPoints; ++i) {
            const double x = -6 + (i + 0.5) * step, y = -6 + (j + 0.5) * step;
            const double weight = std::exp(-(x * x + y * y) / 2) / (2 * kPi) * step * step;
            sum += weight * f(slopes.mean.x + l * x, slopes.mean.y + m * x + r * y);
        }
    return sum;
}

TEST(Roughness, GivesTheCovarianceBack)
{
    const double base = 0.15;
    for (const double ratio : {1.0, 3.0, 100.0})
        for (double angle = -1.5; angle < 1.6; angle += 0.25) {
            const double most = 0.3, least = most / (ratio * ratio);
            const double c = std::cos(angle), s = std::sin(angle);
            const Covariance<double> covariance{
                most * c * c + least * s * s, (most - least) * c * s, most * s * s + least * c * c};
            const auto lobe = filter::beckmann_roughness(covariance, base);
            EXPECT_NEAR(lobe.alpha_x, std::sqrt(base * base + 2 * most), 1e-12);
            EXPECT_NEAR(lobe.alpha_y, std::sqrt(base * base + 2 * least), 1e-10);
            if (ratio > 1) {
                EXPECT_NEAR(std::sin(2 * (lobe.angle_rad - angle)), 0, 5e-8)
                    << "ratio " << ratio << " angle " << angle;
            }
        }
}

TEST(Roughness, OfNoSpreadIsTheBaseRoughness)
{
    const auto flat = filter::beckmann_roughness(Covariance<float>{}, 0.3F);
    EXPECT_FLOAT_EQ(flat.alpha_x, 0.3F);
    EXPECT_FLOAT_EQ(flat.alpha_y, 0.3F);
    EXPECT_EQ(flat.angle_rad, 0);
    const auto groove = filter::beckmann_roughness(Covariance<float>{0, 0, 0.02F}, 0.0F);
    EXPECT_FLOAT_EQ(groove.alpha_x, 0.2F);
    EXPECT_EQ(groove.alpha_y, 0);
    EXPECT_NEAR(groove.angle_rad, kPi / 2, 1e-6);
}

/// The textbook form for isotropic roughness: angles, erfc, no slopes.
double textbook_specular(const V3d& wo, const V3d& wi, double alpha)
{
    const auto lambda = [&](const V3d& w) {
        const double sine = std::sqrt(1 - w.z * w.z);
        if (sine == 0)
            return 0.0;
        const double nu = w.z / (alpha * sine);
        return std::exp(-nu * nu) / (2 * nu * std::sqrt(kPi)) - std::erfc(nu) / 2;
    };
    const V3d h = (wo + wi).normalized();
    const double tangent2 = (1 - h.z * h.z) / (h.z * h.z);
    const double d =
        std::exp(-tangent2 / (alpha * alpha)) / (kPi * alpha * alpha * std::pow(h.z, 4));
    return d / (1 + lambda(wo) + lambda(wi)) / (4 * wo.z);
}

TEST(Specular, OfAnIsotropicSurfaceIsTheTextbookBeckmannLobe)
{
    for (const double alpha : {0.05, 0.3, 0.8})
        for (const double o : {0.0, 0.6, 1.3, 1.55})
            for (const double i : {0.1, 0.8, 1.4})
                for (const double phi : {0.0, 1.0, 3.0}) {
                    const V3d wo = toward(o, 0), wi = toward(i, phi);
                    const double want = textbook_specular(wo, wi, alpha);
                    // Once all in the base roughness, once all in the slopes.
                    EXPECT_NEAR(filter::specular(wo, wi, Slopes<double>{}, alpha), want,
                                2e-7 * want + 1e-30);
                    const double variance = alpha * alpha / 2 - 0.5e-8;
                    EXPECT_NEAR(
                        filter::specular(wo, wi, gaussian(0, 0, {variance, 0, variance}), 1e-4),
                        want, 2e-7 * want + 1e-30)
                        << alpha << ' ' << o << ' ' << i << ' ' << phi;
                }
}

// D G2 / (4 a_o) over a_i does not change when view and light change places.
TEST(Specular, IsReciprocalPerProjectedArea)
{
    const Slopes<double> slopes = gaussian(0.2, -0.3, {0.2, 0.1, 0.15});
    const auto area = [&](const V3d& w) { return w.z - w.x * slopes.mean.x - w.y * slopes.mean.y; };
    std::mt19937 random(5);
    int compared = 0;
    for (int k = 0; k < 300; ++k) {
        const auto next = [&] { return static_cast<double>(random()) / 4294967296.0; };
        const V3d a = toward(1.5 * next(), 6.28 * next()), b = toward(1.5 * next(), 6.28 * next());
        if (area(a) <= 0 || area(b) <= 0)
            continue;
        const double there = filter::specular(a, b, slopes, 0.1) / area(b);
        const double back = filter::specular(b, a, slopes, 0.1) / area(a);
        EXPECT_NEAR(there, back, 1e-7 * there + 1e-30);
        ++compared;
    }
    EXPECT_GT(compared, 200);
}

// All light leaves a smooth surface; a rough one loses what is scattered twice, and no more is
// reflected than came in.
TEST(Specular, ReflectsAtMostWhatComesIn)
{
    const auto reflected = [](const Slopes<double>& slopes, double base, const V3d& wo) {
        constexpr int kRings = 300, kSteps = 600;
        double sum = 0;
        for (int j = 0; j < kRings; ++j) {
            const double theta = (j + 0.5) / kRings * kPi / 2;
            for (int k = 0; k < kSteps; ++k)
                sum += filter::specular(wo, toward(theta, (k + 0.5) / kSteps * 2 * kPi), slopes,
                                        base) *
                       std::sin(theta);
        }
        return sum * (kPi / 2 / kRings) * (2 * kPi / kSteps);
    };
    EXPECT_NEAR(reflected(Slopes<double>{}, 0.1, toward(0.5, 0)), 1, 2e-3);
    EXPECT_NEAR(reflected(gaussian(0.1, -0.1, {0.01, 0.004, 0.006}), 0.05, toward(0.6, 1)), 1,
                0.02);
    for (const double theta : {0.2, 0.9, 1.4}) {
        const double share = reflected(gaussian(0, 0, {0.2, 0.1, 0.15}), 0.2, toward(theta, 0.3));
        EXPECT_LE(share, 1 + 1e-3) << theta;
        EXPECT_GE(share, 0.6) << theta;
    }
}

TEST(Specular, IsFiniteAndZeroWhereNothingIsSeenOrLit)
{
    const Slopes<float> flat{};
    EXPECT_EQ(filter::specular<float>({0, 0, 1}, {0.6F, 0, -0.8F}, flat, 0.2F), 0);
    EXPECT_EQ(filter::specular<float>({0.6F, 0, -0.8F}, {0, 0, 1}, flat, 0.2F), 0);
    EXPECT_EQ(filter::specular<float>({1, 0, 0}, {-1, 0, 0}, flat, 0.2F), 0);
    const float mirror = filter::specular<float>({0.6F, 0, 0.8F}, {-0.6F, 0, 0.8F}, flat, 0.0F);
    EXPECT_TRUE(std::isfinite(mirror));
    EXPECT_GT(mirror, 1e5F);
}

/// G2 / (G1_o N_o) times the integral of W_o (wi . n)+ p by quadrature.
double diffuse_by_quadrature(const V3d& wo, const V3d& wi, const Slopes<double>& slopes)
{
    const auto area = [](const V3d& w, double s, double t) {
        return std::max(0.0, w.z - w.x * s - w.y * t);
    };
    const double seen = over_slopes(slopes, [&](double s, double t) { return area(wo, s, t); });
    const double lit = over_slopes(slopes, [&](double s, double t) {
        return area(wo, s, t) * area(wi, s, t) / std::sqrt(1 + s * s + t * t);
    });
    const auto view = filter::masking(wo, slopes), light = filter::masking(wi, slopes);
    return (1 + view.lambda) / (1 + view.lambda + light.lambda) * lit / seen;
}

// What the Gaussian of the visible slopes and the cubature cost; shadowing is common to both.
TEST(Diffuse, IsWithinTwoHundredthsOfItsIntegral)
{
    double worst = 0;
    for (const Covariance<double>& covariance :
         {Covariance<double>{0.01, 0, 0.01}, Covariance<double>{0.09, 0.04, 0.06},
          Covariance<double>{0.36, 0, 0.36}, Covariance<double>{0.36, 0.1, 0.04},
          Covariance<double>{0.04, -0.03, 0.09}})
        for (const double mean : {0.0, 0.3})
            for (const double o : {0.0, 0.7, 1.2, 1.4835})
                for (const double i : {0.0, 0.7, 1.2, 1.4835})
                    for (const double phi : {0.0, 1.5, 3.14}) {
                        const auto slopes = gaussian(mean, -0.5 * mean, covariance);
                        const V3d wo = toward(o, 0.4), wi = toward(i, 0.4 + phi);
                        const double want = diffuse_by_quadrature(wo, wi, slopes);
                        const double got = filter::diffuse(wo, wi, slopes);
                        worst = std::max(worst, std::abs(got - want));
                        EXPECT_NEAR(got, want, 0.02)
                            << "covariance " << covariance.ss << ' ' << covariance.st << ' '
                            << covariance.tt << " mean " << mean << " view " << o << " light " << i
                            << " phi " << phi;
                    }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_GT(worst, 1e-4); // it is an approximation: the quadrature is not the same thing
}

// K0 as what it is, a mixture of Gaussians whose covariance is exponentially distributed.
TEST(Diffuse, OfHeavyTailsIsWithinFiveHundredthsOfItsIntegral)
{
    constexpr int kParts = 24;
    const Covariance<double> covariance{0.36, 0, 0.36};
    double worst = 0;
    for (const auto& [o, i, phi] : {std::tuple(0.0, 0.0, 0.0), std::tuple(0.7, 1.2, 1.5),
                                    std::tuple(1.2, 0.7, 3.14), std::tuple(1.4835, 1.2, 0.0)}) {
        const V3d wo = toward(o, 0.4), wi = toward(i, 0.4 + phi);
        double seen = 0, lit = 0;
        for (int k = 0; k < kParts; ++k) {
            const double share = -std::log(1 - (k + 0.5) / kParts);
            const auto part = gaussian(0, 0, {share * covariance.ss, 0, share * covariance.tt});
            seen += over_slopes(part, [&](double s, double t) {
                return std::max(0.0, wo.z - wo.x * s - wo.y * t);
            });
            lit += over_slopes(part, [&](double s, double t) {
                return std::max(0.0, wo.z - wo.x * s - wo.y * t) *
                       std::max(0.0, wi.z - wi.x * s - wi.y * t) / std::sqrt(1 + s * s + t * t);
            });
        }
        auto slopes = gaussian(0, 0, covariance);
        slopes.tau = 1;
        const auto view = filter::masking(wo, slopes), light = filter::masking(wi, slopes);
        const double want = (1 + view.lambda) / (1 + view.lambda + light.lambda) * lit / seen;
        const double got = filter::diffuse(wo, wi, slopes);
        worst = std::max(worst, std::abs(got - want));
        EXPECT_NEAR(got, want, 0.05) << "view " << o << " light " << i << " phi " << phi;
    }
    RecordProperty("worst", std::to_string(worst));
}

// Where the mean plane turns away from the viewer, nothing jumps.
TEST(Specular, IsContinuousOverTheHorizonOfTheMeanPlane)
{
    const auto slopes = gaussian(1, 0, {0.1, 0, 0.1});
    const V3d light = toward(1.5, kPi);
    const double before = filter::specular(toward(kPi / 4 - 1e-6, 0), light, slopes, 0.1);
    const double after = filter::specular(toward(kPi / 4 + 1e-6, 0), light, slopes, 0.1);
    EXPECT_GT(before, 0.1);
    EXPECT_NEAR(before, after, 1e-4);
}

TEST(Diffuse, OfAPlaneIsLambertsCosine)
{
    for (const double theta : {0.0, 0.5, 1.2}) {
        const V3d wi = toward(theta, 1);
        EXPECT_NEAR(filter::diffuse(V3d(0, 0, 1), wi, Slopes<double>{}), wi.z, 1e-12);
        const auto tilted = gaussian(0.3, -0.2, {0, 0, 0});
        const V3d n = filter::normal(tilted.mean);
        EXPECT_NEAR(filter::diffuse(V3d(0, 0, 1), wi, tilted), std::max(0.0, n ^ wi), 1e-12);
    }
}

// Light from where the viewer is: the rougher, the more facets face both; the opposite effect
// across. What makes the full moon flat.
TEST(Diffuse, RoughSurfacesAreBrightTowardsTheLight)
{
    const V3d light = toward(1.2, 0);
    const auto rough = gaussian(0, 0, {0.3, 0, 0.3});
    const double with_light = filter::diffuse(toward(1.2, 0), light, rough);
    const double against = filter::diffuse(toward(1.2, kPi), light, rough);
    EXPECT_GT(with_light, 1.2 * light.z);
    EXPECT_LT(against, light.z);
}

} // namespace
} // namespace scree::test
