#include "figures/height_color_errors.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "figures/uniform.h"
#include "math/storage.h"

namespace scree::test {
namespace {

constexpr int kLookups = 400;                                      // of every surface and level
constexpr std::array<double, 5> kExponents = {0.1, 0.5, 2, 8, 32}; // L

struct Level {
    FootprintLevel footprints;
    std::vector<std::vector<Values>> values; // of every texel and model
};

Level baked(FootprintLevel footprints, const std::vector<Model>& models)
{
    Level level{std::move(footprints), {}};
    for (const Footprint& footprint : level.footprints.texels) {
        const Color mean = mean_color(footprint);
        auto& values = level.values.emplace_back();
        for (const Model& model : models) {
            values.emplace_back(mean.begin(), mean.end());
            model.bake(footprint, values.back());
        }
    }
    return level;
}

struct Tap {
    const Level* level;
    size_t texel;
    double weight;
};
using Taps = std::vector<Tap>;

/// The four taps of one level, with their share of the lookup.
void add_bilinear(Taps& taps, const Level& level, double s, double t, double share)
{
    const double x = s * level.footprints.size - 0.5, y = t * level.footprints.size - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
    for (const int dy : {0, 1})
        for (const int dx : {0, 1})
            taps.push_back(
                {&level,
                 level.footprints.index(static_cast<int>(x0) + dx, static_cast<int>(y0) + dy),
                 share * (dx == 1 ? fx : 1 - fx) * (dy == 1 ? fy : 1 - fy)});
}

Values filtered(const Taps& taps, size_t model, bool half)
{
    Values sum(taps.front().level->values.front()[model].size());
    for (const Tap& tap : taps) {
        const Values& values = tap.level->values[tap.texel][model];
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] +=
                tap.weight * (half ? StoreHalf::value(StoreHalf::nearest(values[i])) : values[i]);
    }
    return sum;
}

void add_lookup(Errors& errors, const Taps& taps, const std::vector<Model>& models, bool half)
{
    std::vector<std::pair<const Footprint*, double>> parts;
    for (const Tap& tap : taps)
        parts.emplace_back(&tap.level->footprints.texels[tap.texel], tap.weight);
    const Footprint footprint = mix(parts);
    std::array<Color, kExponents.size()> truth;
    for (size_t e = 0; e < truth.size(); ++e) {
        truth[e] = visible_color(footprint, kExponents[e]);
        errors.effect.add(truth[e], mean_color(footprint));
    }
    errors.models.resize(models.size());
    for (size_t m = 0; m < models.size(); ++m) {
        const Values values = filtered(taps, m, half);
        for (size_t e = 0; e < truth.size(); ++e)
            errors.models[m].add(models[m].show(values, kExponents[e]), truth[e]);
    }
}

} // namespace

void Squares::add(const Color& a, const Color& b)
{
    const Color d = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    const double luminance = 0.2126 * d[0] + 0.7152 * d[1] + 0.0722 * d[2];
    for (size_t c = 0; c < 3; ++c)
        sum_[c] += d[c] * d[c];
    sum_[3] += luminance * luminance;
    ++count_;
}

void Squares::add(const Squares& other)
{
    for (size_t c = 0; c < sum_.size(); ++c)
        sum_[c] += other.sum_[c];
    count_ += other.count_;
}

double Squares::luminance_rms() const { return std::sqrt(sum_[3] / count_); }

double Squares::worst_rms() const
{
    return std::sqrt(std::max({sum_[0], sum_[1], sum_[2]}) / count_);
}

void Errors::add(const Errors& other)
{
    effect.add(other.effect);
    models.resize(other.models.size());
    for (size_t m = 0; m < models.size(); ++m)
        models[m].add(other.models[m]);
}

SurfaceErrors measure(const Surface& surface, const std::vector<Model>& models)
{
    SurfaceErrors errors;
    std::mt19937 random(2);
    Level fine = baked(coarser(finest(surface)), models);
    for (size_t l = 0; l < kLevels; ++l) {
        Level coarse = baked(coarser(fine.footprints), models);
        const int size = fine.footprints.size;
        for (int i = 0; i < kLookups; ++i) {
            const double s = uniform(random), t = uniform(random), fraction = uniform(random);
            Taps taps;
            add_bilinear(taps, fine, s, t, 1 - fraction);
            add_bilinear(taps, coarse, s, t, fraction);
            add_lookup(errors[kTrilinear][l], taps, models, false);
            add_lookup(errors[kHalf][l], taps, models, true);
            const size_t nearest =
                fine.footprints.index(static_cast<int>(s * size), static_cast<int>(t * size));
            add_lookup(errors[kUnfiltered][l], {{&fine, nearest, 1}}, models, false);
        }
        fine = std::move(coarse);
    }
    return errors;
}

} // namespace scree::test
