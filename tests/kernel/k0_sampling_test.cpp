// Samples of K0 slopes, and of those a direction faces, against their densities: chi-square tests
// with fixed seeds. Expected counts come from integrals with Boost's Bessel functions.

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <random>
#include <vector>

#include "kernel/k0.h"

namespace scree::test {
namespace {

using filter::Slopes;
using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;

const double kPi = std::acos(-1.0);
const double kInfinity = std::numeric_limits<double>::infinity();

/// Chance of a chi-square as large as that of counts with these expectations; what is expected less
/// than ten times goes into one cell.
double chance(const std::vector<double>& counts, const std::vector<double>& expected)
{
    double square = 0, rare = 0, rare_expected = 0;
    int cells = 0;
    const auto add = [&](double count, double want) {
        square += (count - want) * (count - want) / want;
        ++cells;
    };
    for (size_t i = 0; i < counts.size(); ++i)
        if (expected[i] >= 10) {
            add(counts[i], expected[i]);
        } else {
            rare += counts[i];
            rare_expected += expected[i];
        }
    if (rare_expected >= 10)
        add(rare, rare_expected);
    else
        EXPECT_LE(rare, rare_expected + 6 * std::sqrt(rare_expected) + 6);
    EXPECT_GT(cells, 10);
    return boost::math::gamma_q((cells - 1) / 2.0, square / 2);
}

/// About 100 tests: with right samples the least of their p-values is below this once in 1000
/// seeds.
constexpr double kLeastChance = 1e-5;

template <typename Real>
class Numbers {
public:
    explicit Numbers(unsigned seed) : engine_(seed) {}

    /// Uniform in [0, 1), 0 included, with as many digits as a renderer may have.
    Real operator()() { return static_cast<Real>(engine_() >> 8U) / static_cast<Real>(1U << 24U); }

    template <size_t N>
    void fill(Real (&u)[N])
    {
        for (Real& value : u)
            value = (*this)();
    }

private:
    std::mt19937 engine_;
};

struct Law {
    double ms, mt, ss, st, tt;

    template <typename Real>
    Slopes<Real> slopes() const
    {
        return {{static_cast<Real>(ms), static_cast<Real>(mt)},
                {static_cast<Real>(ss), static_cast<Real>(st), static_cast<Real>(tt)},
                1};
    }
};

std::ostream& operator<<(std::ostream& out, const Law& law)
{
    return out << "mean " << law.ms << ' ' << law.mt << " covariance " << law.ss << ' ' << law.st
               << ' ' << law.tt;
}

std::vector<Law> laws()
{
    return {{0, 0, 0.09, 0, 0.09},
            {0.3, -0.2, 0.25, 0.05, 0.04},
            {-0.1, 0.4, 0.02, -0.03, 0.06},
            {1.5, 0.7, 0.01, 0, 0.3}};
}

/// Slopes in rings and sectors about the mean, in a frame where the law is round: Cholesky's.
class Rings {
public:
    static constexpr int kSectors = 24;

    explicit Rings(const Law& law) : law_(law)
    {
        l11_ = std::sqrt(law.ss);
        l21_ = law.st / l11_;
        l22_ = std::sqrt(law.tt - l21_ * l21_);
    }

    void count(double s, double t)
    {
        const double x = (s - law_.ms) / l11_, y = (t - law_.mt - l21_ * x) / l22_;
        const double d = std::hypot(x, y);
        const auto ring = std::upper_bound(edges_.begin(), edges_.end(), d) - edges_.begin() - 1;
        const double turn = std::atan2(y, x) / (2 * kPi) + 0.5;
        const int sector = std::min(static_cast<int>(turn * kSectors), kSectors - 1);
        counts_[static_cast<size_t>(ring * kSectors + sector)] += 1;
    }

    /// Of `samples` slopes weighted with max(wz - w . slope, 0).
    std::vector<double> expected(const Imath::V3d& w, int samples) const
    {
        const double a = w.z - w.x * law_.ms - w.y * law_.mt;
        const double bx = w.x * l11_ + w.y * l21_, by = w.y * l22_;
        const double b = std::hypot(bx, by), of_b = std::atan2(by, bx);
        std::vector<double> out;
        double sum = 0;
        for (size_t ring = 0; ring + 1 < edges_.size(); ++ring)
            for (int sector = 0; sector < kSectors; ++sector) {
                const double from = 2 * kPi * sector / kSectors - kPi - of_b;
                const auto weighted = [&](double d) {
                    return d * boost::math::cyl_bessel_k(0, std::sqrt(2.0) * d) *
                           facing(a, b * d, from, from + 2 * kPi / kSectors);
                };
                const double to = std::min(edges_[ring + 1], 40.0);
                // Weights begin at this distance: a kink.
                const double seam = b > 0 ? std::clamp(std::abs(a) / b, edges_[ring], to) : to;
                out.push_back(Rule::integrate(weighted, edges_[ring], seam, 8, 1e-7) +
                              Rule::integrate(weighted, seam, to, 8, 1e-7));
                sum += out.back();
            }
        for (double& value : out)
            value *= samples / sum;
        return out;
    }

