// Half/difference, orthographic and hybrid coordinates: definitions, round trips, symmetries.

#include "kernel/brdf_coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "kernel/direction_pairs.h"

namespace scree::test {
namespace {

using filter::Directions;

constexpr double kPi = 3.14159265358979323846;
using Long3 = Imath::Vec3<long double>;

template <typename Real>
constexpr double kTolerance = std::is_same_v<Real, double> ? 1e-12 : 1e-5;

template <typename Real>
Directions<Real> in(const Directions<double>& w)
{
    return {filter::Vec3<Real>(w.wo), filter::Vec3<Real>(w.wi)};
}

template <typename Real>
std::string text(const std::string& name, const Directions<Real>& w)
{
    std::ostringstream out;
    out.precision(17);
    out << name << ": wo " << w.wo << " wi " << w.wi;
    return out.str();
}

double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * kPi)); }

// --- definitions, in long double and other words

Long3 turned_about_normal(const Long3& v, long double angle)
{
    const long double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

Long3 turned_about_binormal(const Long3& v, long double angle)
{
    const long double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
}

// Oracle: the two rotations of Rusinkiewicz; azimuths of the bars. Away from singularities, where
// the definitions lose digits: 1e-12 for vectors longer than 1e-2.
TEST(BrdfCoordinates, AreWhatTheyAreDefinedAs)
{
    int checked = 0;
    for (const auto& [name, w] : direction_pairs()) {
        const Long3 wo = Long3(w.wo), wi = Long3(w.wi);
        const Long3 h = (wi + wo) * 0.5L, k = (wi - wo) * 0.5L;
        const long double h_bar = std::hypot(h.x, h.y), k_bar = std::hypot(k.x, k.y);
        const auto half = filter::half_difference(w);
        const auto flat = filter::orthographic(w);
        const auto both = filter::hybrid(w);
        ASSERT_NEAR(flat.h_bar, static_cast<double>(h_bar), 1e-15) << text(name, w);
        ASSERT_NEAR(flat.k_bar, static_cast<double>(k_bar), 1e-15) << text(name, w);
        ASSERT_NEAR(both.h_bar, static_cast<double>(h_bar), 1e-15) << text(name, w);
        ASSERT_NEAR(both.k, static_cast<double>(k.length()), 1e-15) << text(name, w);
        if (h_bar < 1e-2L || k_bar < 1e-2L || h.z < 1e-2L)
            continue;
        ++checked;
        const long double theta_h = std::acos(h.z / h.length()), phi_h = std::atan2(h.y, h.x);
        const Long3 d = turned_about_binormal(turned_about_normal(wi, -phi_h), -theta_h);
        ASSERT_NEAR(half.theta_h, static_cast<double>(theta_h), 1e-12) << text(name, w);
        ASSERT_NEAR(half.theta_d, static_cast<double>(std::acos(d.z)), 1e-12) << text(name, w);
        ASSERT_LT(apart(half.phi_d, static_cast<double>(std::atan2(d.y, d.x))), 1e-12)
            << text(name, w);
        const auto azimuth_h = static_cast<double>(phi_h);
        const auto azimuth_k = static_cast<double>(std::atan2(k.y, k.x));
        for (const double got : {half.phi_h, flat.phi_h, both.phi_h})
            ASSERT_LT(apart(got, azimuth_h), 1e-12) << text(name, w);
        for (const double got : {flat.phi_k, both.phi_k})
            ASSERT_LT(apart(got, azimuth_k), 1e-12) << text(name, w);
    }
    EXPECT_GT(checked, 20000);
}

// --- round trips

/// The worst x, y or z of either direction after a round trip, times `scale(w, z)`.
template <typename Real, typename Coordinates, typename Scale>
void expect_round_trip(const std::string& precision,
                       Coordinates (*forward)(const Directions<Real>&), const Scale& scale)
{
    double worst = 0;
    std::string where;
    for (const auto& [name, pair] : direction_pairs()) {
        const Directions<Real> w = in<Real>(pair);
        const Directions<Real> got = filter::directions(forward(w));
        for (const auto& [a, b] : {std::pair{got.wo, w.wo}, std::pair{got.wi, w.wi}}) {
            ASSERT_GE(a.z, 0) << text(name, w);
            const auto apart = Imath::V3d(a) - Imath::V3d(b);
            const double most = std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)});
            const double error = most * scale(w, static_cast<double>(b.z));
            ASSERT_TRUE(std::isfinite(error)) << text(name, w);
            if (error > worst) {
                worst = error;
                where = text(name, w);
            }
        }
    }
    EXPECT_LT(worst, kTolerance<Real>) << precision << ", " << where;
    std::ostringstream figure;
    figure << worst;
    ::testing::Test::RecordProperty("worst " + precision, figure.str());
}

