#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>

#include "kernel/cases.h"
#include "kernel/oracle.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

struct Answered {
    KernelCase row;
    Outputs<double> want;
};

/// The kernel's accuracy holds above it; below, its visible slopes keep a variance of 2e-8.
constexpr double kFarthestAverted = -1e4;

/// Every row of the table that has an oracle, with its answers.
const std::vector<Answered>& answered_cases()
{
    static const std::vector<Answered> all = [] {
        std::vector<Answered> answered;
        for (const KernelCase& row : kernel_cases())
            if (has_oracle(row))
                answered.push_back({row, oracle(row)});
        return answered;
    }();
    return all;
}

double at(const KernelCase& row, int input) { return row.in[static_cast<size_t>(input)]; }
double at(const Outputs<double>& out, int output) { return out[static_cast<size_t>(output)]; }

template <typename Real>
Outputs<double> evaluate_as_double(const KernelCase& row)
{
    const Outputs<Real> got = evaluate<Real>(row);
    Outputs<double> out;
    std::copy(got.begin(), got.end(), out.begin());
    return out;
}

// --- the table ----------------------------------------------------------------------------------

TEST(KernelCases, HoldEveryFamilyAndSeveralHundredRows)
{
    const auto rows = kernel_cases();
    EXPECT_GT(rows.size(), 800U);
    auto count = [&](const std::string& start) {
        return std::count_if(rows.begin(), rows.end(), [&](const KernelCase& row) {
            return row.name.compare(0, start.size(), start) == 0;
        });
    };
    EXPECT_EQ(count("table 3 row "), 5);
    for (const char* family : {"1 ", "2 grazing", "3 mean plane turned away", "4 flat", "4 plane",
                               "4 groove", "4 diagonal", "4 oblique", "5 variance below 0",
                               "5 determinant below 0", "6 groove at +45", "6 groove at -45",
                               "7 V-groove", "8 heavy tails", "9 two heights", "9 one height"})
        EXPECT_GE(count(family), 3) << family;
    EXPECT_GE(count("sweep z "), 600);
    EXPECT_GE(count("surface "), 100);

    std::set<std::string> seen; // z from -40 to 40, all ratios, all correlations, tails
    double lowest = 0, highest = 0;
    int gaussian = 0, k0 = 0, mixed = 0;
    for (const KernelCase& row : rows) {
        const double tau = at(row, kTau);
        ++(tau == 0 ? gaussian : tau == 1 ? k0 : mixed);
        if (row.name.compare(0, 5, "sweep") != 0)
            continue;
        seen.insert(row.name.substr(row.name.find("ratio"),
                                    row.name.find(" tau") - row.name.find("ratio")));
        lowest = std::min(lowest, grazing_distance(row));
        highest = std::max(highest, grazing_distance(row));
    }
    EXPECT_EQ(seen.size(), 16U);
    EXPECT_LT(lowest, -39);
    EXPECT_GT(highest, 39);
    EXPECT_GT(gaussian, 400);
    EXPECT_GT(k0, 60);
    EXPECT_GT(mixed, 100);
}

TEST(KernelCases, HaveAnOracleButWhereTheCovarianceIsNone)
{
    int without = 0;
    for (const KernelCase& row : kernel_cases())
        if (!has_oracle(row)) {
            ++without;
            EXPECT_EQ(row.name.substr(0, 2), "5 ") << describe(row);
        }
    EXPECT_EQ(without, 6);
}

// --- the oracle, against the definition ---------------------------------------------------------

/// Sums over composite Gauss-Legendre nodes: 20 points on each of `panels` equal panels.
template <typename F>
void integrate(double low, double high, int panels, F&& add)
{
    using Rule = boost::math::quadrature::gauss<double, 20>;
    const double half = (high - low) / (2 * panels);
    for (int panel = 0; panel < panels; ++panel) {
        const double centre = low + (2 * panel + 1) * half;
        for (size_t i = 0; i < Rule::abscissa().size(); ++i)
            for (double side : {-1.0, 1.0})
                add(centre + side * half * Rule::abscissa()[i], half * Rule::weights()[i]);
    }
}

