#include "judge/statistics_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/statistics_figures.h"
#include "math/error.h"

namespace scree {

namespace {

/// Of float textures: what merging in double and one rounding leave where means are not large.
constexpr double kFloatTolerance = 1e-5;
/// Of a stored number, relative: twice its rounding, since a covariance takes two of them.
constexpr double kFloatRounding = 0x1p-23;
/// Where rounding is more, float cannot hold the map.
constexpr double kFloatLost = 0.125;
/// The covariance of slopes takes up to four units in the last place: one by rounding, three so
/// that no variance and no determinant comes out negative (docs/texture-set.md).
constexpr double kCovarianceRounding = 0x1p-21;
/// A plane's slope has no variance but rounding, and is let pass: four units over 1e-6 of the mean
/// square, the yardstick's least.
constexpr double kCovarianceLost = 0.5;
/// Of tau in float: the inverse of a thin covariance multiplies the rounding of the moments, 1e-16,
/// by (trace^2 / det)^2, up to 1e12.
constexpr double kTailTolerance = 1e-4;
/// Rank tables of levels beyond this are made of summaries of 512 steps (docs/statistics.md), of
/// which each moves a rank by 1/512 at most.
constexpr int kExactRankLevels = 6;
constexpr double kRankSummaries = 2.0 / 512;
/// Texels of truth held at a time.
constexpr int kTexelsAtOnce = 1 << 16;

/// The largest numbers of a level, which errors are held against.
struct LevelScale {
    double slope = 0, variance = 0, color = 0;

    void raise(const reference::Texel& texel)
    {
        for (size_t axis = 0; axis < 2; ++axis) {
            slope = std::max(slope, std::abs(texel.mean_slope[axis]));
            variance = std::max(variance, texel.cov_slope[axis]);
        }
        for (const double c : texel.mean_color)
            color = std::max(color, std::abs(c));
    }
};

/// What errors of the whole map are held against.
struct MapScale {
    double slope = 0, slope_deviation = 0, color_deviation = 0, height = 1;

    MapScale(const reference::Texel& top, double h1) : height(h1)
    {
        constexpr double kResolved = 1e-3; // of the rms slope: a plane has rounding, no deviation
        constexpr double kSeen = 0.1;      // of the largest color: a percent of it nobody sees
        const auto& [ss, tt, st] = top.cov_slope;
        const auto& [s, t] = top.mean_slope;
        slope = std::sqrt(ss + tt + s * s + t * t);
        slope_deviation = std::max(std::sqrt(std::max(ss, tt)), kResolved * slope);
        for (size_t c = 0; c < 3; ++c)
            color_deviation = std::max({color_deviation, std::sqrt(top.var_color[c]),
                                        kSeen * std::abs(top.mean_color[c])});
    }
};

double yardstick(Yardstick kind, const LevelScale& level, const LevelScale& next,
                 const MapScale& map)
{
    switch (kind) {
    case Yardstick::slope:
        return std::max(level.slope, map.slope);
    case Yardstick::variance: {
        constexpr double kResolved = 1e-6; // of a mean square: the error of float, some 10 times
        return std::max({level.variance, next.variance,
                         kResolved * (level.slope * level.slope + level.variance)});
    }
    case Yardstick::color:
        return level.color;
    case Yardstick::color_deviation:
        return map.color_deviation;
    case Yardstick::color_slope:
        return map.color_deviation * map.slope_deviation;
    case Yardstick::height:
        return map.height;
    case Yardstick::one:
        break;
    }
    return 1;
}

/// Half is held to what the set was asked for, float to the rounding of its numbers.
double tolerance_of(const Figure& figure, int level, double relative_magnitude,
                    double half_tolerance)
{
    const double of_float = figure.map == Map::tail ? kTailTolerance : kFloatTolerance;
    const double of_summaries =
        figure.map == Map::rank && level > kExactRankLevels ? kRankSummaries : 0;
    if (figure.type == PixelType::half)
        return half_tolerance + of_float + of_summaries;
    const bool is_covariance = figure.yardstick == Yardstick::variance;
    const double rounding = is_covariance ? kCovarianceRounding : kFloatRounding;
    const double lost = is_covariance ? kCovarianceLost : kFloatLost;
    return std::clamp(rounding * relative_magnitude, of_float, lost) + of_summaries;
}

/// error / yardstick; 0 where there is no error and nothing to hold it against.
double relative(double error, double yardstick)
{
    if (error == 0)
        return 0;
    return yardstick > 0 ? error / yardstick : std::numeric_limits<double>::infinity();
}

StatisticsFigure judged(const Figure& figure, int level, const ErrorSums& errors, double yardstick,
                        double half_tolerance)
{
    StatisticsFigure judged;
    judged.map = figure.map;
    judged.name = figure.name;
    judged.level = level;
    judged.largest = relative(errors.largest(), yardstick);
    judged.rms = relative(errors.rms(), yardstick);
    judged.x = errors.worst_x();
    judged.y = errors.worst_y();
    judged.yardstick = yardstick;
    judged.tolerance =
        tolerance_of(figure, level, relative(errors.magnitude(), yardstick), half_tolerance);
    return judged;
}

void expect_same_size(const SetReader& set, const Original& original)
{
    const Manifest& manifest = set.manifest();
    const reference::Relief& relief = original.relief;
    if (manifest.width != relief.width || manifest.height != relief.height)
        throw Error(fmt::format("{}: is a set of {}x{} texels, its inputs have {}x{}; bake the set "
                                "again, or name the inputs it was baked from",
                                set.folder().string(), manifest.width, manifest.height,
                                relief.width, relief.height));
}

int rank_terms_of(const Manifest& manifest)
{
    for (const TextureRecord& texture : manifest.textures)
        if (texture.map == Map::rank)
            return static_cast<int>(texture.channels.size() / 3);
    return 0;
}

/// What heights in the set are relative to, as the manifest has it.
StatisticsFigure height_scale(const Manifest& manifest, const reference::Statistics& truth)
{
    constexpr double kSums = 1e-9; // of sums in double, whose order differs
    constexpr double kRounding = 1e-15;
    StatisticsFigure figure;
    figure.map = Map::height;
    figure.name = "height mean and deviation";
    figure.yardstick = truth.h1();
    const double mean = std::abs(manifest.h0 - truth.h0()) / truth.h1();
    const double deviation = std::abs(manifest.h1 - truth.h1()) / truth.h1();
    figure.largest = std::max(mean, deviation);
    figure.rms = std::hypot(mean, deviation) / std::sqrt(2.0);
    figure.tolerance = std::max(kSums, kRounding * std::abs(truth.h0()) / truth.h1());
    return figure;
}

/// Compares one level, figure by figure.
class LevelComparison {
public:
    LevelComparison(SetReader& set, const reference::Statistics& truth,
                    const std::vector<Figure>& figures, int level)
        : set_(set), truth_(truth), figures_(figures), level_(level), errors_(figures.size())
    {}