/// What a small z is compared with: lengths tell z^2 to rounding, so z to rounding / z, and at the
/// horizon to the root of rounding.
template <typename Real>
double told(const Directions<Real>& /*w*/, double z)
{
    return std::max(z, std::is_same_v<Real, double> ? 3e-5 : 1e-2);
}

template <typename Real>
double mean_z(const Directions<Real>& w)
{
    return 0.5 * (static_cast<double>(w.wo.z) + static_cast<double>(w.wi.z));
}

/// A round trip in both precisions, with the scale of errors that `scale` gives for each.
template <template <typename> typename Coordinates, typename Scale>
void expect_both_round_trips(Coordinates<float> (*in_float)(const Directions<float>&),
                             Coordinates<double> (*in_double)(const Directions<double>&),
                             const Scale& scale)
{
    expect_round_trip<float>("float", in_float, scale);
    expect_round_trip<double>("double", in_double, scale);
}

TEST(BrdfRoundTrip, HalfDifferenceComesBack)
{
    expect_both_round_trips<filter::HalfDifference>(
        &filter::half_difference<float>, &filter::half_difference<double>,
        [](const auto& /*w*/, double /*z*/) { return 1.0; });
}

TEST(BrdfRoundTrip, OrthographicComesBackAboveTheHorizon)
{
    expect_both_round_trips<filter::Orthographic>(
        &filter::orthographic<float>, &filter::orthographic<double>,
        [](const auto& /*w*/, double z) { return z > 0.05 ? 1.0 : 0.0; });
}

TEST(BrdfRoundTrip, OrthographicComesBackAtTheHorizonAsFarAsLengthsTell)
{
    expect_both_round_trips<filter::Orthographic>(
        &filter::orthographic<float>, &filter::orthographic<double>,
        [](const auto& w, double z) { return told(w, z); });
}

TEST(BrdfRoundTrip, HybridComesBackUnlessBothAreAtTheHorizon)
{
    expect_both_round_trips<filter::Hybrid>(
        &filter::hybrid<float>, &filter::hybrid<double>,
        [](const auto& w, double /*z*/) { return mean_z(w) > 0.05 ? 1.0 : 0.0; });
}

TEST(BrdfRoundTrip, HybridComesBackAtTheHorizonAsFarAsLengthsTell)
{
    expect_both_round_trips<filter::Hybrid>(
        &filter::hybrid<float>, &filter::hybrid<double>,
        [](const auto& w, double /*z*/) { return told(w, mean_z(w)); });
}

// No code can do better: a few roundings of the length are already another direction.
TEST(BrdfCoordinates, LengthsDoNotTellZAtTheHorizon)
{
    filter::Orthographic<double> flat{0.5, 0, 0.5, 0};
    EXPECT_EQ(filter::directions(flat).wi.z, 0);
    flat.k_bar -= 2e-16;
    EXPECT_GT(filter::directions(flat).wi.z, 5e-9);
    // h across k, both at the horizon.
    filter::Hybrid<double> both{std::sqrt(0.5), 0, std::sqrt(0.5), kPi / 2};
    both.k = std::nextafter(both.k, 1.0);
    const double z = filter::directions(both).wi.z;
    both.k -= 4e-16;
    EXPECT_GT(filter::directions(both).wi.z - z, 5e-9);
}

// --- what has no solution

/// Whether coordinates have both directions above the surface, by the appendix's vectors.
bool is_inside(double h_bar, double k, double azimuth)
{
    const long double hz2 =
        1.0L - static_cast<long double>(k) * k - static_cast<long double>(h_bar) * h_bar;
    if (hz2 < 0)
        return false;
    const long double down = h_bar * std::cos(static_cast<long double>(azimuth));
    return k * std::abs(down) <= std::sqrt(hz2) * std::sqrt(hz2 + down * down);
}

/// The largest number below which `inside` holds, by bisection in [0, most].
template <typename Inside>
double end_of(double most, const Inside& inside)
{
    double low = 0;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + most);
        (inside(middle) ? low : most) = middle;
    }
    return low;
}