/// The definition for a Gaussian, by quadrature in two dimensions over the facing half plane:
/// E[W], mean and covariance under the weight W. Central moments in a second pass.
struct ByQuadrature {
    double area = 0, s = 0, t = 0, ss = 0, st = 0, tt = 0;

    explicit ByQuadrature(const KernelCase& row)
    {
        each_facet(row, [&](double x, double y, double weight) {
            area += weight, s += weight * x, t += weight * y;
        });
        s /= area, t /= area;
        each_facet(row, [&](double x, double y, double weight) {
            ss += weight * (x - s) * (x - s) / area;
            st += weight * (x - s) * (y - t) / area;
            tt += weight * (y - t) * (y - t) / area;
        });
    }

private:
    /// Calls add(slope_s, slope_t, W p ds dt) for nodes that cover what counts. The first axis runs
    /// along the view from its horizon W = 0, where the integrand has its kink, the second across.
    template <typename F>
    static void each_facet(const KernelCase& row, F&& add)
    {
        const double wx = at(row, kWox), wy = at(row, kWoy), wz = at(row, kWoz);
        const double ms = at(row, kMeanS), mt = at(row, kMeanT);
        const double css = at(row, kCss), cst = at(row, kCst), ctt = at(row, kCtt);
        const double det = css * ctt - cst * cst; // the products are exact
        const double sin = std::hypot(wx, wy), horizon = wz / sin;
        const double ex = wx / sin, ey = wy / sin;
        // Where to look, not what to add: deviations along, and across at a given slope along.
        const double mean = ms * ex + mt * ey;
        const double pivot = std::max(css, ctt), x = css >= ctt ? ex : ey, y = css >= ctt ? ey : ex;
        const double along = std::sqrt((std::pow(pivot * x + cst * y, 2) + det * y * y) / pivot);
        const double across = std::sqrt(det) / along;
        const double lean = ((ctt - css) * ex * ey + cst * (ex * ex - ey * ey)) / (along * along);
        const double high = std::min(horizon, mean + 9 * along);
        const double low = std::min(horizon, mean) - 9 * along;
        const int panels = std::max(4, static_cast<int>((high - low) / along));
        integrate(low, high, panels, [&](double o, double weight_o) {
            const double centre = -ms * ey + mt * ex + lean * (o - mean);
            const double visible = sin * (horizon - o), step = across / 2;
            for (int i = -17; i <= 17; ++i) { // trapezoidal: exact for a Gaussian to 1e-16
                const double p = centre + i * step;
                const double slope_s = o * ex - p * ey, slope_t = o * ey + p * ex;
                const double ds = slope_s - ms, dt = slope_t - mt;
                const double q = (ctt * ds * ds - 2 * cst * ds * dt + css * dt * dt) / det;
                const double density = std::exp(-q / 2) / (2 * kPi * std::sqrt(det));
                add(slope_s, slope_t, visible * density * weight_o * step);
            }
        });
    }
};

// Tolerance: rounding of the quadrature in double. In q three terms as large as 1 / (1 - rho^2)
// times the ratio of variances cancel, so long thin covariances count by that.
TEST(SlopeOracle, IsTheDefinitionForGaussianSlopes)
{
    int compared = 0;
    for (const auto& [row, want] : answered_cases()) {
        const double css = at(row, kCss), cst = at(row, kCst), ctt = at(row, kCtt);
        const double z = grazing_distance(row);
        const double trace = css + ctt, det = css * ctt - cst * cst;
        const double thin = trace * trace / det;
        if (at(row, kTau) != 0 || std::abs(z) > 8.2 || !(thin < 1e5))
            continue;
        const ByQuadrature got(row);
        const double visible = at(want, kVisibleSs) + at(want, kVisibleTt);
        EXPECT_NEAR(got.area / at(want, kArea), 1, 1e-10) << describe(row);
        const double facing =
            at(row, kWoz) - at(row, kWox) * at(row, kMeanS) - at(row, kWoy) * at(row, kMeanT);
        if (z > 0.1) {
            EXPECT_NEAR(got.area / facing - 1, at(want, kLambda), 1e-9) << describe(row);
        }
        EXPECT_NEAR(got.s, at(want, kVisibleS), 1e-10 * std::sqrt(trace)) << describe(row);
        EXPECT_NEAR(got.t, at(want, kVisibleT), 1e-10 * std::sqrt(trace)) << describe(row);
        EXPECT_NEAR(got.ss, at(want, kVisibleSs), 1e-10 * visible) << describe(row);
        EXPECT_NEAR(got.st, at(want, kVisibleSt), 1e-10 * visible) << describe(row);
        EXPECT_NEAR(got.tt, at(want, kVisibleTt), 1e-10 * visible) << describe(row);
        ++compared;
    }
    EXPECT_GT(compared, 150);
}

