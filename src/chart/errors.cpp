#include "chart/errors.h"

#include <cmath>

namespace scree {

namespace {

Rgb rgb_of(const Rgbf& color) { return {color[0], color[1], color[2]}; }

/// Sums of squares, of differences and of the truth.
struct Squares {
    double difference = 0, truth = 0;

    void add(double weight, const Rgb& a, const Rgb& b, const Rgb& true_color)
    {
        for (size_t c = 0; c < 3; ++c) {
            difference += weight * (a[c] - b[c]) * (a[c] - b[c]);
            truth += weight * true_color[c] * true_color[c];
        }
    }

    /// Of a black asset nothing is wrong but what is not black.
    [[nodiscard]] double relative() const
    {
        return std::sqrt(truth > 0 ? difference / truth : difference);
    }
};

} // namespace

Appearance appearance_of(const reference::Gathered& gathered, float f0)
{
    Appearance out;
    for (const reference::Seen& seen : gathered.seen)
        out.color.push_back(seen.color);
    for (const reference::Lit& lit : gathered.lit)
        out.radiance.push_back(radiance_of(lit, static_cast<double>(f0)));
    return out;
}

Appearance appearance_of(const Method& method, const FootprintData& data,
                         const MethodSetting& setting, const ChartViews& views)
{
    Appearance out;
    for (const Vec3& view : views.views) {
        const Vec3f wo(view);
        out.color.push_back(rgb_of(method.color(data, setting, wo)));
        for (const Vec3& light : views.lights)
            out.radiance.push_back(rgb_of(method.radiance(data, setting, wo, Vec3f(light))));
    }
    return out;
}

std::vector<RelativeErrors> rms_differences(const ErrorScale& yardstick,
                                            const std::vector<Appearance>& a,
                                            const std::vector<Appearance>& b)
{
    const size_t lights = yardstick.views.lights.size();
    std::vector<RelativeErrors> errors;
    for (const ViewBand& band : yardstick.views.bands) {
        Squares color, radiance;
        for (size_t f = 0; f < yardstick.truth.size(); ++f) {
            const Appearance& truth = yardstick.truth[f];
            for (size_t v = band.first; v < band.first + band.count; ++v) {
                const double weight = yardstick.area[f][v];
                color.add(weight, a[f].color[v], b[f].color[v], truth.color[v]);
                for (size_t i = v * lights; i < (v + 1) * lights; ++i)
                    radiance.add(weight, a[f].radiance[i], b[f].radiance[i], truth.radiance[i]);
            }
        }
        errors.push_back({color.relative(), radiance.relative()});
    }
    return errors;
}

} // namespace scree