// 1e-9: at the reach one z is 0, and the condition is as flat as its square.
TEST(BrdfCoordinates, ReachIsWhereADirectionMeetsTheHorizon)
{
    for (double h = 0.01; h < 1; h += 0.02)
        for (double azimuth = -3.1; azimuth < 3.2; azimuth += 0.09) {
            const double k_bar = end_of(1, [&](double k) {
                return h * h + k * k + 2 * h * k * std::abs(std::cos(azimuth)) <= 1;
            });
            ASSERT_NEAR(kernel::scree_orthographic_reach(h, azimuth), k_bar, 1e-9);
            const double k = end_of(1, [&](double x) { return is_inside(h, x, azimuth); });
            ASSERT_NEAR(kernel::scree_hybrid_reach(h, azimuth), k, 1e-9);
            const double theta_h = h * kPi / 2;
            const double theta_d = end_of(kPi / 2, [&](double x) {
                return std::tan(x) * std::tan(theta_h) * std::abs(std::cos(azimuth)) <= 1;
            });
            ASSERT_NEAR(kernel::scree_half_difference_reach(theta_h, azimuth), theta_d, 1e-9);
        }
    EXPECT_NEAR(kernel::scree_half_difference_reach(kPi / 2, 0.3), 0, 1e-15);
    EXPECT_EQ(kernel::scree_half_difference_reach(kPi / 2, kPi / 2), kPi / 2);
    const auto quarter = static_cast<float>(kPi / 2);
    EXPECT_EQ(kernel::scree_half_difference_reach(quarter, quarter), quarter);
    EXPECT_EQ(kernel::scree_orthographic_reach(1.0, 0.3), 0);
    EXPECT_EQ(kernel::scree_hybrid_reach(1.0, 0.3), 0);
    EXPECT_NEAR(kernel::scree_orthographic_reach(0.0, 0.3), 1, 1e-15);
}

template <typename Coordinates>
void expect_at_the_horizon(const Coordinates& beyond)
{
    const auto w = filter::directions(beyond);
    for (const auto& v : {w.wo, w.wi}) {
        EXPECT_NEAR(v.length(), 1, 1e-15);
        EXPECT_GE(v.z, 0);
    }
    EXPECT_EQ(std::min(w.wo.z, w.wi.z), 0);
}

TEST(BrdfCoordinates, BeyondTheReachOneDirectionIsAtTheHorizon)
{
    for (const double h : {0.01, 0.2, 0.7, 0.999, 1.0})
        for (const double azimuth : {0.0, 0.6, 2.5, -1.0, kPi})
            for (const double phi : {0.4, -3.0})
                for (const double more : {1e-9, 0.1, 0.5}) {
                    const double theta_h = h * kPi / 2;
                    const double k_bar = kernel::scree_orthographic_reach(h, azimuth) + more;
                    const double k = kernel::scree_hybrid_reach(h, azimuth) + more;
                    const double theta_d =
                        kernel::scree_half_difference_reach(theta_h, azimuth) + more;
                    expect_at_the_horizon<filter::Orthographic<double>>(
                        {h, phi, k_bar, phi + azimuth});
                    expect_at_the_horizon<filter::Hybrid<double>>({h, phi, k, phi + azimuth});
                    if (theta_d <= kPi / 2)
                        expect_at_the_horizon<filter::HalfDifference<double>>(
                            {theta_h, phi, theta_d, azimuth});
                }
}

// theta_h = theta_d = 90 degrees and k straight up and down: any direction at the horizon.
template <typename Real>
void expect_unit_vectors_of_an_upright_back_vector()
{
    const auto quarter = static_cast<Real>(kPi / 2), half = static_cast<Real>(kPi);
    for (const Real phi_h : {Real(0), Real(0.4)})
        for (const Real phi_d : {Real(0), half}) {
            const auto w =
                filter::directions(filter::HalfDifference<Real>{quarter, phi_h, quarter, phi_d});
            for (const auto& v : {w.wo, w.wi}) {
                EXPECT_NEAR(v.length(), 1, 1e-6);
                EXPECT_GE(v.z, 0);
            }
        }
    Real x = 0, y = 0, z = 0;
    kernel::scree_above_horizon(Real(0), Real(0), Real(-1), x, y, z);
    EXPECT_EQ(filter::Vec3<Real>(x, y, z), filter::Vec3<Real>(1, 0, 0));
}

TEST(BrdfCoordinates, StraightDownBecomesADirectionAtTheHorizon)
{
    expect_unit_vectors_of_an_upright_back_vector<float>();
    expect_unit_vectors_of_an_upright_back_vector<double>();
}