// The definition of K0: an exponential mixture of Gaussians, integrated over the mixing variable
// x = exp(v - exp(-v)) by the trapezoidal rule; the Gaussian part is the one the test above checks.
TEST(SlopeOracle, IsTheExponentialMixtureForHeavyTails)
{
    int compared = 0;
    for (const auto& [row, want] : answered_cases()) {
        const double tau = at(row, kTau), z = grazing_distance(row);
        if (tau == 0 || std::abs(z) > 8.2)
            continue;
        const double s = at(want, kVisibleS), t = at(want, kVisibleT);
        FacingMoments sum{0, 0, 0, 0, 0, 0};
        auto add = [&](double weight, double spread) {
            const FacingMoments m = gaussian_facing_moments(row, spread, s, t);
            sum.area += weight * m.area, sum.s += weight * m.s, sum.t += weight * m.t;
            sum.ss += weight * m.ss, sum.st += weight * m.st, sum.tt += weight * m.tt;
        };
        add(1 - tau, 1);
        const double step = 1.0 / 16;
        for (double v = -3.5; v <= 4.25; v += step) {
            const double x = std::exp(v - std::exp(-v));
            add(tau * std::exp(-x) * x * (1 + std::exp(-v)) * step, x);
        }
        const double sigma = std::sqrt(at(row, kCss) + at(row, kCtt));
        const double visible = at(want, kVisibleSs) + at(want, kVisibleTt);
        EXPECT_NEAR(sum.area / at(want, kArea), 1, 1e-10) << describe(row);
        EXPECT_NEAR(sum.s / sum.area, 0, 1e-10 * sigma) << describe(row);
        EXPECT_NEAR(sum.t / sum.area, 0, 1e-10 * sigma) << describe(row);
        EXPECT_NEAR(sum.ss / sum.area, at(want, kVisibleSs), 1e-10 * visible) << describe(row);
        EXPECT_NEAR(sum.st / sum.area, at(want, kVisibleSt), 1e-10 * visible) << describe(row);
        EXPECT_NEAR(sum.tt / sum.area, at(want, kVisibleTt), 1e-10 * visible) << describe(row);
        ++compared;
    }
    EXPECT_GT(compared, 100);
}

TEST(SlopeOracle, HasDigitsToSpare)
{
    int compared = 0;
    for (const auto& [row, want] : answered_cases()) {
        const Outputs<double> fewer = oracle(row, Digits::k60);
        for (int i = 0; i < kOutputs; ++i, ++compared)
            EXPECT_NEAR(at(fewer, i), at(want, i), 4e-16 * std::abs(at(want, i)) + 1e-50)
                << output_name(i) << ' ' << describe(row);
    }
    EXPECT_GT(compared, 20000);
}

TEST(SlopeOracle, KnowsTheLargestOfTwoAndThreeNormals)
{
    Outputs<double> out{};
    const KernelCase row = kernel_cases().front();
    take_exponent(row, 0, out);
    EXPECT_NEAR(at(out, kHeightMean), 0, 1e-14);
    EXPECT_NEAR(at(out, kHeightVariance), 1, 1e-14);
    take_exponent(row, 1, out);
    EXPECT_NEAR(at(out, kHeightMean), 1 / std::sqrt(kPi), 1e-14);
    EXPECT_NEAR(at(out, kHeightVariance), 1 - 1 / kPi, 1e-14);
    take_exponent(row, 2, out);
    EXPECT_NEAR(at(out, kHeightMean), 1.5 / std::sqrt(kPi), 1e-14);
}

