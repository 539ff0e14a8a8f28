#include "judge/asset_measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "pipeline/survey.h"

namespace scree {

namespace {

/// Footprints of 32x32 texels: a thousand slopes each, and many of them.
constexpr int kKurtosisLevel = 5;
constexpr double kDegreesPerRadian = 57.29577951308232;

/// A level-0 texel.
struct Sample {
    double weight, hn, square; ///< square: E[s^2 + t^2]
};

std::vector<Sample> samples_of(const reference::Statistics& statistics)
{
    std::vector<Sample> samples;
    samples.reserve(statistics.valid_texels());
    for (int y = 0; y < statistics.height(0); y += kStripRows)
        for (const reference::Texel& texel :
             statistics.rows(0, y, std::min(kStripRows, statistics.height(0) - y))) {
            const auto& [s, t] = texel.mean_slope;
            if (texel.coverage > 0)
                samples.push_back({texel.coverage, texel.mean_hn,
                                   s * s + t * t + texel.cov_slope[0] + texel.cov_slope[1]});
        }
    return samples;
}

double total_weight(const std::vector<Sample>& samples)
{
    return std::accumulate(samples.begin(), samples.end(), 0.0,
                           [](double sum, const Sample& s) { return sum + s.weight; });
}

/// samples  are sorted by height
HeightModes modes_of(std::vector<Sample>& samples)
{
    std::sort(samples.begin(), samples.end(),
              [](const Sample& l, const Sample& r) { return l.hn < r.hn; });
    const double weight = total_weight(samples);
    // hn has mean 0 and variance 1 over the map, so the part above has minus the sum below.
    HeightModes best;
    double below = 0, sum = 0;
    for (size_t i = 0; i + 1 < samples.size(); ++i) {
        below += samples[i].weight;
        sum += samples[i].weight * samples[i].hn;
        if (samples[i].hn == samples[i + 1].hn)
            continue;
        const double above = weight - below;
        const double explained = sum * sum / (below * above);
        if (explained > best.explained)
            best = {sum / below, -sum / above, below / weight, explained};
    }
    return best;
}

HeightSteps steps_of(const reference::Relief& relief)
{
    HeightSteps steps;
    std::vector<double> sorted;
    sorted.reserve(relief.heights.size());
    std::copy_if(relief.heights.begin(), relief.heights.end(), std::back_inserter(sorted),
                 [](double h) { return std::isfinite(h); });
    std::sort(sorted.begin(), sorted.end());
    steps.values = static_cast<size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());

    const auto width = static_cast<size_t>(relief.width),
               height = static_cast<size_t>(relief.height);
    auto level_along = [&](size_t columns, size_t rows, size_t step) {
        size_t pairs = 0, level = 0;
        for (size_t y = 0; y < rows; ++y)
            for (size_t x = 0; x < columns; ++x) {
                const size_t i = y * width + x;
                const double a = relief.heights[i], b = relief.heights[i + step];
                pairs += std::isfinite(a - b) ? 1 : 0;
                level += a == b ? 1 : 0;
            }
        return pairs > 0 ? static_cast<double>(level) / static_cast<double>(pairs) : 0;
    };
    steps.level_share =
        std::min(level_along(width - 1, height, 1), level_along(width, height - 1, width));
    return steps;
}

/// samples  are sorted by slope
double steep_share_of(std::vector<Sample>& samples)
{
    constexpr double kMost = 0.9;
    std::sort(samples.begin(), samples.end(),
              [](const Sample& l, const Sample& r) { return l.square > r.square; });
    double all = 0;
    for (const Sample& sample : samples)
        all += sample.weight * sample.square;
    double sum = 0, area = 0;
    for (const Sample& sample : samples) {
        if (sum >= kMost * all)
            break;
        sum += sample.weight * sample.square;
        area += sample.weight;
    }
    return all > 0 ? area / total_weight(samples) : 1;
}

double correlation_of(const std::vector<Sample>& samples)
{
    const double weight = total_weight(samples);
    double mean = 0;
    for (const Sample& sample : samples)
        mean += sample.weight * sample.square / weight;
    double hh = 0, ss = 0, hs = 0;
    for (const Sample& sample : samples) {
        const double d = sample.square - mean;
        hh += sample.weight * sample.hn * sample.hn;
        ss += sample.weight * d * d;
        hs += sample.weight * sample.hn * d;
    }
    return hh > 0 && ss > 0 ? hs / std::sqrt(hh * ss) : 0;
}

std::optional<double> median_kurtosis(const reference::Statistics& statistics, int level)
{
    std::vector<double> found;
    for (const reference::Texel& texel : statistics.rows(level, 0, statistics.height(level)))
        if (texel.kurtosis > 0)
            found.push_back(texel.kurtosis);
    if (found.empty())
        return {};
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    return *middle;
}

void measure_slopes(const reference::Texel& top, AssetMeasures& measures)
{
    const auto& [ss, tt, st] = top.cov_slope;
    const auto& [s, t] = top.mean_slope;
    measures.rms_slope = std::sqrt(ss + tt + s * s + t * t);
    const double middle = (ss + tt) / 2, radius = std::hypot((ss - tt) / 2, st);
    constexpr double kThinnest = 1e-12; // of a variance: a ratio of a million
    measures.slope_ratio =
        middle > 0 ? std::sqrt((middle + radius) / std::max(middle - radius, kThinnest * middle))
                   : 1;
    measures.azimuth_deg = std::atan2(2 * st, ss - tt) / 2 * kDegreesPerRadian;
}

} // namespace

AssetMeasures measure_asset(const Original& original, Reconstruction reconstruction)
{
    const reference::Statistics statistics(statistics_input(original, reconstruction));
    AssetMeasures measures;
    measures.texels = statistics.valid_texels();
    measure_slopes(statistics.at(statistics.levels() - 1, 0, 0), measures);
    const int level = std::min(kKurtosisLevel, statistics.levels() - 1);
    measures.footprint = 1 << level;
    measures.kurtosis = median_kurtosis(statistics, level);

    std::vector<Sample> samples = samples_of(statistics);
    measures.steep_share = steep_share_of(samples);
    if (original.relief.heights.empty())
        return measures;
    measures.steps = steps_of(original.relief);
    measures.height_steepness = correlation_of(samples);
    if (measures.steps->values > 1) {
        HeightModes modes = modes_of(samples);
        auto world = [&statistics](double hn) {
            constexpr double kRounding = 1e-12; // of the deviation: 0 is to be 0
            const double h = statistics.h0() + statistics.h1() * hn;
            return std::abs(h) > kRounding * statistics.h1() ? h : 0;
        };
        modes.low = world(modes.low);
        modes.high = world(modes.high);
        measures.modes = modes;
    }
    return measures;
}

} // namespace scree
