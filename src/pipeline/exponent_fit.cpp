#include "pipeline/exponent_fit.h"

#include <algorithm>
#include <cmath>

#include "kernel/filter.h"

namespace scree {

namespace {

constexpr int kLowest = -16, kHighest = 20; // log2 of Lambda
constexpr int kAnOctave = 16;
constexpr size_t kBins = (kHighest - kLowest) * kAnOctave + 1;

double lambda_of(size_t bin) { return std::exp2(kLowest + static_cast<double>(bin) / kAnOctave); }

} // namespace

ExponentBins::ExponentBins(int elevations)
    : bins_(static_cast<size_t>(elevations), std::vector<Bin>(kBins))
{}

void ExponentBins::add(int elevation, double lambda, const std::array<double, 3>& shift,
                       const std::array<double, 3>& truth, double weight)
{
    const double octave = std::log2(std::max(lambda, 1e-12));
    const double place = (std::clamp<double>(octave, kLowest, kHighest) - kLowest) * kAnOctave;
    const size_t first = std::min(static_cast<size_t>(place), kBins - 2);
    const double share = place - static_cast<double>(first);
    Bin sample;
    for (size_t c = 0; c < 3; ++c) {
        sample.truth += truth[c] * truth[c];
        sample.product += truth[c] * shift[c];
        sample.shift += shift[c] * shift[c];
    }
    for (const size_t side : {size_t{0}, size_t{1}}) {
        Bin& bin = bins_[static_cast<size_t>(elevation)][first + side];
        const double part = weight * (side == 0 ? 1 - share : share);
        bin.weight += part;
        bin.truth += part * sample.truth;
        bin.product += part * sample.product;
        bin.shift += part * sample.shift;
    }
}

void ExponentBins::add(const ExponentBins& other)
{
    for (size_t e = 0; e < bins_.size(); ++e)
        for (size_t i = 0; i < bins_[e].size(); ++i) {
            Bin& bin = bins_[e][i];
            const Bin& more = other.bins_[e][i];
            bin.weight += more.weight;
            bin.truth += more.truth;
            bin.product += more.product;
            bin.shift += more.shift;
        }
}

std::vector<double> ExponentBins::squares(const ExponentFit& fit) const
{
    std::vector<double> sums(bins_.size());
    for (size_t i = 0; i < kBins; ++i) {
        const double exponent =
            kernel::scree_measured_exponent(lambda_of(i), fit.gain, fit.power, fit.threshold);
        const double mean = filter::visible_height(exponent).mean;
        for (size_t e = 0; e < bins_.size(); ++e) {
            const Bin& bin = bins_[e][i];
            sums[e] += bin.truth + mean * (mean * bin.shift - 2 * bin.product);
        }
    }
    for (double& sum : sums)
        sum = std::max(sum, 0.0); // rounding
    return sums;
}

double ExponentBins::squares_of_mean(int elevation) const
{
    double sum = 0;
    for (const Bin& bin : bins_[static_cast<size_t>(elevation)])
        sum += bin.truth;
    return sum;
}

double ExponentBins::weight(int elevation) const
{
    double sum = 0;
    for (const Bin& bin : bins_[static_cast<size_t>(elevation)])
        sum += bin.weight;
    return sum;
}

namespace {

class Fitter {
public:
    Fitter(const ExponentBins& bins, double color) : bins_(bins), color_(color) {}

    ExponentFit run()
    {
        ExponentFit best{0, 1, 0};
        double least = cost(best);
        for (const double threshold : {0.0, 0.003, 0.01, 0.03, 0.1, 0.3})
            for (const double power : {0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0})
                for (const double octave : {-4.0, -3.5, -3.0, -2.5, -2.0, -1.5, -1.0, -0.5, 0.0,
                                            0.5, 1.0, 1.5, 2.0, 2.5, 3.0})
                    take({std::exp2(octave), power, threshold}, best, least);
        for (int halved = 2; halved < 9; ++halved) {
            const double step = std::exp2(-halved);
            for (bool better = true; better;) {
                const double before = least;
                for (const double way : {step, -step}) {
                    take({best.gain * (1 + way), best.power, best.threshold}, best, least);
                    take({best.gain, best.power * (1 + way), best.threshold}, best, least);
                    take({best.gain, best.power, best.threshold + 0.1 * way}, best, least);
                }
                better = least < before * (1 - 1e-3);
            }
        }
        return best;
    }

private:
    void take(ExponentFit fit, ExponentFit& best, double& least) const
    {
        fit.gain = std::clamp(fit.gain, 0.0, 8.0);
        fit.power = std::clamp(fit.power, 0.1, 3.0);
        fit.threshold = std::clamp(fit.threshold, 0.0, 0.3);
        const double of_fit = cost(fit);
        if (of_fit < least) {
            least = of_fit;
            best = fit;
        }
    }

    /// Squared errors, and a thousand times what any elevation has more than the mean color.
    [[nodiscard]] double cost(const ExponentFit& fit) const
    {
        double sum = 0;
        const std::vector<double> squares = bins_.squares(fit);
        for (int e = 0; e < bins_.elevations(); ++e) {
            const double own = squares[static_cast<size_t>(e)];
            const double slack = 3 * bins_.weight(e) * (0.002 * color_) * (0.002 * color_);
            sum += own + 1000 * std::max(own - bins_.squares_of_mean(e) - slack, 0.0);
        }
        return sum;
    }

    const ExponentBins& bins_;
    double color_;
};

} // namespace

ExponentFit fit_exponent(const ExponentBins& bins, double color)
{
    return Fitter(bins, color).run();
}

} // namespace scree