// |h_bar| may round to more than 1: no root of less than 0.
TEST(BrdfCoordinates, PlaceInTheTableIsWithinItInFloat)
{
    for (const auto& [name, pair] : direction_pairs()) {
        const auto at = filter::hybrid_place(
            Directions<float>{filter::Vec3<float>(pair.wo), filter::Vec3<float>(pair.wi)});
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(at[i] >= 0 && at[i] <= 1) << text(name, pair) << ' ' << at;
    }
    const float more = std::nextafter(1.0F, 2.0F);
    const auto at = filter::hybrid_place(Directions<float>{{more, 0, 0}, {more, 0, 0}});
    EXPECT_EQ(at.x, 1);
}

// --- symmetries

TEST(BrdfCoordinates, ChangingViewerAndLightTurnsTheBackVector)
{
    for (const auto& [name, w] : direction_pairs()) {
        const Directions<double> swapped{w.wi, w.wo};
        const auto half = filter::half_difference(w), half2 = filter::half_difference(swapped);
        const auto flat = filter::orthographic(w), flat2 = filter::orthographic(swapped);
        const auto both = filter::hybrid(w), both2 = filter::hybrid(swapped);
        ASSERT_EQ(half.theta_h, half2.theta_h) << text(name, w);
        ASSERT_EQ(half.phi_h, half2.phi_h) << text(name, w);
        ASSERT_EQ(half.theta_d, half2.theta_d) << text(name, w);
        ASSERT_EQ(flat.h_bar, flat2.h_bar) << text(name, w);
        ASSERT_EQ(flat.k_bar, flat2.k_bar) << text(name, w);
        ASSERT_EQ(both.h_bar, both2.h_bar) << text(name, w);
        ASSERT_EQ(both.k, both2.k) << text(name, w);
        if (w.wo == w.wi)
            continue;
        ASSERT_LT(apart(half.phi_d + kPi, half2.phi_d), 1e-15) << text(name, w);
        ASSERT_LT(apart(both.phi_k + kPi, both2.phi_k), 1e-15) << text(name, w);
        if (flat.k_bar > 0) {
            ASSERT_LT(apart(flat.phi_k + kPi, flat2.phi_k), 1e-15) << text(name, w);
        }
    }
}

// Turned, mirrored, swapped: the reduced coordinates are the same, and those of the full ones.
TEST(BrdfCoordinates, IsotropicCoordinatesKnowNoAzimuthOfTheSurface)
{
    for (const auto& [name, w] : direction_pairs()) {
        const auto c = filter::isotropic_coordinates(w);
        const auto half = filter::half_difference(w);
        const auto flat = filter::orthographic(w);
        const auto both = filter::hybrid(w);
        EXPECT_NEAR(c.theta_h, half.theta_h, 1e-15);
        EXPECT_NEAR(c.theta_d, half.theta_d, 1e-15);
        EXPECT_NEAR(c.h_bar, flat.h_bar, 1e-15);
        EXPECT_NEAR(c.k_bar, flat.k_bar, 1e-15);
        EXPECT_NEAR(c.k, both.k, 1e-15);
        for (const double azimuth : {c.phi_d, c.azimuth}) {
            ASSERT_GE(azimuth, 0);
            ASSERT_LE(azimuth, kPi / 2 + 1e-15);
        }
        if (flat.h_bar < 1e-3 || flat.k_bar < 1e-3)
            continue;
        const auto folded = [](double angle) { return std::asin(std::abs(std::sin(angle))); };
        EXPECT_NEAR(std::sin(c.phi_d), std::sin(folded(half.phi_d)), 1e-12) << text(name, w);
        EXPECT_NEAR(std::sin(c.azimuth), std::sin(folded(flat.phi_k - flat.phi_h)), 1e-12);
        Directions<double> moved{{w.wi.y, -w.wi.x, w.wi.z}, {w.wo.y, -w.wo.x, w.wo.z}};
        for (const bool mirrored : {false, true}) {
            if (mirrored) {
                moved.wi.x = -moved.wi.x;
                moved.wo.x = -moved.wo.x;
            }
            const auto d = filter::isotropic_coordinates(moved);
            EXPECT_NEAR(c.theta_h, d.theta_h, 1e-14);
            EXPECT_NEAR(c.phi_d, d.phi_d, 1e-12) << text(name, w);
            EXPECT_NEAR(c.azimuth, d.azimuth, 1e-12) << text(name, w);
        }
    }
}

} // namespace
} // namespace scree::test
