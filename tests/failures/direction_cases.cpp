#include <cmath>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/plain_code.h"
#include "failures/surfaces.h"
#include "kernel/published.h"

namespace scree::test {
namespace {

constexpr double kInfinity = HUGE_VAL;

/// 256 heights, each once, and red that grows with them: red q at height rank q.
BakedSet ramp_of_red()
{
    const auto rank = [](int x, int y) { return (x + 16 * y) * 37 % 256; };
    return baked(painted(heights_of(16, 16, [&](int x, int y) { return rank(x, y) / 256.0; }),
                         [&](int x, int y, double /*h*/) { return (rank(x, y) + 0.5) / 256; }),
                 plain_options());
}

std::vector<HeightColor> steps_of_red()
{
    std::vector<HeightColor> steps(256, {1.0 / 256, 0});
    for (size_t i = 0; i < steps.size(); ++i)
        steps[i].color = (static_cast<double>(i) + 0.5) / 256;
    return steps;
}

/// Half a step of 256: the rank table's line goes on to the end of the last step.
constexpr double kHalfStep = 0.002;

// --- 1 -------------------------------------------------------------------------------------------

Measured from_straight_above()
{
    filter::Slopes<float> slopes;
    slopes.mean = {0.2F, -0.1F};
    slopes.covariance = {0.09F, 0.03F, 0.05F};
    const Vec3f above(0, 0, 1);
    const PublishedResult published =
        published_visible_slopes(0.2, -0.1, 0.09, 0.03, 0.05, 0, 0, Form::mended);
    const double lambda = lambda_of(slopes, above);
    const double plain = plain_lambda(kInfinity, 0.2, 0.3);
    // cos^2 of the view's azimuth as x^2 / (1 - z^2), to project the variances on it
    const float along = above.x * above.x / (1 - above.z * above.z);
    const double projected = static_cast<double>(along * 0.09F + (1 - along) * 0.05F);
    const auto seen = seen_covariance(slopes, above);
    return {
        {Figure("variance along s of the slopes seen", 0.09)
             .peer("Heitz 2013, 2014", published.ss)
             .ours(seen.ss)
             .bound(1e-6),
         Figure("variance along t of the slopes seen", 0.05)
             .peer("plain code, by azimuth", projected)
             .ours(seen.tt)
             .bound(1e-6),
         Figure("Lambda", 0).peer("plain code", plain).ours(lambda).relative_to(1, "1").bound(1e-6),
         Figure("visible color: the mean color", 0.5)
             .peer("plain code", color_at_or_below(steps_of_red(), plain))
             .ours(red_by_rank(ramp_of_red().top(), lambda))
             .bound(1e-6)},
        {}};
}

// --- 2 -------------------------------------------------------------------------------------------

/// Mean of visible Gaussian heights, deviations above the mean.
Figure visible_height_at(double exponent, const std::string& words)
{
    const auto height = filter::visible_height(static_cast<float>(exponent));
    return Figure("mean visible height, in deviations, Lambda = " + words,
                  visible_height_by_quadrature(exponent))
        .peer("plain code", visible_height_by_samples(exponent))
        .ours(static_cast<double>(height.mean))
        .bound(2e-6); // of the kernel's fit, 1e-6, and of single precision
}

Measured towards_grazing()
{
    filter::Slopes<float> slopes;
    slopes.covariance = {0.09F, 0, 0.09F};
    const Vec3f near = toward(89.999);
    const double cot = static_cast<double>(near.z) / static_cast<double>(near.x);
    return {{visible_height_at(1e6, "1e6"), visible_height_at(1e5, "1e5"),
             visible_height_at(1e4, "1e4"), visible_height_at(1e3, "1e3"),
             Figure("Lambda at 89.999 degrees", lambda_by_quadrature(cot / 0.3))
                 .peer("plain code", plain_lambda(cot, 0, 0.3))
                 .ours(lambda_of(slopes, near))
                 .bound(1e-5),
             Figure("visible color at 90 degrees: that of the highest point",
                    steps_of_red().back().color)
                 .peer("plain code", color_at_or_below(steps_of_red(), plain_lambda(0, 0, 0.3)))
                 .ours(red_by_rank(ramp_of_red().top(), lambda_of(slopes, {1, 0, 0})))
                 .bound(kHalfStep)},
            {}};
}

// --- 3 -------------------------------------------------------------------------------------------

/// Rising away from the viewer, deviation 0.2.
filter::Slopes<float> hillside(double mean)
{
    filter::Slopes<float> slopes;
    slopes.mean = {static_cast<float>(mean), 0};
    slopes.covariance = {0.04F, 0, 0.04F};
    return slopes;
}

/// Variance of the slopes seen, the mean plane so many deviations beyond facing away.
Figure seen_beyond(int deviations)
{
    const double theta = std::acos(-1.0) * 80 / 180;
    const double mean = 1 / std::tan(theta) + deviations * 0.2;
    const PublishedResult published =
        published_visible_slopes(mean, 0, 0.04, 0, 0.04, theta, 0, Form::mended);
    return Figure("variance of the slopes seen from 80 degrees, mean plane " +
                      std::to_string(deviations) + " deviations beyond",
                  0.04 * visible_variance_by_quadrature(-deviations))
        .peer("Heitz 2013, 2014, misprint mended", published.ss)
        .ours(seen_covariance(hillside(mean), toward(80)).ss)
        .bound(1e-4);
}

Measured turned_away()
{
    const Vec3f view = toward(75);
    const double cot = static_cast<double>(view.z) / static_cast<double>(view.x);
    const double g1 = g1_of(hillside(0.5), view);
    const double lambda = lambda_of(hillside(0.5), view);
    return {{Figure("G1 at 75 degrees", 0)
                 .peer("Smith's formula", plain_g1(cot, 0.5, 0.2))
                 .ours(g1)
                 .relative_to(1, "1")
                 .bound(1e-6),
             Figure("G1 at 75 degrees", 0)
                 .peer("rational fit, Walter 2007", walter_g1(cot, 0.5, 0.2))
                 .ours(g1)
                 .relative_to(1, "1")
                 .bound(1e-6),
             Figure("color of what is still seen: that of the highest point",
                    steps_of_red().back().color)
                 .peer("plain code", color_at_or_below(steps_of_red(), plain_lambda(cot, 0.5, 0.2)))
                 .ours(red_by_rank(ramp_of_red().top(), lambda))
                 .bound(kHalfStep),
             seen_beyond(4), seen_beyond(6), seen_beyond(8), seen_beyond(20)},
            {}};
}

} // namespace

std::vector<FailureCase> direction_cases()
{
    return {
        {1, "View from straight above",
         R"(One texel whose slopes have mean (0.2, -0.1), variances 0.09 and 0.05, covariance 0.03; 256
heights, each once, with red growing from 0 to 1 by height.)",
         R"(At 0 degrees the cotangent of the view angle is infinite and the view has no azimuth. Formulas
in these give infinity times zero and zero over zero: black or flashing pixels where a surface
faces the camera. Scree's formulas take the view vector itself and have no special place there.)",
         "Nothing to do.", from_straight_above},
        {2, "View along the surface",
         "Gaussian heights, Gaussian slopes of deviation 0.3; the 256 heights of case 1.",
         R"(Towards 90 degrees Lambda (hidden area per visible area) grows without bound. A sum of p(h)
P(h)^Lambda over sampled heights (here 64, up to three deviations) first runs out of samples,
then all its terms underflow: zero over zero. Scree stops Lambda at 1e6 and uses functions of
Lambda that tend to the highest points.)",
         "Nothing to do.", towards_grazing},
        {3, "Mean plane turned away",
         R"(A hillside: mean slope 0.5 rising away from the viewer, deviation 0.2 in all directions; the 256
heights of case 1.)",
         R"(On a curved or tilted surface the mean plane of a texel can face away while some of its facets
do not. Smith's formula has a pole there; beyond it G1 is negative. The published moments of the
slopes seen are differences of large numbers there and lose every digit. Scree says that such a
texel is hidden (G1 = 0), stays finite, and its moments keep their digits.)",
         "Nothing to do.", turned_away},
    };
}

} // namespace scree::test
