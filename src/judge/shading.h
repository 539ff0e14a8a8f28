#pragma once

#include <array>
#include <string>
#include <vector>

#include "color/map_table.h"
#include "judge/set_texel.h"
#include "kernel/filter.h"
#include "kernel/visibility_table.h"

namespace scree {

using Rgbf = std::array<float, 3>;
using Vec3f = filter::Vec3<float>;

/// How facets reflect: diffuse by their color, and a lobe of base_alpha with the reflectance f0.
struct Material {
    float base_alpha = 0.3F; ///< Beckmann roughness of a facet
    float f0 = 0.04F;        ///< at any angle: what Fresnel adds is the renderer's
};

/// The ways a set can tell the visible color.
enum class ColorModel {
    mean,     ///< E[c]
    height,   ///< linear in height, NAME.colorheight.exr
    rank,     ///< by height rank, NAME.rank.exr
    exponent, ///< linear by the exponent that was measured, NAME.exponent.exr
    map,      ///< the color map's table, NAME.map.exr
    visible   ///< measured visibility, NAME.visible.exr
};

std::string color_model_name(ColorModel model);

/// What the colors of a whole set have in common.
struct SetColors {
    std::vector<ColorModel> models;     ///< that the set has maps for, mean first, best last
    bool has_slope = false;             ///< NAME.colorslope.exr
    MapTable table;                     ///< of ColorModel::map
    std::string map_by;                 ///< "height", "slope", "slope magnitude"; empty: no map
    float azimuth_s = 1, azimuth_t = 0; ///< of "slope"
    std::vector<float> node_cosines;    ///< of ColorModel::visible
    int harmonics = 0;                  ///< likewise
    bool axes = false;                  ///< likewise; instead of harmonics
    float axis_s = 1, axis_t = 0;       ///< the first of them

    /// What a renderer would take: tables of visibility, the table of a color map, the line with
    /// the measured exponent, ranks, the line with Smith's, the mean.
    [[nodiscard]] ColorModel best() const { return models.back(); }

    /// Whether a renderer adds the correlation with slope: a color map by slope has it already, and
    /// so has what was measured of views.
    [[nodiscard]] bool adds_slope(ColorModel model) const
    {
        return has_slope && model != ColorModel::visible &&
               (model != ColorModel::map || map_by == "height");
    }
};

/// Slopes of a texel as a renderer makes them of its moments.
filter::Slopes<float> slopes_of(const SetTexel& texel);

/// The color seen where points are seen by an exponent, by one of the models but
/// ColorModel::visible.
///
/// wo        to the viewer
/// exponent  Lambda of the view; of view plus light for what is seen and lit
/// by_slope  adds the correlation with slope (not to a color map's table by slope, which has it)
Rgbf color_of_exponent(const SetTexel& texel, const SetColors& colors, ColorModel model,
                       bool by_slope, const Vec3f& wo, float exponent);

/// What the tables of ColorModel::visible tell of a direction.
filter::Visibility<float> visibility_of(const SetTexel& texel, const SetColors& colors,
                                        const Vec3f& w);

/// The color that a view sees, by any of the models, as a renderer would have it.
Rgbf visible_color(const SetTexel& texel, const SetColors& colors, ColorModel model,
                   const Vec3f& wo);

/// The color of what wo sees and wi lights.
Rgbf lit_color(const SetTexel& texel, const SetColors& colors, ColorModel model, const Vec3f& wo,
               const Vec3f& wi);

/// Radiance over irradiance under one directional light: color diffuse / pi + f0 specular, of
/// kernel/filter.h. The twin of scree_radiance in src/shaders/scree_set.glsl, without Fresnel.
Rgbf radiance(const filter::Slopes<float>& slopes, const Rgbf& color, const Material& material,
              const Vec3f& wo, const Vec3f& wi);

/// What a set shows by its best model of color, seen and lit.
Rgbf set_radiance(const SetTexel& texel, const SetColors& colors, const Material& material,
                  const Vec3f& wo, const Vec3f& wi);

/// What a plain MIP chain shows: mean color on the mean normal, no spread, no masking.
Rgbf plain_radiance(const SetTexel& texel, const Material& material, const Vec3f& wo,
                    const Vec3f& wi);

} // namespace scree
