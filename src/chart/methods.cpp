#include "chart/methods.h"

#include <algorithm>
#include <cmath>

#include "chart/color_vector.h"
#include "chart/measured_color.h"
#include "chart/unmasked.h"

namespace scree {

namespace {

using Slopes = filter::Slopes<float>;

// --- slopes that nothing hides -------------------------------------------------------------------

Slopes naive_slopes(const FootprintData& data, const Material& /*material*/)
{
    Slopes slopes;
    slopes.mean = {-data.normal.x / data.normal.z, -data.normal.y / data.normal.z};
    return slopes;
}

Slopes slopes_by_length(const FootprintData& data, const Material& material)
{
    return toksvig_slopes(data.normal, material.base_alpha);
}

Slopes lean_slopes(const FootprintData& data, const Material& /*material*/)
{
    return filter::slopes(data.set.slope);
}

Slopes sobel_slopes(const FootprintData& data, const Material& /*material*/)
{
    return filter::slopes(data.sobel);
}

/// Mean color from everywhere, on slopes that do not hide each other.
template <Slopes (*slopes_of)(const FootprintData&, const Material&)>
struct Unmasked {
    static Rgbf color(const FootprintData& data, const MethodSetting& /*setting*/,
                      const Vec3f& /*wo*/)
    {
        return data.set.color;
    }
    static Rgbf radiance(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo,
                         const Vec3f& wi)
    {
        return unmasked_radiance(slopes_of(data, setting.material), data.set.color,
                                 setting.material, wo, wi);
    }
};

// --- color by height, of an exponent -------------------------------------------------------------

Rgbf mean_color(const SetTexel& texel, const MethodSetting& /*setting*/, float /*exponent*/)
{
    return texel.color;
}

Rgbf line_color(const SetTexel& texel, const MethodSetting& /*setting*/, float exponent)
{
    return color_of(filter::color_by_height(vector_of(texel.color), vector_of(texel.color_height),
                                            texel.h, texel.hh, filter::visible_height(exponent)));
}

Rgbf map_color(const SetTexel& texel, const MethodSetting& setting, float exponent)
{
    const auto visible = filter::visible_height(exponent);
    const float sigma = filter::height_sigma(texel.h, texel.hh);
    const Rgb found = lookup(*setting.height_colors, texel.h + sigma * visible.mean,
                             sigma * std::sqrt(visible.variance));
    return {static_cast<float>(found[0]), static_cast<float>(found[1]),
            static_cast<float>(found[2])};
}

template <int terms>
Rgbf rank_color(const SetTexel& texel, const MethodSetting& /*setting*/, float exponent)
{
    Vec3f a[terms];
    std::transform(texel.rank.begin(), texel.rank.begin() + terms, a, vector_of);
    return color_of(filter::color_by_rank(vector_of(texel.color), a, terms, exponent));
}

// --- the kernel's masking and reflection ---------------------------------------------------------

using ColorOf = Rgbf (*)(const SetTexel&, const MethodSetting&, float);
enum class Lean { ignored, followed };     ///< of color with slope
enum class Tails { gaussian, k0_mixture }; ///< of the slopes

template <ColorOf color_by, Lean lean = Lean::ignored, Tails tails = Tails::gaussian>
struct Masked {
    static Slopes slopes_of(const SetTexel& texel)
    {
        return filter::slopes(texel.slope, tails == Tails::k0_mixture ? texel.tau : 0.0F);
    }

    static Rgbf seen(const SetTexel& texel, const MethodSetting& setting, const Slopes& slopes,
                     const Vec3f& wo, float exponent)
    {
        Rgbf color = color_by(texel, setting, exponent);
        if constexpr (lean == Lean::followed) {
            const Vec3f leaning =
                filter::color_by_slope(vector_of(texel.color), vector_of(texel.color_s),
                                       vector_of(texel.color_t), wo, slopes);
            for (size_t i = 0; i < 3; ++i)
                color[i] = std::max(color[i] - texel.color[i] + leaning[static_cast<int>(i)], 0.0F);
        }
        return color;
    }

    static Rgbf color(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo)
    {
        const Slopes slopes = slopes_of(data.set);
        return seen(data.set, setting, slopes, wo, filter::masking(wo, slopes).lambda);
    }