// --- the kernel, against the oracle -------------------------------------------------------------

struct Tolerance {
    int output;
    double single, dual; ///< float and double, in units of unit_of()
};

// The single column is rounding (2^-24 = 6e-8 a step) but for the fit of the visible height; the
// double one is the kernel's fits.
const Tolerance kTolerances[] = {
    {kRawCss, 1.2e-7, 2e-16}, // of the variances' sum: one rounding
    {kRawCst, 1.2e-7, 2e-16},
    {kRawCtt, 1.2e-7, 2e-16},
    // relative; at z = -12.5 N goes as exp(-z^2 / 2), and each rounding of a, b and z is 9e-6 there
    {kArea, 3e-5, 1e-8},
    {kProjected, 3e-5, 1e-8},
    // of sqrt(trace C): rounding alone, of slopes that lie up to z = -124 deviations from the mean;
    // each is 7e-6 there
    {kVisibleS, 3e-5, 8e-9},
    {kVisibleT, 3e-5, 8e-9},
    {kVisibleSs, 3e-6, 1.05e-6}, // of trace C_vis; the kernel raises variances by 1e-6 if need be
    {kVisibleSt, 2e-6, 4e-8},
    {kVisibleTt, 3e-6, 1.05e-6},
    {kLambda, 3e-5, 1e-8},         // relative; likewise at z = 12
    {kG1, 3e-7, 5e-9},             // relative, near z = 0 too: a is computed to its own rounding
    {kHeightMean, 1e-6, 1e-6},     // relative: the fit
    {kHeightVariance, 2e-6, 2e-6}, // relative: the fit
    {kByHeight, 2e-6, 1e-6},       // of the color white: the fit of the height
    {kByRank, 2e-7, 1e-15},
    {kBySlope, 1e-6, 2e-9},
    {kMapU, 6e-7, 4e-7}, // of the table's width: the fit of the height
    {kMapV, 6e-7, 6e-7},
    {kAlphaX, 2e-7, 4e-16}, // relative
    {kAlphaY, 2e-7, 4e-16},
    {kAngle, 2e-7, 1e-8},    // radians
    {kSpecular, 1e-5, 1e-8}, // relative to itself times 1 + |log|: exp(-q / 2) feels q's rounding
    {kAlong, 3e-7, 1e-15},   // relative
    {kSteepness, 2e-7, 4e-16},
    {kSteepnessSpread, 2e-7, 4e-16},
    {kNodeCoordinate, 3e-7, 6e-16}, // relative
    {kNodeShare, 4e-7, 8e-16},      // of 1: rounding of coordinates up to 100, 80 apart
    {kAxisCosine, 3e-7, 6e-16},     // relative
    {kCos1, 2e-7, 4e-16},           // relative
    {kCos2, 4e-7, 8e-16},
    {kSin1, 2e-7, 4e-16},
    {kSin2, 4e-7, 8e-16},
    {kVisibleArea, 2e-7, 4e-16},
    {kByVisibility, 4e-7, 8e-16}, // of the terms it is the sum of
    {kOverlap, 2e-7, 4e-16},      // of 1: the sum may cancel to 0.05
    {kSeenAndLit, 8e-7, 1.6e-15}, // of the terms it is the sum of
    {kRawLambda, 3e-5, 1e-8},     // relative, as kLambda
    {kMeasured, 6e-7, 5e-14},     // relative; the oracle goes by logarithms up to 700
};

/// Largest term of the visible color by tables.
double table_unit(const KernelCase& row, const Outputs<double>& want)
{
    const double c = at(row, kTableC), a = at(row, kA), v = std::max(1 + a, 1.0 / 4);
    return std::max(
        {at(want, kByVisibility), c, std::abs(at(row, kBeta)) / v, std::abs(a * c) / v});
}

