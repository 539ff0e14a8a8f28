#include "figures/light_ways.h"

#include <algorithm>
#include <cmath>

#include "kernel/visibility_table.h"

namespace scree::test {
namespace {

constexpr size_t kHeightNumbers = 5;   ///< hn, hn hn, E[c hn] of R, G, B
constexpr size_t kExponentNumbers = 3; ///< gain, power, threshold

/// How one channel of the mean color and of the colors of view and light are put together.
using Together = float (*)(float mean, float seen, float lit);

float of_view(float /*mean*/, float seen, float /*lit*/) { return seen; }

float product(float mean, float seen, float lit)
{
    constexpr float kDark = 1e-6F; // a mean color of 0 has no light to shift
    return seen * lit / std::max(mean, kDark);
}

float both_shifts(float mean, float seen, float lit) { return std::max(seen + lit - mean, 0.0F); }

float greater_shift(float mean, float seen, float lit)
{
    return std::abs(seen - mean) >= std::abs(lit - mean) ? seen : lit;
}

LightWay put_together(const std::vector<LightSource>& sources, size_t source,
                      const std::string& name, Together together)
{
    return {sources[source].name + ", " + name, sources[source].numbers, source,
            [together](const PairColors& pair) {
                Rgbf color;
                for (size_t c = 0; c < 3; ++c)
                    color[c] = together(pair.texel.color[c], pair.seen[c], pair.lit[c]);
                return color;
            },
            false};
}

Vec3f vector_of(const Rgbf& color) { return {color[0], color[1], color[2]}; }

} // namespace

Rgbf overlap(const PairColors& pair)
{
    Rgbf smaller{};
    for (size_t c = 0; c < 3; ++c) {
        const float o = pair.seen[c] - pair.texel.color[c], i = pair.lit[c] - pair.texel.color[c];
        if (o * i > 0)
            smaller[c] = std::abs(o) < std::abs(i) ? o : i;
    }
    return smaller;
}

LightWay shifts_less_overlap(const std::vector<LightSource>& sources, size_t source)
{
    return {sources[source].name + ", less overlap", sources[source].numbers, source,
            [](const PairColors& pair) {
                const Vec3f color =
                    filter::color_seen_and_lit(vector_of(pair.texel.color), vector_of(pair.seen),
                                               vector_of(pair.lit), pair.wo, pair.wi);
                return Rgbf{color.x, color.y, color.z};
            }};
}

std::vector<LightWay> light_ways(const std::vector<LightSource>& sources)
{
    std::vector<LightWay> all = {
        {"naive", 0, 0, [](const PairColors& pair) { return pair.texel.color; }},
        {"Smith, exponents summed", kHeightNumbers, 0,
         [](const PairColors& pair) {
             return color_by_height(pair.texel, smith_exponent(pair.texel, pair.wo) +
                                                    smith_exponent(pair.texel, pair.wi));
         }},
        {"corrected, exponents summed", kHeightNumbers + kExponentNumbers, 0,
         [](const PairColors& pair) {
             return color_by_height(pair.texel, measured_exponent(pair.texel, pair.wo) +
                                                    measured_exponent(pair.texel, pair.wi));
         }},
    };
    for (size_t source = 0; source < sources.size(); ++source)
        all.push_back(shifts_less_overlap(sources, source));
    for (const size_t source : {most_harmonics(sources), exact(sources)}) {
        all.push_back(put_together(sources, source, "view alone", of_view));
        all.push_back(put_together(sources, source, "product", product));
        all.push_back(put_together(sources, source, "both shifts", both_shifts));
        all.push_back(put_together(sources, source, "greater shift", greater_shift));
    }
    return all;
}

} // namespace scree::test
