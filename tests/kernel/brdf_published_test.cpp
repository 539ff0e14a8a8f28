// What Barla, Belcour and Pacanowski 2015 print of their coordinates: which holds, which does not,
// and by how much. docs/errata.md lists the errors.

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/brdf_coordinates.h"
#include "kernel/direction_pairs.h"

namespace scree::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
using Imath::V3d;

/// h, k and the angles of the paper, by the standard library alone; k longer than 0.05 and not
/// upright, h off the normal and above the horizon, so that every angle is defined.
struct Pair {
    V3d wo, wi, h, k;
    double h_bar = 0, phi_h = 0, theta_h = 0, theta_d = 0, phi_d = 0, theta_k = 0, phi_k = 0;
};

std::vector<Pair> pairs()
{
    std::vector<Pair> all;
    for (const auto& [name, w] : direction_pairs()) {
        Pair p{w.wo, w.wi, (w.wi + w.wo) * 0.5, (w.wi - w.wo) * 0.5};
        p.h_bar = std::hypot(p.h.x, p.h.y);
        if (p.h_bar < 0.05 || p.h.z < 0.05 || std::hypot(p.k.x, p.k.y) < 0.05)
            continue;
        p.phi_h = std::atan2(p.h.y, p.h.x);
        p.theta_h = std::atan2(p.h_bar, p.h.z);
        p.theta_d = std::atan2(p.k.length(), p.h.length());
        p.theta_k = std::atan2(std::hypot(p.k.x, p.k.y), p.k.z);
        p.phi_k = std::atan2(p.k.y, p.k.x);
        const V3d meridian(std::cos(p.theta_h) * std::cos(p.phi_h),
                           std::cos(p.theta_h) * std::sin(p.phi_h), -std::sin(p.theta_h));
        const V3d across(-std::sin(p.phi_h), std::cos(p.phi_h), 0);
        p.phi_d = std::atan2(p.wi.dot(across), p.wi.dot(meridian));
        all.push_back(p);
    }
    return all;
}

double square(double x) { return x * x; }
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

TEST(BrdfPublished, AppendixIdentitiesThatHold)
{
    ASSERT_GT(pairs().size(), 20000U);
    for (const Pair& p : pairs()) {
        const double kk = p.k.length2();
        EXPECT_NEAR(p.h.length2(), (1 + p.wi.dot(p.wo)) / 2, 1e-14);
        EXPECT_NEAR(kk, (1 - p.wi.dot(p.wo)) / 2, 1e-14);
        EXPECT_NEAR(p.h.dot(p.k), 0, 1e-15);
        EXPECT_NEAR(p.h.z, std::sqrt(1 - kk - square(p.h_bar)), 1e-13);
        EXPECT_NEAR(std::cos(p.theta_d), std::sqrt(1 - kk), 1e-14);
        EXPECT_NEAR(square(std::cos(p.theta_h)), (1 - square(p.h_bar) - kk) / (1 - kk), 1e-12);
        // The appendix has the squares that section 3 lacks.
        EXPECT_NEAR(square(p.h_bar),
                    (1 - square(std::cos(p.theta_h))) * (1 - square(std::sin(p.theta_d))), 1e-14);
        EXPECT_NEAR(p.wi.z * p.wo.z, 1 - square(p.h_bar) - kk * (1 + square(std::cos(p.theta_k))),
                    1e-14);
    }
}

// "theta_k = +-90 when phi_k = 90", which is phi_k - phi_h: k across h lies in the plane.
TEST(BrdfPublished, BackVectorAcrossTheHalfVectorIsInThePlane)
{
    for (double h = 0.05; h < 1; h += 0.05)
        for (double share = 0.1; share < 0.95; share += 0.1) {
            const double k = share * std::sqrt(1 - h * h);
            for (const double phi_h : {0.0, 1.0}) {
                const auto w =
                    filter::directions(filter::Hybrid<double>{h, phi_h, k, phi_h + kPi / 2});
                EXPECT_NEAR(w.wi.z, w.wo.z, 1e-15);
            }
        }
}

TEST(BrdfPublished, SectionThreeLacksASquare)
{
    double worst = 0;
    for (const Pair& p : pairs()) {
        const double product = std::sin(p.theta_h) * std::cos(p.theta_d);
        EXPECT_NEAR(square(p.h_bar), square(product), 1e-14);
        worst = std::max(worst, std::abs(square(p.h_bar) - product));
    }
    // x - x^2 at x = 1/2.
    EXPECT_NEAR(worst, 0.25, 1e-3);
}

