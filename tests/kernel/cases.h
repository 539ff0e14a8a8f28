#pragma once

#include <array>
#include <string>
#include <vector>

namespace scree::test {

/// What a case gives the kernel: directions, moments of the slope, of the height and the color.
///
/// Directions are unit vectors away from the surface; mean, covariance and tau describe the slope;
/// kRaw* are raw moments of the same covariance (up to rounding) about another mean, for
/// scree_covariance; then height and color; kNodeNear and what follows is what visibility tables
/// need; kSecond* are the raw second moments of the slope of that mean and covariance (up to
/// rounding), for the measured exponent. Numbers of float32, so that every language and the oracle
/// start from the same ones. The order is that of the parameters of case_outputs().
enum Input : int {
    kWox,
    kWoy,
    kWoz,
    kWix,
    kWiy,
    kWiz,
    kMeanS,
    kMeanT,
    kCss,
    kCst,
    kCtt,
    kTau,
    kBaseAlpha,
    kH,
    kHh,
    kC,
    kCh,
    kCs,
    kCt,
    kA1,
    kA8 = kA1 + 7,
    kRawS,
    kRawT,
    kRawSs,
    kRawSt,
    kRawTt,
    kNodeNear,
    kNodeFar,
    kTableC,
    kBeta,
    kA,
    kLitC,
    kSecondSs,
    kSecondSt,
    kSecondTt,
    kGain,
    kPower,
    kThreshold,
    kInputs
};

/// What the kernel makes of it, likewise in the order of case_outputs().
enum Output : int {
    kRawCss,
    kRawCst,
    kRawCtt,
    kArea,
    kVisibleS,
    kVisibleT,
    kVisibleSs,
    kVisibleSt,
    kVisibleTt,
    kLambda,
    kG1,
    kHeightMean,
    kHeightVariance,
    kByHeight,
    kByRank,
    kBySlope,
    kMapU,
    kMapV,
    kAlphaX,
    kAlphaY,
    kAngle,
    kSpecular,
    kDiffuse,
    kProjected,
    kAlong,
    kSteepness,
    kSteepnessSpread,
    kNodeCoordinate,
    kNodeShare,
    kCos1,
    kCos2,
    kSin1,
    kSin2,
    kVisibleArea,
    kByVisibility,
    kOverlap,
    kSeenAndLit,
    kRawLambda,
    kMeasured,
    kAxisCosine,
    kOutputs
};

const char* output_name(int output);

struct KernelCase {
    std::string name;
    std::array<float, kInputs> in{};
};

template <typename Real>
using Outputs = std::array<Real, kOutputs>;

/// The table: the five rows of the sources' table 3, the failure cases 1 to 9, a sweep of z in
/// [-40, 40] times ratio of sigmas up to 1e4 times correlation up to 0.9999, the same for tails,
/// and surfaces as they are met. The same at every call.
std::vector<KernelCase> kernel_cases();

/// The kernel in C++; Real is float or double.
template <typename Real>
Outputs<Real> evaluate(const KernelCase& row);

extern template Outputs<float> evaluate<float>(const KernelCase&);
extern template Outputs<double> evaluate<double>(const KernelCase&);

/// Name, directions and slope of a case as text, for messages.
std::string describe(const KernelCase& row);

} // namespace scree::test
