#include "judge/statistics_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

void ErrorSums::note(double recovered, double truth, double magnitude)
{
    const double difference = std::abs(recovered - truth);
    const double error =
        std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
    if (error > largest_) {
        largest_ = error;
        worst_x_ = x_;
        worst_y_ = y_;
    }
    squares_ += error * error;
    ++count_;
    magnitude_ = std::max(magnitude_, std::abs(magnitude));
}

double ErrorSums::rms() const { return count_ > 0 ? std::sqrt(squares_ / count_) : 0; }

namespace {

using Truth = reference::Texel;

double wide(float x) { return static_cast<double>(x); }

/// Notes cov(x, y) as recovered from E[x], E[y], E[xy].
void note_covariance(double x, double y, double xy, double truth, ErrorSums& errors)
{
    errors.note(xy - x * y, truth, truth + x * y);
}

void mean_slope(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/, ErrorSums& errors)
{
    errors.note(wide(set.slope.s), truth.mean_slope[0], truth.mean_slope[0]);
    errors.note(wide(set.slope.t), truth.mean_slope[1], truth.mean_slope[1]);
}

void slope_covariance(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/,
                      ErrorSums& errors)
{
    const double s = wide(set.slope.s), t = wide(set.slope.t);
    note_covariance(s, s, wide(set.slope.ss), truth.cov_slope[0], errors);
    note_covariance(t, t, wide(set.slope.tt), truth.cov_slope[1], errors);
    note_covariance(s, t, wide(set.slope.st), truth.cov_slope[2], errors);
}

void mean_height(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/,
                 ErrorSums& errors)
{
    errors.note(wide(set.h), truth.mean_hn, truth.mean_hn);
}

void height_variance(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/,
                     ErrorSums& errors)
{
    note_covariance(wide(set.h), wide(set.h), wide(set.hh), truth.var_hn, errors);
}

void world_height(const SetTexel& set, const Truth& truth, const MapTruth& map, ErrorSums& errors)
{
    const double expected = map.has_height ? map.h0 + map.h1 * truth.mean_hn : -1;
    errors.note(wide(set.world_height), expected, expected);
}

void mean_color(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/, ErrorSums& errors)
{
    for (size_t c = 0; c < 3; ++c)
        errors.note(wide(set.color[c]), truth.mean_color[c], truth.mean_color[c]);
}

void color_height(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/,
                  ErrorSums& errors)
{
    for (size_t c = 0; c < 3; ++c)
        note_covariance(truth.mean_color[c], truth.mean_hn, wide(set.color_height[c]),
                        truth.cov_color_hn[c], errors);
}

void color_slope(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/,
                 ErrorSums& errors)
{
    for (size_t c = 0; c < 3; ++c) {
        note_covariance(truth.mean_color[c], truth.mean_slope[0], wide(set.color_s[c]),
                        truth.cov_color_s[c], errors);
        note_covariance(truth.mean_color[c], truth.mean_slope[1], wide(set.color_t[c]),
                        truth.cov_color_t[c], errors);
    }
}

void rank_terms(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/, ErrorSums& errors)
{
    for (size_t n = 0; n < truth.rank.size(); ++n) // 0 in both beyond the terms of the set
        for (size_t c = 0; c < 3; ++c)
            errors.note(wide(set.rank[n][c]), truth.rank[n][c], truth.rank[n][c]);
}

/// Whether tau is a matter of rounding: it jumps where C turns thin, and of a plane it is that of
/// the last digits.
bool is_decided(const Truth& truth)
{
    constexpr double kThin = 1e-6, kBand = 1e-9; // of det C over trace^2
    constexpr double kPlane = 1e-18;             // of trace over the square of the mean
    const auto& [ss, tt, st] = truth.cov_slope;
    const auto& [s, t] = truth.mean_slope;
    const double trace = ss + tt, square = s * s + t * t;
    if (trace == 0 && square == 0)
        return true;
    return trace > kPlane * square &&
           std::abs(ss * tt - st * st - kThin * trace * trace) > kBand * trace * trace;
}

void tail(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/, ErrorSums& errors)
{
    if (is_decided(truth))
        errors.note(wide(set.tau), truth.tau, truth.tau);
}

void coverage(const SetTexel& set, const Truth& truth, const MapTruth& /*map*/, ErrorSums& errors)
{
    errors.note(wide(set.coverage), truth.coverage, truth.coverage);
}

void add_figures(const TextureRecord& texture, std::vector<Figure>& figures)
{
    auto add = [&](const char* name, Yardstick yardstick, auto compare) {
        figures.push_back({texture.map, texture.type, name, yardstick, compare});
    };
    switch (texture.map) {
    case Map::bumpslopes:
        add("world height", Yardstick::height, world_height);
        [[fallthrough]];
    case Map::slope:
        add("mean slope", Yardstick::slope, mean_slope);
        add("slope covariance", Yardstick::variance, slope_covariance);
        break;
    case Map::height:
        add("mean height", Yardstick::one, mean_height);
        add("height variance", Yardstick::one, height_variance);
        break;
    case Map::color:
        add("mean color", Yardstick::color, mean_color);
        break;
    case Map::colorheight:
        add("color-height covariance", Yardstick::color_deviation, color_height);
        break;
    case Map::colorslope:
        add("color-slope covariance", Yardstick::color_slope, color_slope);
        break;
    case Map::rank:
        add("rank terms", Yardstick::color_deviation, rank_terms);
        break;
    case Map::tail:
        add("tail weight", Yardstick::one, tail);
        break;
    case Map::coverage:
        add("coverage", Yardstick::one, coverage);
        break;
    case Map::exponent: // a fit
    case Map::visible:  // not a sum over texels by themselves: held against the reference's views
    case Map::map:      // a table, not of texels
        break;
    }
}

} // namespace

std::vector<Figure> figures_of(const Manifest& manifest)
{
    std::vector<Figure> figures;
    for (const TextureRecord& texture : manifest.textures)
        add_figures(texture, figures);
    return figures;
}

} // namespace scree
