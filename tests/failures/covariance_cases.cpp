#include <algorithm>
#include <cmath>
#include <random>

#include "failures/baked_set.h"
#include "failures/cases.h"
#include "failures/maketx.h"
#include "failures/plain_code.h"
#include "failures/surfaces.h"
#include "figures/uniform.h"
#include "kernel/published.h"

namespace scree::test {
namespace {

const double kPi = std::acos(-1.0);

// --- 4 -------------------------------------------------------------------------------------------

filter::Covariance<double> seen_from_60(const SetTexel& texel)
{
    return seen_covariance(slopes_of(texel), toward(60));
}

PublishedResult published_from_60(double mean_s, double tt)
{
    return published_visible_slopes(mean_s, 0, 0, 0, tt, kPi / 3, 0, Form::mended);
}

Measured no_spread()
{
    const SetTexel flat =
        baked(heights_of(32, 32, [](int, int) { return 3.0; }), plain_options()).top();
    const SetTexel plane =
        baked(heights_of(32, 32, [](int x, int) { return 0.3 * x; }), plain_options(Wrap::clamp))
            .top();
    const SetTexel across = baked(v_groove(32, 32, 0.5), plain_options()).top();
    const SetTexel along = baked(transposed(v_groove(32, 32, 0.5)), plain_options()).top();
    const auto rough = filter::beckmann_roughness(slopes_of(across).covariance, 0.1F);
    // The first eigenvector of (0.25, 0; 0, 0) as (cst, l1 - css).
    const double css = 0.25, cst = 0, l1 = 0.25;
    return {{Figure("groove seen along, from 60 degrees: variance across it", 0.25)
                 .peer("Heitz 2013, 2014", published_from_60(0, 0.25).tt)
                 .ours(seen_from_60(along).tt)
                 .bound(1e-6),
             Figure("groove: direction of its roughness, radians", 0)
                 .peer("plain code", std::atan((l1 - css) / cst))
                 .ours(static_cast<double>(rough.angle_rad))
                 .relative_to(1, "a radian")
                 .bound(1e-6),
             Figure("flat: G1 at 60 degrees", 1)
                 .peer("Smith's formula", plain_g1(1 / std::tan(kPi / 3), 0, 0))
                 .ours(g1_of(slopes_of(flat), toward(60)))
                 .bound(1e-6),
             Figure("flat: variance of the slopes seen", 0)
                 .peer("Heitz 2013, 2014", published_from_60(0, 0).ss)
                 .ours(seen_from_60(flat).ss)
                 .relative_to(1, "1")
                 .bound(1e-9),
             Figure("plane of slope 0.3: variance of the slopes seen", 0)
                 .peer("Heitz 2013, 2014", published_from_60(0.3, 0).ss)
                 .ours(seen_from_60(plane).ss)
                 .relative_to(0.09, "the squared slope")
                 .bound(1e-6)},
            {}};
}

// --- 5 -------------------------------------------------------------------------------------------

constexpr double kLevel1 = 32 * 32; // texels of level 1

std::optional<double> maketx_negatives(const MemorySource& surface, const std::string& options)
{
    return of_levels(maketx_levels(height_image(surface), options),
                     [](const std::vector<Image>& levels) {
                         double count = 0;
                         for (int y = 0; y < levels[1].height; ++y)
                             for (int x = 0; x < levels[1].width; ++x)
                                 count += variance_s(levels[1], x, y) < 0 ? 1 : 0;
                         return count;
                     });
}

double our_negatives(const MemorySource& surface, PixelTypeChoice type)
{
    BakeOptions options = plain_options(Wrap::clamp);
    options.pixel_type = type;
    BakedSet set = baked(surface, options);
    const auto is_negative = [](const SetTexel& texel) {
        return raw_variance_s(texel) < 0 ? 1.0 : 0.0;
    };
    return kLevel1 * mean_over(set, 1, is_negative);
}

/// Variance of the slope along s of a clamped map whose rows are all the same: the cells between
/// texels, the first and the last continued over half a texel.
double variance_of_rows(const MemorySource& map)
{
    const auto cells = static_cast<size_t>(map.map_width) - 1;
    double mean = 0, square = 0;
    for (size_t i = 0; i < cells; ++i) {
        const double slope = map.heights[i + 1] - map.heights[i] - 2; // less a shift: keeps digits
        const double share = (i == 0 || i + 1 == cells ? 1.5 : 1) / map.map_width;
        mean += share * slope;
        square += share * slope * slope;
    }
    return square - mean * mean;
}

/// Slopes about 1, as of a normal map, so many that single-precision sums stall.
Figure long_sum()
{
    constexpr int kSize = 2048;
    std::mt19937 random(5);
    const auto noisy = slope_map_of(kSize, kSize, [&](int, int) {
        const auto slope = static_cast<float>(1 + 0.04 * (uniform(random) - 0.5));
        return std::array<double, 2>{static_cast<double>(slope), 0};
    });
    BakeOptions options = plain_options();
    options.maps = {Map::slope};
    const double sigma = *baked(noisy, options).summary().slope_sigma;
    return Figure("variance of slopes 1 +- 0.02, 2048x2048 texels", variance_of_slopes(noisy))
        .peer("plain code, float sums", variance_by_float_sums(noisy))
        .ours(sigma * sigma)
        .bound(1e-6);
}

Measured negative_variance()
{
    const auto ripples =
        heights_of(64, 64, [](int x, int) { return 2.0 * x + 0.01 * std::sin(2 * kPi * x / 16); });
    const auto noise = white_noise(64, 64, 1);
    BakeOptions automatic = plain_options(Wrap::clamp);
    automatic.pixel_type = PixelTypeChoice::automatic;
    return {{Figure("ripples, half floats: negative variances at level 1", 0)
                 .peer("maketx -d half", maketx_negatives(ripples, "-d half --wrap clamp"))
                 .ours(our_negatives(ripples, PixelTypeChoice::half))
                 .relative_to(kLevel1, "its 1024 texels")
                 .bound(0),
             Figure("noise, a sharp filter: negative variances at level 1", 0)
                 .peer("maketx --filter lanczos3",
                       maketx_negatives(noise, "-d float --wrap clamp --filter lanczos3"))
                 .ours(our_negatives(noise, PixelTypeChoice::float32))
                 .relative_to(kLevel1, "its 1024 texels")
                 .bound(0),
             Figure("ripples: variance of the whole map", variance_of_rows(ripples))
                 .peer("maketx -d half",
                       of_levels(maketx_levels(height_image(ripples), "-d half --wrap clamp"),
                                 variance_of_top))
                 .ours(raw_variance_s(baked(ripples, automatic).top()))
                 .bound(0.01), // one step of a float at 4 is 0.06 of it, and ours is rounded up
             long_sum()},
            {}};
}

// --- 6 -------------------------------------------------------------------------------------------

/// A V-groove along a diagonal, slopes 0.25 a texel along s and t each; sign 1: s and t slopes
/// agree, sign -1: they are opposite.
MemorySource diagonal_groove(int sign)
{
    return heights_of(32, 32,
                      [=](int x, int y) { return 0.25 * std::abs((x + sign * y + 32) % 16 - 8); });
}

// Heights depend on n = x + y alone, D(n) = h(n + 1) - h(n) = +-g. In a bilinear cell ds h goes
// from D(n) to D(n + 1) with t, dt h likewise with s: independent, so their covariance is the mean
// square of (D(n) + D(n + 1)) / 2, which is g or, in the 2 of 16 cells on a ridge or bottom, 0.
constexpr double kDiagonalCovariance = 0.25 * 0.25 * 14 / 16;
// There ds h is uniform in [-g, g]: g^2 / 3.
constexpr double kDiagonalVariance = 0.25 * 0.25 * (14 + 2.0 / 3) / 16;

Measured negative_covariance()
{
    const auto slopes_with = [](int sign) {
        return slopes_of(baked(diagonal_groove(sign), plain_options()).top());
    };
    const auto rising = slopes_with(1), falling = slopes_with(-1);
    const auto levels =
        maketx_levels(height_image(diagonal_groove(-1)), "-d float --wrap periodic");
    const float root_half = std::sqrt(0.5F);
    const auto across =
        filter::slope_along({root_half, -root_half}, falling.mean, falling.covariance);
    const double clamped = std::max(0.0, -kDiagonalCovariance);
    return {{Figure("falling groove: covariance of s and t", -kDiagonalCovariance)
                 .peer("plain code, max(0, .)", clamped)
                 .ours(static_cast<double>(falling.covariance.st))
                 .bound(1e-5),
             Figure("falling groove: covariance of s and t", -kDiagonalCovariance)
                 .peer("maketx", of_top(levels, kMeanSt)) // its means are 0
                 .ours(static_cast<double>(falling.covariance.st))
                 .bound(1e-5),
             Figure("rising groove: covariance of s and t", kDiagonalCovariance)
                 .peer("plain code, max(0, .)", std::max(0.0, kDiagonalCovariance))
                 .ours(static_cast<double>(rising.covariance.st))
                 .bound(1e-5),
             Figure("falling groove: deviation of the slope across it",
                    std::sqrt(kDiagonalVariance + kDiagonalCovariance))
                 .peer("plain code, max(0, .)", std::sqrt(kDiagonalVariance - clamped))
                 .ours(static_cast<double>(across.deviation))
                 .bound(1e-5)},
            {}};
}

} // namespace

std::vector<FailureCase> covariance_cases()
{
    return {
        {4, "No spread, or spread along one axis",
         "A flat map; a plane of slope 0.3; a V-groove of slopes +-0.5; 32x32.",
         R"(Closed forms divide by a standard deviation, a determinant or an off-diagonal term. A flat texel
or a perfect groove makes that zero over zero. Scree never inverts the covariance.)",
         "Nothing to do.", no_spread},
        {5, "Negative variances",
         R"(Ripples of height 0.01 on a plane of slope 2, 64x64; white noise, 64x64; slopes of 1 +- 0.02,
2048x2048.)",
         R"(Files hold E[s] and E[ss], and the variance is their small difference. Half floats, filters with
negative lobes and long sums in single precision turn it negative or into noise, and a shader
takes its root. Scree merges central moments, rounds what it stores so that no variance is
negative, and measures what half would cost before it takes it.)",
         R"(Leave `--pixel-type` on auto. With half given by hand ripples this small on a slope this steep
are lost, though never negative.)",
         negative_variance},
        {6, "Negative covariance",
         R"(V-grooves along the two diagonals, slopes +-0.25 along s and t, 32x32; one is the mirror image
of the other.)",
         R"(The covariance of the two slopes has a sign: it says which diagonal a groove follows. Code that
stops it at 0, as one does with a variance, makes one of them round.)",
         "Nothing to do.", negative_covariance},
    };
}

} // namespace scree::test
