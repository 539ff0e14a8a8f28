#include "tables/effective_brdf.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "math/error.h"
#include "tables/schlick.h"

namespace scree {

namespace {

constexpr double kTurn = 6.28318530717958647692;
constexpr double kGolden = 0.61803398874989484820; ///< turns between texels that never line up
constexpr float kLeastCosine = 0.02F;

Vec3f moved(const Imath::V3d& w, double angle, bool mirrored)
{
    const double y = mirrored ? -w.y : w.y;
    const double c = std::cos(angle), s = std::sin(angle);
    return Vec3f(Imath::V3d(c * w.x - s * y, s * w.x + c * y, w.z));
}

} // namespace

void expect_level(const std::filesystem::path& set, const Manifest& manifest, int level)
{
    const auto& levels = manifest.levels;
    if (level < 0 || static_cast<size_t>(level) >= levels.size())
        throw Error(set.string() + ": has no level " + std::to_string(level) +
                    "; give one from 0 to " + std::to_string(levels.size() - 1));
}

EffectiveBrdf::EffectiveBrdf(const std::filesystem::path& set, int level,
                             const EffectiveBrdfOptions& options, int tile)
    : options_(options)
{
    SetReader reader(set, tile);
    expect_level(set, reader.manifest(), level);
    colors_ = reader.colors();
    const int height = reader.manifest().levels[static_cast<size_t>(level)].height;
    for (int y = 0; y < height; ++y) {
        const auto row = reader.row(level, y);
        texels_.insert(texels_.end(), row.begin(), row.end());
    }
}

Rgbf EffectiveBrdf::operator()(const filter::Directions<double>& w) const
{
    const double cos_d = std::sqrt(std::max(0.5 * (1 + w.wo.dot(w.wi)), 0.0));
    const Material material{options_.base_alpha,
                            static_cast<float>(schlick(static_cast<double>(options_.f0), cos_d))};
    const float per_wi = 1 / std::max(static_cast<float>(w.wi.z), kLeastCosine);
    const float per_wo = 1 / std::max(static_cast<float>(w.wo.z), kLeastCosine);
    std::array<double, 3> sum{};
    double weights = 0;
    for (size_t n = 0; n < texels_.size(); ++n) {
        const auto weight = static_cast<double>(texels_[n].coverage);
        weights += 2 * weight * options_.turns;
        for (int turn = 0; turn < options_.turns; ++turn) {
            const int pair = turn / 2, pairs = (options_.turns + 1) / 2;
            const double share = static_cast<double>(pair) / pairs;
            const double angle = kTurn * (kGolden * static_cast<double>(n) + share);
            const bool mirrored = turn % 2 == 1;
            const Vec3f wo = moved(w.wo, angle, mirrored), wi = moved(w.wi, angle, mirrored);
            const Rgbf there = set_radiance(texels_[n], colors_, material, wo, wi);
            const Rgbf back = set_radiance(texels_[n], colors_, material, wi, wo);
            for (size_t c = 0; c < 3; ++c)
                sum[c] += weight * static_cast<double>(there[c] * per_wi + back[c] * per_wo);
        }
    }
    Rgbf mean{};
    for (size_t c = 0; c < 3; ++c)
        mean[c] = static_cast<float>(sum[c] / std::max(weights, 1e-30));
    return mean;
}

} // namespace scree