    const std::vector<double>& counts() const { return counts_; }

private:
    /// Integral of max(a - r cos(phi), 0) over [from, to], shorter than a half turn.
    static double facing(double a, double r, double from, double to)
    {
        const auto whole = [&](double p, double q) {
            return q > p ? a * (q - p) - r * (std::sin(q) - std::sin(p)) : 0;
        };
        if (a >= r)
            return whole(from, to);
        if (a <= -r)
            return 0;
        const double open = std::acos(a / r); // weights are positive in (open, 2 pi - open)
        double sum = 0;
        for (int turn = -2; turn <= 2; ++turn)
            sum += whole(std::max(from, open + 2 * kPi * turn),
                         std::min(to, 2 * kPi - open + 2 * kPi * turn));
        return sum;
    }

    Law law_;
    double l11_, l21_, l22_;
    std::vector<double> edges_ = {0,   0.03, 0.1, 0.2, 0.35, 0.55, 0.8, 1.1, 1.5, 2,  2.5,
                                  3.2, 4,    5,   6,   7,    8.5,  10,  12,  15,  19, kInfinity};
    std::vector<double> counts_ =
        std::vector<double>((edges_.size() - 1) * static_cast<size_t>(kSectors));
};

constexpr int kSamples = 60000;

template <typename Real>
class K0Samples : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(K0Samples, Reals);

TYPED_TEST(K0Samples, FollowTheDensity)
{
    using Real = TypeParam;
    unsigned seed = 100;
    for (const Law& law : laws()) {
        Numbers<Real> numbers(++seed);
        Rings rings(law);
        Real u[3];
        for (int i = 0; i < 3 * kSamples; ++i) {
            numbers.fill(u);
            const auto slope = k0::sample(u, law.slopes<Real>());
            rings.count(static_cast<double>(slope.x), static_cast<double>(slope.y));
        }
        EXPECT_GT(chance(rings.counts(), rings.expected({0, 0, 1}, 3 * kSamples)), kLeastChance)
            << law;
    }
}

TYPED_TEST(K0Samples, OfFacingSlopesFollowTheirDensity)
{
    using Real = TypeParam;
    unsigned seed = 200;
    int averted = 0;
    double least = 1;
    for (const Law& law : laws())
        for (const double theta : {0.0, 1e-5, 0.7, 1.3, 1.55, 1.9})
            for (const double phi : {0.5, -2.2}) {
                const Imath::V3d w(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                   std::cos(theta));
                averted += w.z - w.x * law.ms - w.y * law.mt < 0 ? 1 : 0;
                Numbers<Real> numbers(++seed);
                Rings rings(law);
                const auto slopes = law.slopes<Real>();
                Real u[5];
                for (int i = 0; i < kSamples; ++i) {
                    numbers.fill(u);
                    const auto slope = k0::sample_visible(u, filter::Vec3<Real>(w), slopes);
                    const auto s = static_cast<double>(slope.x), t = static_cast<double>(slope.y);
                    ASSERT_GE(w.z - w.x * s - w.y * t, -1e-6 * (1 + std::abs(s) + std::abs(t)));
                    rings.count(s, t);
                }
                const double p = chance(rings.counts(), rings.expected(w, kSamples));
                least = std::min(least, p);
                EXPECT_GT(p, kLeastChance) << law << " view " << w;
            }
    EXPECT_GT(averted, 8);
    this->RecordProperty("least_chance", std::to_string(least));
}

/// Counts of `draw` in cells that are to have the same share each of the density over (from, to).
template <typename Density, typename Draw>
double chance_along(const Density& density, double from, double to, const Draw& draw)
{
    // The distribution at many places, linear in between: cells are found in the same way as the
    // numbers, so that this is not an error.
    const int places = 4000, cells = 40;
    std::vector<double> at, below = {0};
    for (int i = 0; i <= places; ++i)
        at.push_back(from + (to - from) * i / places);
    for (int i = 0; i < places; ++i) {
        const auto n = static_cast<size_t>(i);
        below.push_back(below.back() + Rule::integrate(density, at[n], at[n + 1], 0));
    }
    std::vector<double> edges, expected;
    double before = 0;
    for (size_t i = 1; i < at.size(); ++i)
        if (below[i] - before >= below.back() / cells || i + 1 == at.size()) {
            edges.push_back(at[i]);
            expected.push_back((below[i] - before) / below.back() * kSamples);
            before = below[i];
        }
    std::vector<double> counts(edges.size());
    for (int i = 0; i < kSamples; ++i) {
        const double value = draw();
        EXPECT_GE(value, from - 1e-6);
        const auto cell = std::lower_bound(edges.begin(), edges.end(), value) - edges.begin();
        counts[std::min(static_cast<size_t>(cell), counts.size() - 1)] += 1;
    }
    return chance(counts, expected);
}

// The part along the view alone, where the two-dimensional cells are coarse: mean planes turned
// away, a hair's breadth from grazing, upright views.
TYPED_TEST(K0Samples, AlongTheViewFollowTheWeightedLaplaceLaw)
{
    using Real = TypeParam;
    unsigned seed = 300;
    for (const double z : {-300.0, -3.0, -1e-3, 0.0, 1e-3, 0.2, 1.0, 4.0, 30.0, 1e18}) {
        Numbers<Real> numbers(++seed);
        const double most = std::min(z, 12.0), low = std::min(z, 0.0) - 14;
        const double scale = std::max(1.0, std::abs(z));
        const auto density = [&](double x) {
            return (z - x) / scale * std::exp(-std::sqrt(2.0) * (std::abs(x) - std::max(-z, 0.0)));
        };
        EXPECT_GT(chance_along(density, low, most,
                               [&] {
                                   const Real u = numbers(), v = numbers();
                                   return static_cast<double>(
                                       kernel::scree_k0_visible_along(static_cast<Real>(z), u, v));
                               }),
                  kLeastChance)
            << z;
    }
}

// r = sqrt(e): density exp(-r^2 - x^2 / (2 r^2)), from a normal number by Box and Muller.
TYPED_TEST(K0Samples, DeviationOfTheMixtureFollowsItsLawGivenTheSlope)
{
    using Real = TypeParam;
    unsigned seed = 400;
    const Real kTurn = static_cast<Real>(2 * std::acos(-1.0));
    for (const double x : {0.0, 1e-4, 0.1, 1.0, -1.0, 6.0, 300.0}) {
        Numbers<Real> numbers(++seed);
        const double middle = std::sqrt(std::abs(x) / std::sqrt(2.0));
        const auto density = [&](double r) {
            const double apart = r - std::abs(x) / (std::sqrt(2.0) * r);
            return r > 0 ? std::exp(-apart * apart) : 0;
        };
        EXPECT_GT(chance_along(density, std::max(0.0, middle - 6), middle + 6,
                               [&] {
                                   const Real u = numbers(), turn = numbers(), choice = numbers();
                                   Real c = 0, s = 0;
                                   kernel::scree_sine_cosine(kTurn * turn, s, c);
                                   const Real gauss =
                                       std::sqrt(2 * kernel::scree_exponential(u)) * c;
                                   return static_cast<double>(kernel::scree_k0_deviation(
                                       static_cast<Real>(x), gauss, choice));
                               }),
                  kLeastChance)
            << x;
    }
}

// A groove has slopes along one direction only, whether the view crosses it or looks along it.
TYPED_TEST(K0Samples, OfGroovesAndPlanesStayOnThem)
{
    using Real = TypeParam;
    Numbers<Real> numbers(500);
    const Slopes<Real> groove{{Real(0.1), Real(-0.2)}, {Real(0.25), 0, 0}, 1};
    const Slopes<Real> plane{{Real(0.1), Real(-0.2)}, {0, 0, 0}, 1};
    double square = 0, across = 0;
    Real u[5], u3[3];
    for (int i = 0; i < 20000; ++i) {
        numbers.fill(u);
        numbers.fill(u3);
        for (const auto& w :
             {filter::Vec3<Real>(Real(0.6), 0, Real(0.8)),
              filter::Vec3<Real>(0, Real(0.6), Real(0.8)), filter::Vec3<Real>(0, 0, 1)}) {
            EXPECT_EQ(k0::sample_visible(u, w, plane), plane.mean);
            EXPECT_EQ(k0::sample_visible(u, w, groove).y, groove.mean.y);
        }
        EXPECT_EQ(k0::sample(u3, plane), plane.mean);
        const auto any = k0::sample(u3, groove);
        EXPECT_EQ(any.y, groove.mean.y);
        square += std::pow(static_cast<double>(any.x - groove.mean.x), 2) / 20000;
        // Along the groove all of it shows alike.
        const auto along = k0::sample_visible(u, {0, Real(0.6), Real(0.8)}, groove);
        across += std::pow(static_cast<double>(along.x - groove.mean.x), 2) / 20000;
    }
    // Standard error of the variance: 0.25 sqrt((6 - 1) / 20000) = 0.004; four of them.
    EXPECT_NEAR(square, 0.25, 0.016);
    EXPECT_NEAR(across, 0.25, 0.016);
}

// The same groove turned by 90 degrees: s and t change places, and nothing else.
TYPED_TEST(K0Samples, OfAGrooveAlongSAreThoseOfOneAlongT)
{
    using Real = TypeParam;
    Numbers<Real> numbers(501);
    const Slopes<Real> across_s{{Real(0.1), Real(-0.2)}, {Real(0.25), 0, 0}, 1};
    const Slopes<Real> across_t{{Real(-0.2), Real(0.1)}, {0, 0, Real(0.25)}, 1};
    Real u[5], u3[3];
    Real most = 0;
    for (int i = 0; i < 1000; ++i) {
        numbers.fill(u);
        numbers.fill(u3);
        const auto s = k0::sample(u3, across_s), t = k0::sample(u3, across_t);
        EXPECT_EQ(t.x, s.y);
        EXPECT_EQ(t.y, s.x);
        const filter::Vec3<Real> along_t(0, Real(0.6), Real(0.8)), along_s(Real(0.6), 0, Real(0.8));
        const auto seen_s = k0::sample_visible(u, along_t, across_s);
        const auto seen_t = k0::sample_visible(u, along_s, across_t);
        EXPECT_EQ(seen_t.y, seen_s.x);
        most = std::max({most, std::abs(t.y - Real(0.1)), std::abs(seen_t.y - Real(0.1))});
    }
    EXPECT_GT(most, 1);
}

TYPED_TEST(K0Samples, AreNumbersAtTheEndsOfTheRandomNumbers)
{
    using Real = TypeParam;
    const Real ends[] = {0, Real(1) - std::numeric_limits<Real>::epsilon() / 2, Real(0.5)};
    const auto slopes = laws()[1].slopes<Real>();
    for (int n = 0; n < 243; ++n) {
        Real u[5];
        for (int i = 0, rest = n; i < 5; ++i, rest /= 3)
            u[i] = ends[rest % 3];
        for (const auto& w :
             {filter::Vec3<Real>(0, 0, 1), filter::Vec3<Real>(Real(0.8), 0, Real(0.6)),
              filter::Vec3<Real>(1, 0, 0), filter::Vec3<Real>(0, 0, -1)}) {
            const auto slope = k0::sample_visible(u, w, slopes);
            EXPECT_TRUE(std::isfinite(slope.x) && std::isfinite(slope.y)) << n << ' ' << w;
            EXPECT_LT(std::abs(slope.x) + std::abs(slope.y), 200) << n << ' ' << w;
        }
    }
}

// What estimators divide by is what the sampler draws from.
TEST(K0VisibleDensity, IsFacingAreaPerProjectedArea)
{
    for (const Law& law : laws())
        for (const double theta : {0.0, 0.9, 1.5, 2.0}) {
            const Imath::V3d w(std::sin(theta) * 0.6, std::sin(theta) * 0.8, std::cos(theta));
            const auto slopes = law.slopes<double>();
            for (const double d : {-1.5, -0.2, 0.3, 2.0}) {
                const Imath::V2d slope(law.ms + d * 0.3, law.mt - d * 0.1);
                const double weight = w.z - w.x * slope.x - w.y * slope.y;
                const double want = std::max(weight, 0.0) * k0::slope_pdf(slope, slopes) /
                                    k0::projected_area(w, slopes);
                EXPECT_NEAR(k0::visible_slope_pdf(slope, w, slopes), want, 1e-12 * want) << law;
            }
        }
    // From straight below nothing is seen: 0, not 0 / 0.
    EXPECT_EQ(k0::visible_slope_pdf({0.1, 0.2}, {0, 0, -1}, laws()[0].slopes<double>()), 0);
}

} // namespace
} // namespace scree::test