TEST(BrdfPublished, AzimuthsDoNotAdd)
{
    for (const Pair& p : pairs()) {
        // tan(phi_k - phi_h) = tan(phi_d) / cos(theta_h), with the quadrants
        const double between =
            std::atan2(std::sin(p.phi_d), std::cos(p.theta_h) * std::cos(p.phi_d));
        EXPECT_LT(apart(p.phi_k - p.phi_h, between), 1e-12);
    }
}

// Of one theta_h the error of phi_h + phi_d is asin((1 - c) / (1 + c)) at most, c = cos(theta_h).
TEST(BrdfPublished, TheSumOfAzimuthsIsOffByUpTo90Degrees)
{
    for (const auto& [theta_degrees, off_degrees] :
         {std::pair{30.0, 4.12}, {60.0, 19.47}, {85.0, 57.10}, {89.0, 74.95}}) {
        const double theta_h = theta_degrees * kPi / 180;
        double worst = 0;
        for (double phi_d = 0; phi_d < kPi; phi_d += 1e-3) {
            const filter::HalfDifference<double> half{theta_h, 0.7, 0.01, phi_d};
            const double phi_k = filter::hybrid(filter::directions(half)).phi_k;
            worst = std::max(worst, apart(phi_k, half.phi_h + half.phi_d));
        }
        EXPECT_NEAR(worst * 180 / kPi, off_degrees, 0.01) << theta_degrees;
    }
}

// Where h_bar is 0 or across k the printed quotient is x / 0; and as an arctangent it is in
// (-90, 90) degrees, so that cos theta_k >= 0: half of all pairs come back with wi and wo changed.
TEST(BrdfPublished, ThetaKOfTheArctangentChangesViewerAndLight)
{
    size_t kept = 0, changed = 0;
    for (const Pair& p : pairs()) {
        const double along = p.h_bar * std::cos(p.phi_h - p.phi_k);
        if (std::abs(along) < 1e-3)
            continue;
        const double theta_k = std::atan(-p.h.z / along);
        const V3d k = V3d(std::sin(theta_k) * std::cos(p.phi_k),
                          std::sin(theta_k) * std::sin(p.phi_k), std::cos(theta_k)) *
                      p.k.length();
        const double same = (k - p.k).length(), opposite = (k + p.k).length();
        EXPECT_LT(std::min(same, opposite), 1e-11);
        ++(same < opposite ? kept : changed);
        // Ours: the angle of a vector, (0, 180) degrees.
        EXPECT_NEAR(std::atan2(p.h.z, -along), p.theta_k, 1e-11);
    }
    EXPECT_NEAR(static_cast<double>(changed) / static_cast<double>(kept + changed), 0.5, 0.02);
}

// "G = 1 - (wi n)(wo n), with its 0-isoline corresponding to hemispherical boundaries": there it
// is 1; it is 0 where both are along the normal.
TEST(BrdfPublished, GrazingFunctionIsOneAtTheHorizon)
{
    for (const auto& [name, w] : direction_pairs()) {
        const double g = 1 - w.wi.z * w.wo.z;
        if (w.wi.z == 0 || w.wo.z == 0) {
            EXPECT_EQ(g, 1);
        } else if (w.wi.z > 1e-3 && w.wo.z > 1e-3) {
            EXPECT_LT(g, 1);
        }
    }
}

// "Any slice in the hybrid parametrization corresponds to a warped slice in the half/difference
// parametrization": of one azimuth phi_k - phi_h, phi_d goes from that azimuth to 0 with theta_h.
TEST(BrdfPublished, SlicesOfTheHybridAreNotSlicesOfHalfDifference)
{
    const double azimuth = kPi / 4;
    const auto phi_d = [&](double h_bar, double k) {
        return filter::half_difference(
                   filter::directions(filter::Hybrid<double>{h_bar, 0, k, azimuth}))
            .phi_d;
    };
    EXPECT_NEAR(phi_d(0.01, 0.1), azimuth, 1e-4);
    const double theta_h = std::asin(0.9 / std::sqrt(1 - 0.01));
    EXPECT_NEAR(phi_d(0.9, 0.1), std::atan(std::cos(theta_h) * std::tan(azimuth)), 1e-12);
    EXPECT_LT(phi_d(0.9, 0.1), 24 * kPi / 180);
}

} // namespace
} // namespace scree::test