double unit_of(int output, const KernelCase& row, const Outputs<double>& want)
{
    switch (output) {
    case kRawCss:
    case kRawCst:
    case kRawCtt:
        return at(want, kRawCss) + at(want, kRawCtt);
    case kVisibleS:
    case kVisibleT:
        return std::sqrt(at(row, kCss) + at(row, kCtt));
    case kVisibleSs:
    case kVisibleSt:
    case kVisibleTt:
        return at(want, kVisibleSs) + at(want, kVisibleTt);
    case kHeightMean:
        return at(want, kHeightMean) + 1e-9; // the oracle's own rounding: 1e-17
    case kByHeight:
    case kByRank:
    case kBySlope:
    case kMapU:
    case kMapV:
    case kAngle:
    case kNodeShare:
    case kOverlap:
        return 1;
    case kCos1:
    case kCos2:
    case kSin1:
    case kSin2:
        return std::abs(at(want, output)) + 1e-80; // the oracle's own rounding: 1e-100
    case kByVisibility:
        return table_unit(row, want);
    case kSeenAndLit:
        return std::max(table_unit(row, want), at(row, kLitC));
    case kSpecular:
        return at(want, output) * (1 + std::abs(std::log(at(want, output))));
    default:
        return std::abs(at(want, output));
    }
}

/// Below it an output may be any smaller number, 0 too: the type's smallest normal number; for the
/// highlight what 2^-118 (2^-1000), where the kernel's exp ends, is worth over a small visible
/// area.
template <typename Real>
double floor_of(int output)
{
    const double smallest = std::numeric_limits<Real>::min();
    switch (output) {
    case kArea:
    case kProjected:
    case kLambda:
    case kRawLambda:
        return 1.03 * smallest;
    case kMeasured:
        return smallest;
    case kSpecular:
        return sizeof(Real) == 4 ? 1e-20 : 1e-280;
    default:
        return 0;
    }
}

/// The error in units of the tolerance: at most 1 where the kernel is right.
template <typename Real>
double misses(const Tolerance& tolerance, const KernelCase& row, const Outputs<double>& got,
              const Outputs<double>& want)
{
    const double x = at(got, tolerance.output), y = at(want, tolerance.output);
    if (!std::isfinite(x))
        return std::numeric_limits<double>::infinity();
    const double floor = floor_of<Real>(tolerance.output);
    if (y < floor && x >= 0 && x <= floor)
        return 0;
    double error = std::abs(x - y);
    if (tolerance.output == kAngle) // an axis, not an arrow
        error = std::abs(std::remainder(error, kPi));
    const double allowed = sizeof(Real) == 4 ? tolerance.single : tolerance.dual;
    return error > 0 ? error / (allowed * unit_of(tolerance.output, row, want)) : 0;
}

template <typename Real>
void expect_the_oracle(int first, int last)
{
    for (const Tolerance& tolerance : kTolerances) {
        if (tolerance.output < first || tolerance.output > last)
            continue;
        const char* const name = output_name(tolerance.output);
        double worst = 0;
        const KernelCase* worst_row = nullptr;
        for (const auto& [row, answer] : answered_cases()) {
            if (grazing_distance(row) < kFarthestAverted)
                continue;
            const Outputs<double> got = evaluate_as_double<Real>(row);
            Outputs<double> want = answer;
            take_exponent(row, at(got, kLambda), want);
            take_raw_lambda(row, at(got, kRawLambda), want);
            const double miss = misses<Real>(tolerance, row, got, want);
            EXPECT_LE(miss, 1) << name << " is " << at(got, tolerance.output) << ", not "
                               << at(want, tolerance.output) << ", at z " << grazing_distance(row)
                               << " of " << describe(row);
            if (miss >= worst)
                worst = miss, worst_row = &row;
        }
        ASSERT_NE(worst_row, nullptr);
        const double allowed = sizeof(Real) == 4 ? tolerance.single : tolerance.dual;
        std::string key = std::string("worst ") + name;
        std::replace(key.begin(), key.end(), ' ', '_');
        std::ostringstream text;
        text << worst * allowed << " at " << worst_row->name;
        testing::Test::RecordProperty(key, text.str());
    }
}

