#include "judge/shading.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace scree {

namespace {

constexpr float kPerPi = 0.318309886F;

Vec3f vector_of(const Rgbf& color) { return {color[0], color[1], color[2]}; }
Rgbf color_of(const Vec3f& vector) { return {vector.x, vector.y, vector.z}; }

/// What a color map's table is looked up with, as src/shaders/scree_set.glsl has it.
filter::SlopeAlong<float> seen_by_map(const SetTexel& texel, const SetColors& colors,
                                      const Vec3f& wo, float exponent)
{
    if (colors.map_by == "height") {
        const auto visible = filter::visible_height(exponent);
        const float sigma = filter::height_sigma(texel.h, texel.hh);
        return {texel.h + sigma * visible.mean, sigma * std::sqrt(visible.variance)};
    }
    const auto visible = filter::visible_slopes(wo, slopes_of(texel));
    if (colors.map_by == "slope")
        return filter::slope_along<float>({colors.azimuth_s, colors.azimuth_t}, visible.mean,
                                          visible.covariance);
    return filter::slope_magnitude(visible.mean, visible.covariance);
}

Rgbf map_color(const SetTexel& texel, const SetColors& colors, const Vec3f& wo, float exponent)
{
    const auto seen = seen_by_map(texel, colors, wo, exponent);
    const Rgb found = lookup(colors.table, seen.mean, seen.deviation);
    return {static_cast<float>(found[0]), static_cast<float>(found[1]),
            static_cast<float>(found[2])};
}

Rgbf color_without_slope(const SetTexel& texel, const SetColors& colors, ColorModel model,
                         const Vec3f& wo, float exponent)
{
    switch (model) {
    case ColorModel::mean:
    case ColorModel::visible:
        break;
    case ColorModel::height:
    case ColorModel::exponent:
        return color_of(filter::color_by_height(vector_of(texel.color),
                                                vector_of(texel.color_height), texel.h, texel.hh,
                                                filter::visible_height(exponent)));
    case ColorModel::rank: {
        std::array<Vec3f, 8> a;
        std::transform(texel.rank.begin(), texel.rank.end(), a.begin(), vector_of);
        return color_of(filter::color_by_rank(vector_of(texel.color), a.data(), 8, exponent));
    }
    case ColorModel::map:
        return map_color(texel, colors, wo, exponent);
    }
    return texel.color;
}

/// What the color goes by of a direction: Smith's Lambda, or what was measured in its place.
float exponent_of(const SetTexel& texel, ColorModel model, const Vec3f& w)
{
    if (model != ColorModel::exponent)
        return filter::masking(w, slopes_of(texel)).lambda;
    const auto& [gain, power, threshold] = texel.exponent;
    return filter::measured_exponent<float>(w, texel.slope, texel.tau, {gain, power, threshold});
}

filter::VisibilityTable<float> table_of(const SetTexel& texel, const SetColors& colors)
{
    return {texel.visible.data(),
            colors.node_cosines.data(),
            static_cast<int>(colors.node_cosines.size()),
            colors.harmonics,
            colors.axes,
            colors.axis_s,
            colors.axis_t};
}

} // namespace

std::string color_model_name(ColorModel model)
{
    switch (model) {
    case ColorModel::mean:
        return "mean color";
    case ColorModel::height:
        return "linear in height";
    case ColorModel::exponent:
        return "linear in height, measured exponent";
    case ColorModel::rank:
        return "by height rank";
    case ColorModel::map:
        return "color map";
    case ColorModel::visible:
        return "measured visibility";
    }
    return "";
}

filter::Slopes<float> slopes_of(const SetTexel& texel)
{
    return filter::slopes<float>(texel.slope, texel.tau);
}

Rgbf color_of_exponent(const SetTexel& texel, const SetColors& colors, ColorModel model,
                       bool by_slope, const Vec3f& wo, float exponent)
{
    assert(model != ColorModel::visible);
    Rgbf color = color_without_slope(texel, colors, model, wo, exponent);
    if (!by_slope)
        return color;
    const Vec3f leaning = filter::color_by_slope(vector_of(texel.color), vector_of(texel.color_s),
                                                 vector_of(texel.color_t), wo, slopes_of(texel));
    for (size_t i = 0; i < 3; ++i)
        color[i] = std::max(color[i] - texel.color[i] + leaning[static_cast<int>(i)], 0.0F);
    return color;
}

filter::Visibility<float> visibility_of(const SetTexel& texel, const SetColors& colors,
                                        const Vec3f& w)
{
    return filter::visibility(table_of(texel, colors), w);
}

Rgbf visible_color(const SetTexel& texel, const SetColors& colors, ColorModel model,
                   const Vec3f& wo)
{
    if (model == ColorModel::visible)
        return color_of(filter::visible_color(vector_of(texel.color), table_of(texel, colors), wo));
    return color_of_exponent(texel, colors, model, colors.adds_slope(model), wo,
                             exponent_of(texel, model, wo));
}

Rgbf lit_color(const SetTexel& texel, const SetColors& colors, ColorModel model, const Vec3f& wo,
               const Vec3f& wi)
{
    if (model == ColorModel::visible) {
        const auto table = table_of(texel, colors);
        const Vec3f mean = vector_of(texel.color);
        return color_of(filter::color_seen_and_lit(mean, filter::visible_color(mean, table, wo),
                                                   filter::visible_color(mean, table, wi), wo, wi));
    }
    return color_of_exponent(texel, colors, model, colors.adds_slope(model), wo,
                             exponent_of(texel, model, wo) + exponent_of(texel, model, wi));
}

Rgbf radiance(const filter::Slopes<float>& slopes, const Rgbf& color, const Material& material,
              const Vec3f& wo, const Vec3f& wi)
{
    const float diffuse = kPerPi * filter::diffuse(wo, wi, slopes);
    const float specular = material.f0 * filter::specular(wo, wi, slopes, material.base_alpha);
    return {color[0] * diffuse + specular, color[1] * diffuse + specular,
            color[2] * diffuse + specular};
}

Rgbf set_radiance(const SetTexel& texel, const SetColors& colors, const Material& material,
                  const Vec3f& wo, const Vec3f& wi)
{
    return radiance(slopes_of(texel), lit_color(texel, colors, colors.best(), wo, wi), material, wo,
                    wi);
}

Rgbf plain_radiance(const SetTexel& texel, const Material& material, const Vec3f& wo,
                    const Vec3f& wi)
{
    filter::Slopes<float> flat;
    flat.mean = {texel.slope.s, texel.slope.t};
    return radiance(flat, texel.color, material, wo, wi);
}

} // namespace scree