    static Rgbf radiance(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo,
                         const Vec3f& wi)
    {
        const Slopes slopes = slopes_of(data.set);
        const float exponent =
            filter::masking(wo, slopes).lambda + filter::masking(wi, slopes).lambda;
        return scree::radiance(slopes, seen(data.set, setting, slopes, wo, exponent),
                               setting.material, wo, wi);
    }
};

// --- color as it was measured to be seen ---------------------------------------------------------

/// Of the line in height, with the exponent that was fitted.
struct Corrected {
    static float exponent_of(const SetTexel& texel, const Vec3f& w)
    {
        const auto& [gain, power, threshold] = texel.exponent;
        return filter::measured_exponent<float>(w, texel.slope, 0, {gain, power, threshold});
    }
    static Rgbf color(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo)
    {
        return line_color(data.set, setting, exponent_of(data.set, wo));
    }
    static Rgbf radiance(const FootprintData& data, const MethodSetting& setting, const Vec3f& wo,
                         const Vec3f& wi)
    {
        const float exponent = exponent_of(data.set, wo) + exponent_of(data.set, wi);
        return scree::radiance(filter::slopes(data.set.slope),
                               line_color(data.set, setting, exponent), setting.material, wo, wi);
    }
};

using F = MethodFamily;
using T = MethodTexture;
template <class Way>
Method method(const char* name, MethodFamily family, const char* what, std::vector<Reading> reads)
{
    return {name, family, what, std::move(reads), &Way::color, &Way::radiance};
}

template <int terms>
Method rank_method(const char* name, const char* what)
{
    return method<Masked<rank_color<terms>>>(name, F::correlated, what,
                                             {{T::color, 3}, {T::slope, 5}, {T::rank, 3 * terms}});
}

std::vector<Method> all_methods()
{
    const Reading color{T::color, 3}, slope{T::slope, 5}, height{T::height, 2};
    const Reading normal{T::normal, 3}, color_height{T::colorheight, 3};
    const Reading color_slope{T::colorslope, 6};
    return {
        method<Unmasked<naive_slopes>>("naive MIP", F::plain,
                                       "mean color on the mean normal, the material's own "
                                       "roughness.",
                                       {color, normal}),
        method<Unmasked<slopes_by_length>>(
            "Toksvig", F::plain,
            "as naive MIP, with roughness from the length of the mean normal (Toksvig 2005).",
            {color, normal}),
        method<Unmasked<sobel_slopes>>(
            "maketx", F::plain,
            "as LEAN, with moments of Sobel slopes as maketx --bumpslopes writes them.",
            {color, {T::sobel, 5}}),
        method<Unmasked<lean_slopes>>("LEAN", F::plain,
                                      "mean color on the mean slope, roughness from the slopes' "
                                      "covariance (Olano and Baker 2010).",
                                      {color, slope}),
        method<Masked<mean_color>>("LEADR", F::masked,
                                   "mean color, Smith's masking and shadowing, visible slopes "
                                   "(Dupuy et al. 2013).",
                                   {color, slope}),
        method<Masked<map_color>>(
            "visible height", F::masked,
            "as LEADR, with color a function of height alone, averaged over Gaussian visible "
            "heights (Heitz et al. 2013). The function is the asset's own mean color by height: "
            "where height does not decide on the color, it is wrong from above, too.",
            {slope, height}),
        method<Masked<line_color>>("linear", F::correlated,
                                   "as LEADR, with color linear in height (colorheight).",
                                   {color, slope, height, color_height}),
        method<Masked<line_color, Lean::followed>>(
            "linear + slope", F::correlated, "as linear, and linear in slope (colorslope).",
            {color, slope, height, color_height, color_slope}),
        rank_method<1>("rank 1", "as LEADR, with color by height rank, 1 term."),
        rank_method<2>("rank 2", "as LEADR, with color by height rank, 2 terms."),
        rank_method<4>("rank 4", "as LEADR, with color by height rank, 4 terms."),
        rank_method<8>("rank 8", "as LEADR, with color by height rank, 8 terms."),
        method<Masked<rank_color<4>, Lean::followed>>(
            "rank 4 + slope", F::correlated, "as rank 4, and linear in slope (colorslope).",
            {color, slope, {T::rank, 12}, color_slope}),
        method<Masked<rank_color<4>, Lean::followed, Tails::k0_mixture>>(
            "rank 4 + slope + tails", F::correlated,
            "as rank 4 + slope, for slopes that are partly K0 distributed (tail).",
            {color, slope, {T::rank, 12}, color_slope, {T::tail, 1}}),
        method<Corrected>("linear, corrected", F::measured,
                          "as linear, the exponent fitted to what views see of the asset's own "
                          "heights, three numbers a level (exponent).",
                          {color, slope, height, color_height, {T::exponent, 3}}),
        method<Measured<table_2x1>>("visibility 2x1", F::measured,
                                    "as LEADR, with color by tables of what views see of the "
                                    "asset's own heights (visible): the mean over the azimuth, at "
                                    "the second and the last of four angles from the normal.",
                                    {color, slope, {T::visible_2x1, 8}}),
        method<Measured<table_4x1>>("visibility 4x1", F::measured, "the same at all four.",
                                    {color, slope, {T::visible_4x1, 16}}),
        method<Measured<table_4x3>>("visibility 4x3", F::measured,
                                    "as visibility 4x1, with one harmonic of the azimuth.",
                                    {color, slope, {T::visible_4x3, 48}}),
        method<Measured<table_4x5>>("visibility 4x5", F::measured,
                                    "as visibility 4x1, with two harmonics of the azimuth.",
                                    {color, slope, {T::visible_4x5, 80}}),
        method<Measured<table_4_axes>>("visibility 4 axes", F::measured,
                                       "as visibility 4x1, with what goes with the view along two "
                                       "axes, where most slopes lie, instead of harmonics.",
                                       {color, slope, {T::visible_axes, 80}}),
    };
}

} // namespace

const std::vector<Method>& methods()
{
    static const std::vector<Method> all = all_methods();
    return all;
}

} // namespace scree
