#include "figures/visibility_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/filter.h"
#include "kernel/visibility_table.h"
#include "math/vec.h"

namespace scree::test {
namespace {

constexpr int kRankTerms = 4;
constexpr double kRadian = 0.017453292519943295769;

Vec3f color_of(const SetTexel& texel) { return {texel.color[0], texel.color[1], texel.color[2]}; }

Rgbf rgb(const Vec3f& color) { return {color.x, color.y, color.z}; }

Rgbf by_rank(const SetTexel& texel, float exponent)
{
    std::array<Vec3f, kRankTerms> terms;
    for (size_t n = 0; n < terms.size(); ++n)
        terms[n] = {texel.rank[n][0], texel.rank[n][1], texel.rank[n][2]};
    return rgb(filter::color_by_rank(color_of(texel), terms.data(), kRankTerms, exponent));
}

/// What a table of `kept` harmonics would hold: of each node the mean, cosines, sines.
std::vector<float> with_fewer_harmonics(const SetTexel& texel, size_t nodes, size_t harmonics,
                                        size_t kept)
{
    const size_t terms = 1 + 2 * harmonics;
    std::vector<float> values;
    auto add = [&](size_t component) {
        for (size_t i = 0; i < 4; ++i)
            values.push_back(texel.visible[4 * component + i]);
    };
    for (size_t node = 0; node < nodes; ++node) {
        add(node * terms);
        for (const size_t wave : {size_t{0}, size_t{1}})
            for (size_t h = 1; h <= kept; ++h)
                add(node * terms + wave * harmonics + h);
    }
    return values;
}

std::vector<float> cosines_of(const VisibilityRecord& record)
{
    std::vector<float> cosines;
    for (const double angle : record.node_angles_deg)
        cosines.push_back(static_cast<float>(std::cos(angle * kRadian)));
    return cosines;
}

double tangent(double cosine) { return std::sqrt(1 - cosine * cosine) / cosine; }

} // namespace

float smith_exponent(const SetTexel& texel, const Vec3f& w)
{
    return filter::masking(w, slopes_of(texel)).lambda;
}

float measured_exponent(const SetTexel& texel, const Vec3f& w)
{
    const auto [gain, power, threshold] = texel.exponent;
    return filter::measured_exponent(w, texel.slope, texel.tau, {gain, power, threshold});
}

Rgbf color_by_height(const SetTexel& texel, float exponent)
{
    const auto& [r, g, b] = texel.color_height;
    return rgb(filter::color_by_height(color_of(texel), {r, g, b}, texel.h, texel.hh,
                                       filter::visible_height(exponent)));
}

ColorOfView table_color(const VisibilityRecord& record, int harmonics)
{
    const std::vector<float> cosines = cosines_of(record);
    const size_t baked = static_cast<size_t>(record.harmonics);
    return {fmt::format("table {}x{}", cosines.size(), 1 + 2 * harmonics),
            [cosines, baked, harmonics](const SetTexel& texel, const Vec3f& w) {
                const std::vector<float> values = with_fewer_harmonics(
                    texel, cosines.size(), baked, static_cast<size_t>(harmonics));
                const filter::VisibilityTable<float> table{
                    values.data(), cosines.data(), static_cast<int>(cosines.size()), harmonics};
                return rgb(filter::visible_color(color_of(texel), table, w));
            }};
}

ColorOfView axes_color(const VisibilityRecord& record)
{
    SetColors colors;
    colors.node_cosines = cosines_of(record);
    const double axis = record.axis_deg.value() * kRadian;
    colors.axes = true;
    colors.axis_s = static_cast<float>(std::cos(axis));
    colors.axis_t = static_cast<float>(std::sin(axis));
    return {fmt::format("table {} axes", colors.node_cosines.size()),
            [colors](const SetTexel& texel, const Vec3f& w) {
                return visible_color(texel, colors, ColorModel::visible, w);
            }};
}

ColorOfView table_color_along(const VisibilityRecord& record, const std::string& name,
                              const std::function<double(double cosine)>& coordinate)
{
    std::vector<double> cosines = {1};
    for (const float cosine : cosines_of(record))
        cosines.push_back(static_cast<double>(cosine));
    const ColorOfView table = table_color(record, record.harmonics);
    auto color = [cosines, table, coordinate](const SetTexel& texel, const Vec3f& w) {
        const double z = static_cast<double>(w.z);
        size_t far = 1;
        while (far + 1 < cosines.size() && z < cosines[far])
            ++far;
        const double from = coordinate(cosines[far - 1]), to = coordinate(cosines[far]);
        const double share = std::min((coordinate(z) - from) / (to - from), 1.0);
        // Where the kernel, by tangents, takes the nodes in these shares.
        const double near_tangent = tangent(cosines[far - 1]);
        const double t = near_tangent + share * (tangent(cosines[far]) - near_tangent);
        const Vec3 seen_from(static_cast<double>(w.x), static_cast<double>(w.y), 0);
        const Vec3 to_viewer =
            (seen_from.length() > 0 ? seen_from.normalized() * t : Vec3(0, 0, 0));
        return table.color(texel, Vec3f((to_viewer + Vec3(0, 0, 1)).normalized()));
    };
    return {name, color};
}

std::vector<ColorOfView> colors_of_views(const VisibilityRecord& record)
{
    std::vector<ColorOfView> all = {
        {"naive", [](const SetTexel& texel, const Vec3f&) { return texel.color; }},
        {"Smith, linear",
         [](const SetTexel& texel, const Vec3f& w) {
             return color_by_height(texel, smith_exponent(texel, w));
         }},
        {"Smith, rank", [](const SetTexel& texel,
                           const Vec3f& w) { return by_rank(texel, smith_exponent(texel, w)); }},
        {"corrected",
         [](const SetTexel& texel, const Vec3f& w) {
             return color_by_height(texel, measured_exponent(texel, w));
         }},
    };
    for (int harmonics = 0; harmonics <= record.harmonics; ++harmonics)
        all.push_back(table_color(record, harmonics));
    return all;
}

} // namespace scree::test