TEST(VisibleSlopes, AreTheOraclesInSinglePrecision)
{
    expect_the_oracle<float>(kArea, kG1);
    expect_the_oracle<float>(kProjected, kProjected);
}

TEST(VisibleSlopes, AreTheOraclesInDoublePrecision)
{
    expect_the_oracle<double>(kArea, kG1);
    expect_the_oracle<double>(kProjected, kProjected);
}

TEST(KernelOutputs, AreTheOraclesInSinglePrecision)
{
    expect_the_oracle<float>(kRawCss, kRawCtt);
    expect_the_oracle<float>(kHeightMean, kSpecular);
    expect_the_oracle<float>(kAlong, kMeasured);
}

TEST(KernelOutputs, AreTheOraclesInDoublePrecision)
{
    expect_the_oracle<double>(kRawCss, kRawCtt);
    expect_the_oracle<double>(kHeightMean, kSpecular);
    expect_the_oracle<double>(kAlong, kMeasured);
}

// What the coarser tolerance of the variances in double stands for: nothing but the raise.
TEST(VisibleSlopes, AreRaisedOnlyWhereTheDeterminantVanishes)
{
    int raised = 0;
    for (const auto& [row, want] : answered_cases()) {
        if (grazing_distance(row) < kFarthestAverted)
            continue;
        const Outputs<double> got = evaluate<double>(row);
        const double ss = at(want, kVisibleSs), st = at(want, kVisibleSt),
                     tt = at(want, kVisibleTt);
        const bool singular = st * st > ss * tt * (1 - 1.1e-6);
        raised += singular;
        const double slack = 4e-8 * (ss + tt), more = singular ? 1.05e-6 : 0;
        EXPECT_LE(at(got, kVisibleSs), ss * (1 + more) + slack) << describe(row);
        EXPECT_LE(at(got, kVisibleTt), tt * (1 + more) + slack) << describe(row);
        EXPECT_GE(at(got, kVisibleSs), ss - slack) << describe(row);
        EXPECT_GE(at(got, kVisibleTt), tt - slack) << describe(row);
    }
    EXPECT_GT(raised, 0);
    EXPECT_LT(raised, 60);
}

// Seen along a groove, with the mean plane turned away: z is -3e15. What is seen is the plane of
// grazing slopes, far from the mean; its variance is nothing, and the kernel's next to nothing.
TEST(VisibleSlopes, AreTheGrazingOnesFarBelowTheHorizon)
{
    int compared = 0;
    for (const auto& [row, want] : answered_cases()) {
        if (!(grazing_distance(row) < kFarthestAverted))
            continue;
        const Outputs<double> single = evaluate_as_double<float>(row), got = evaluate<double>(row);
        const double size = std::hypot(at(want, kVisibleS), at(want, kVisibleT));
        for (int i : {kVisibleS, kVisibleT}) {
            EXPECT_NEAR(at(single, i), at(want, i), 2e-7 * size) << describe(row);
            EXPECT_NEAR(at(got, i), at(want, i), 1e-12 * size) << describe(row);
        }
        const double variance = at(row, kCss) + at(row, kCtt);
        for (int i : {kVisibleSs, kVisibleSt, kVisibleTt}) {
            EXPECT_NEAR(at(single, i), at(want, i), 2.1e-8 * variance) << describe(row);
            EXPECT_NEAR(at(got, i), at(want, i), 2.1e-8 * variance) << describe(row);
        }
        EXPECT_EQ(at(single, kArea), 0) << describe(row);
        ++compared;
    }
    EXPECT_EQ(compared, 1);
}

template <typename Real>
void expect_finite()
{
    for (const KernelCase& row : kernel_cases()) {
        const Outputs<Real> got = evaluate<Real>(row);
        for (int i = 0; i < kOutputs; ++i)
            EXPECT_TRUE(std::isfinite(got[static_cast<size_t>(i)]))
                << output_name(i) << ' ' << describe(row);
    }
}

TEST(KernelOutputs, AreFiniteInSinglePrecision) { expect_finite<float>(); }
TEST(KernelOutputs, AreFiniteInDoublePrecision) { expect_finite<double>(); }