    /// Rows [first, first + count).
    void rows(int first, int count, const MapTruth& map)
    {
        const std::vector<reference::Texel> truth = truth_.rows(level_, first, count);
        const auto width = static_cast<size_t>(truth_.width(level_));
        for (int j = 0; j < count; ++j) {
            const std::vector<SetTexel> row = set_.row(level_, first + j);
            for (size_t x = 0; x < width; ++x) {
                const reference::Texel& texel = truth[static_cast<size_t>(j) * width + x];
                scale_.raise(texel);
                for (size_t i = 0; i < figures_.size(); ++i) {
                    if (texel.coverage == 0 && figures_[i].map != Map::coverage)
                        continue;
                    errors_[i].at(static_cast<int>(x), first + j);
                    figures_[i].compare(row[x], texel, map, errors_[i]);
                }
            }
        }
    }

    [[nodiscard]] const LevelScale& scale() const { return scale_; }
    [[nodiscard]] const ErrorSums& errors(size_t figure) const { return errors_[figure]; }

private:
    SetReader& set_;
    const reference::Statistics& truth_;
    const std::vector<Figure>& figures_;
    int level_;
    LevelScale scale_;
    std::vector<ErrorSums> errors_;
};

} // namespace

std::vector<StatisticsFigure> check_statistics(SetReader& set, const Original& original,
                                               const BakeOptions& options,
                                               const std::function<void(double)>& progress)
{
    expect_same_size(set, original);
    const Manifest& manifest = set.manifest();
    const reference::Statistics truth(statistics_input(original, options.reconstruction),
                                      rank_terms_of(manifest));
    const int levels = truth.levels();
    const reference::Texel top = truth.at(levels - 1, 0, 0);
    const MapScale map_scale(top, truth.h1());
    const MapTruth map{truth.h0(), truth.h1(), manifest.has_height};

    const std::vector<Figure> figures = figures_of(manifest);
    std::vector<std::vector<StatisticsFigure>> found(figures.size());
    LevelScale next; // from the coarsest down: yardsticks look one level up
    for (int level = levels - 1; level >= 0; --level) {
        LevelComparison comparison(set, truth, figures, level);
        const int height = truth.height(level);
        const int at_once = std::max(1, kTexelsAtOnce / truth.width(level));
        for (int y = 0; y < height; y += at_once) {
            comparison.rows(y, std::min(at_once, height - y), map);
            if (progress) // every level takes about as long: all sum up the whole map
                progress((levels - 1 - level + static_cast<double>(y) / height) / levels);
        }
        for (size_t i = 0; i < figures.size(); ++i)
            found[i].push_back(
                judged(figures[i], level, comparison.errors(i),
                       yardstick(figures[i].yardstick, comparison.scale(), next, map_scale),
                       manifest.half_tolerance));
        next = comparison.scale();
    }
    std::vector<StatisticsFigure> all;
    if (manifest.has_height)
        all.push_back(height_scale(manifest, truth));
    for (const auto& of_figure : found)
        all.insert(all.end(), of_figure.rbegin(), of_figure.rend());
    return all;
}

} // namespace scree
