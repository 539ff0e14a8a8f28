// Fits of the exponent: what was put in comes out, and no elevation is worse off for it.

#include "pipeline/exponent_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/filter.h"

namespace scree::test {
namespace {

struct Sample {
    int elevation;
    double lambda;
    std::array<double, 3> shift, truth;
};

/// Colors that follow the model with some exponent of Lambda, at two elevations.
template <class Exponent>
std::vector<Sample> samples_of(Exponent exponent)
{
    std::vector<Sample> samples;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> octave(-8, 3), shift(-0.2, 0.2);
    for (int i = 0; i < 4000; ++i) {
        Sample s{i % 2, std::exp2(octave(random)), {}, {}};
        const double mean = filter::visible_height(exponent(s.lambda)).mean;
        for (size_t c = 0; c < 3; ++c) {
            s.shift[c] = shift(random);
            s.truth[c] = mean * s.shift[c];
        }
        samples.push_back(s);
    }
    return samples;
}

ExponentBins bins_of(const std::vector<Sample>& samples)
{
    ExponentBins bins(2);
    for (const Sample& s : samples)
        bins.add(s.elevation, s.lambda, s.shift, s.truth, 1);
    return bins;
}

TEST(ExponentFit, BinsTellTheErrorsOfTheirSamples)
{
    const auto samples = samples_of([](double lambda) { return 0.5 * lambda; });
    const ExponentBins bins = bins_of(samples);
    const ExponentFit fit{1.3, 0.8, 0.02};
    for (const int e : {0, 1}) {
        double squares = 0, of_mean = 0, weight = 0;
        for (const Sample& s : samples) {
            if (s.elevation != e)
                continue;
            const double above = std::max(s.lambda - fit.threshold, 0.0);
            const double mean = filter::visible_height(fit.gain * std::pow(above, fit.power)).mean;
            for (size_t c = 0; c < 3; ++c) {
                squares += std::pow(s.truth[c] - mean * s.shift[c], 2);
                of_mean += std::pow(s.truth[c], 2);
            }
            weight += 1;
        }
        EXPECT_NEAR(bins.weight(e), weight, 1e-9 * weight);
        EXPECT_NEAR(bins.squares_of_mean(e), of_mean, 1e-9 * of_mean);
        // Across a sixteenth of an octave mu changes by some hundredths of itself.
        EXPECT_NEAR(bins.squares(fit)[static_cast<size_t>(e)], squares, 0.001 * of_mean);
    }
}

TEST(ExponentFit, FindsTheExponentThatMadeTheColors)
{
    for (const ExponentFit& put_in : {ExponentFit{1, 1, 0}, ExponentFit{0.3, 1, 0},
                                      ExponentFit{2, 0.5, 0}, ExponentFit{1.5, 1, 0.05}}) {
        const auto samples = samples_of([&put_in](double lambda) {
            const double above = lambda - put_in.threshold;
            return above > 0 ? put_in.gain * std::pow(above, put_in.power) : 0;
        });
        const ExponentBins bins = bins_of(samples);
        const ExponentFit fit = fit_exponent(bins, 0.5);
        const double before = bins.squares_of_mean(0) + bins.squares_of_mean(1);
        EXPECT_LT(bins.squares(fit)[0] + bins.squares(fit)[1], 1e-3 * before)
            << put_in.gain << " " << put_in.power << " " << put_in.threshold;
    }
}

TEST(ExponentFit, ColorsThatDoNotFollowGetTheMeanColor)
{
    // The truth goes the other way: high parts are seen less.
    auto samples = samples_of([](double lambda) { return lambda; });
    for (Sample& s : samples)
        for (double& t : s.truth)
            t = -t;
    const ExponentBins bins = bins_of(samples);
    const ExponentFit fit = fit_exponent(bins, 0.5);
    for (const int e : {0, 1})
        EXPECT_LE(bins.squares(fit)[static_cast<size_t>(e)], bins.squares_of_mean(e) * (1 + 1e-12));
}

TEST(ExponentFit, NoElevationPaysForAnother)
{
    // One elevation as the model has it, one where nothing is seen to shift.
    auto samples = samples_of([](double lambda) { return lambda; });
    for (Sample& s : samples)
        if (s.elevation == 1)
            s.truth = {};
    const ExponentBins bins = bins_of(samples);
    constexpr double kColor = 0.5;
    const ExponentFit fit = fit_exponent(bins, kColor);
    const double slack = 3 * bins.weight(1) * std::pow(0.002 * kColor, 2);
    EXPECT_LE(bins.squares(fit)[1], slack * 1.01);
}

} // namespace
} // namespace scree::test