template <typename Real>
void expect_semi_definite()
{
    for (const KernelCase& row : kernel_cases()) {
        const auto got = evaluate_as_double<Real>(row);
        EXPECT_TRUE(
            positive_semi_definite(at(got, kVisibleSs), at(got, kVisibleSt), at(got, kVisibleTt)))
            << at(got, kVisibleSs) << ' ' << at(got, kVisibleSt) << ' ' << at(got, kVisibleTt)
            << ' ' << describe(row);
    }
}

TEST(VisibleSlopes, HaveASemiDefiniteCovarianceInSinglePrecision) { expect_semi_definite<float>(); }

TEST(VisibleSlopes, HaveASemiDefiniteCovarianceInDoublePrecision)
{
    expect_semi_definite<double>();
}

// --- the comparisons themselves -----------------------------------------------------------------

// A formula with the sign of a term wrong is a kernel given the wrong input.
TEST(Comparisons, NoticeAWrongSign)
{
    struct Mistake {
        const char* name;
        int input;
        double factor;
        int output;
    };
    const Mistake mistakes[] = {
        {"covariance negated", kCst, -1, kVisibleSt},
        {"covariance dropped", kCst, 0, kVisibleSt},
        {"covariance negated", kCst, -1, kArea},
        {"mean negated", kMeanS, -1, kVisibleS},
        {"mean dropped", kMeanT, 0, kVisibleT},
        {"mean dropped", kMeanS, 0, kVisibleSs},
        {"view mirrored", kWox, -1, kVisibleT},
        {"tails dropped", kTau, 0, kVisibleSs},
        {"tails dropped", kTau, 0, kArea},
        {"tails dropped", kTau, 0, kLambda},
        {"variance for its root", kCtt, 2, kG1},
    };
    for (const Mistake& mistake : mistakes) {
        const auto tolerance =
            std::find_if(std::begin(kTolerances), std::end(kTolerances),
                         [&](const Tolerance& t) { return t.output == mistake.output; });
        ASSERT_NE(tolerance, std::end(kTolerances));
        int tried = 0, noticed = 0;
        for (const auto& [row, want] : answered_cases()) {
            const double z = grazing_distance(row), css = at(row, kCss), ctt = at(row, kCtt);
            // Where the term matters: a surface rough in both directions, seen at an angle.
            if (std::abs(z) > 3 || std::min(css, ctt) < 1e-4 * std::max(css, ctt) ||
                std::abs(at(row, kCst)) < 0.1 * std::sqrt(css * ctt) ||
                std::abs(at(row, kWox) * at(row, kWoy)) < 0.01 ||
                std::abs(at(row, kMeanS)) < 0.01 || std::abs(at(row, kMeanT)) < 0.01)
                continue;
            if (mistake.input == kTau && at(row, kTau) < 0.1)
                continue;
            KernelCase wrong = row;
            wrong.in[static_cast<size_t>(mistake.input)] *= static_cast<float>(mistake.factor);
            ++tried;
            noticed += misses<float>(*tolerance, row, evaluate_as_double<float>(wrong), want) > 100;
        }
        EXPECT_GE(tried, 10) << mistake.name;
        EXPECT_GE(noticed, tried / 2)
            << mistake.name << " in " << output_name(mistake.output) << ", rows " << tried;
    }
}

// One percent of some input is more than its tolerance to every output, in one row or another.
TEST(Comparisons, NoticeOnePercentInEveryOutput)
{
    for (const Tolerance& tolerance : kTolerances) {
        double most = 0;
        for (const auto& [row, answer] : answered_cases()) {
            if (row.name.compare(0, 8, "surface ") != 0)
                continue;
            for (int input = 0; input < kInputs; ++input) {
                KernelCase wrong = row;
                wrong.in[static_cast<size_t>(input)] *= 1.01F;
                Outputs<double> want = answer;
                most = std::max(
                    most, misses<float>(tolerance, row, evaluate_as_double<float>(wrong), want));
            }
        }
        EXPECT_GT(most, 100) << output_name(tolerance.output);
    }
}

} // namespace
} // namespace scree::test
