// How a shader reads a baked set: lookups, and the kernel's formulas on vectors.
//
// For GLSL 330 core and ES 300 and later. A fragment shader is, in this order:
//   #version, kernel/prelude_glsl.h, kernel/scree_filter.h, this file, its own text
//
// The maps of a set (docs/texture-set.md) go into four textures of four channels, and into more of
// them where the color is told by rank or goes with the slope:
//
//   texture         R               G               B               A
//   slope           slope s         slope t         slope ss        slope tt
//   extra           slope st        height h        height hh       tail tau
//   color           color R         color G         color B         -
//   color_height    colorheight R   colorheight G   colorheight B   -
//
//   rank_b          rank B1         rank B2         rank B3         rank B4
//   rank_g          rank G1         rank G2         rank G3         rank G4
//   rank_r          rank R1         rank R2         rank R3         rank R4
//   color_slope_bg  colorslope Bs   colorslope Bt   colorslope Gs   colorslope Gt
//   color_slope_r   colorslope Rs   colorslope Rt   -               -
//   exponent        gain            power           threshold       -
//
// at every MIP level, as the files hold it: RGBA32F, or RGBA16F where all maps in it are half
// (ES filters RGBA32F with OES_texture_float_linear only). Wrap as in the manifest. A map that was
// not baked is 0: without height the color does not follow it, without tail slopes are Gaussian.
// Rank and color-slope are here in the order of their files; a rank table of fewer terms is 0 in
// the rest, for more there is the kernel's scree_color_by_rank.
//
// Every channel but rank, tail and exponent is a linear moment (what blending costs the rank table is
// in docs/statistics.md; the exponent's numbers are alike all over a level): any filter will do, one lookup a texture, anisotropic at best.
// Not so the table of a color map, NAME.map.exr (R G B): one level, GL_LINEAR, GL_CLAMP_TO_EDGE.
// How visibility tables are read is in scree_visible.glsl.
//
// Frame: x along +s (right), y along +t (DOWN the image), z out of the surface; directions are unit
// vectors away from the surface. Textures are uploaded row 0 first, so row 0 is t = 0. A renderer
// whose v runs up looks up at t = 1 - v and negates the y of every direction it gives and gets.

#ifndef SCREE_SET
#define SCREE_SET

#ifdef GL_ES // eight bits by default
precision highp sampler2D;
#endif

/// What a lookup knows of a footprint.
struct ScreeFootprint {
    vec2 mean;         // E[slope]
    vec3 covariance;   // ss, st, tt of the slope
    float tau;         // weight of K0 tails, 0 to 1
    float h, hh;       // E[hn], E[hn hn]
    vec3 color;        // E[c], scene-linear
    vec3 color_height; // E[c hn]
};

/// A footprint from the texels of the four textures, filtered.
ScreeFootprint scree_unpack(vec4 slope, vec4 extra, vec4 color, vec4 color_height)
{
    ScreeFootprint f;
    f.mean = slope.rg;
    scree_covariance(slope.r, slope.g, slope.b, extra.r, slope.a, f.covariance.x, f.covariance.y,
                     f.covariance.z);
    f.tau = extra.a;
    f.h = extra.g;
    f.hh = extra.b;
    f.color = color.rgb;
    f.color_height = color_height.rgb;
    return f;
}

/// The footprint of a pixel at st, as the hardware filters it.
ScreeFootprint scree_footprint(sampler2D slope, sampler2D extra, sampler2D color,
                               sampler2D color_height, vec2 st)
{
    return scree_unpack(texture(slope, st), texture(extra, st), texture(color, st),
                        texture(color_height, st));
}

/// The same at a given level, for ray tracers and where derivatives are not defined.
ScreeFootprint scree_footprint_lod(sampler2D slope, sampler2D extra, sampler2D color,
                                   sampler2D color_height, vec2 st, float lod)
{
    return scree_unpack(textureLod(slope, st, lod), textureLod(extra, st, lod),
                        textureLod(color, st, lod), textureLod(color_height, st, lod));
}

/// Smith's Lambda of a direction, in [0, 1e6].
float scree_lambda(vec3 w, ScreeFootprint f)
{
    float lambda = 0.0;
    float g1 = 0.0;
    scree_masking(w.x, w.y, w.z, f.mean.x, f.mean.y, f.covariance.x, f.covariance.y, f.covariance.z,
                  f.tau, lambda, g1);
    return lambda;
}

/// The exponent of a direction as it was measured of the asset, in [0, 1e6]; in place of
/// scree_lambda for color by height.
///
/// slope, extra  texels of those textures, filtered: their second moments and tau
/// measured      gain, power and threshold of NAME.exponent.exr, filtered
float scree_exponent(vec3 w, vec4 slope, vec4 extra, vec3 measured)
{
    float lambda = scree_raw_lambda(w.x, w.y, w.z, slope.b, extra.r, slope.a, extra.a);
    return scree_measured_exponent(lambda, measured.x, measured.y, measured.z);
}

/// Mean and covariance of the slopes a direction sees.
void scree_seen_slopes(vec3 w, ScreeFootprint f, out vec2 mean, out vec3 covariance)
{
    float area = 0.0;
    scree_visible_slopes(w.x, w.y, w.z, f.mean.x, f.mean.y, f.covariance.x, f.covariance.y,
                         f.covariance.z, f.tau, area, mean.x, mean.y, covariance.x, covariance.y,
                         covariance.z);
}

/// Visible color by its linear correlation with height.
///
/// exponent  scree_lambda or scree_exponent of the view; of view plus light for what is seen and lit
vec3 scree_visible_color(ScreeFootprint f, float exponent)
{
    float mean = 0.0;
    float variance = 0.0;
    scree_visible_height(exponent, mean, variance);
    return vec3(scree_color_by_height(f.color.r, f.color_height.r, f.h, f.hh, mean),
                scree_color_by_height(f.color.g, f.color_height.g, f.h, f.hh, mean),
                scree_color_by_height(f.color.b, f.color_height.b, f.h, f.hh, mean));
}

/// Visible color by height rank, from the texels of the three rank textures, filtered.
///
/// exponent  as in scree_visible_color
vec3 scree_rank_color(ScreeFootprint f, vec4 rank_b, vec4 rank_g, vec4 rank_r, float exponent)
{
    return vec3(scree_color_by_rank(f.color.r, rank_r.x, rank_r.y, rank_r.z, rank_r.w, 0.0, 0.0,
                                    0.0, 0.0, exponent),
                scree_color_by_rank(f.color.g, rank_g.x, rank_g.y, rank_g.z, rank_g.w, 0.0, 0.0,
                                    0.0, 0.0, exponent),
                scree_color_by_rank(f.color.b, rank_b.x, rank_b.y, rank_b.z, rank_b.w, 0.0, 0.0,
                                    0.0, 0.0, exponent));
}

/// A visible color (mean, by height or by rank) with its linear correlation with slope added, from
/// the texels of the two color-slope textures, filtered.
vec3 scree_add_slope_color(vec3 seen, vec3 w, ScreeFootprint f, vec4 color_slope_bg,
                           vec4 color_slope_r)
{
    float pull = scree_slope_pull(w.x, w.y, w.z, f.mean.x, f.mean.y, f.covariance.x,
                                  f.covariance.y, f.covariance.z, f.tau);
    vec3 by_slope = vec3(scree_color_by_slope(f.color.r, color_slope_r.x, color_slope_r.y, f.mean.x,
                                              f.mean.y, w.x, w.y, pull),
                         scree_color_by_slope(f.color.g, color_slope_bg.z, color_slope_bg.w,
                                              f.mean.x, f.mean.y, w.x, w.y, pull),
                         scree_color_by_slope(f.color.b, color_slope_bg.x, color_slope_bg.y,
                                              f.mean.x, f.mean.y, w.x, w.y, pull));
    return max(seen - f.color + by_slope, 0.0);
}

// What the table of a color map is looked up with, mean and deviation, by what the map goes by
// (scree:by in the file's header):

/// "height", in units of NAME.height.exr. exponent as in scree_visible_color.
vec2 scree_seen_height(ScreeFootprint f, float exponent)
{
    float mean = 0.0;
    float variance = 0.0;
    scree_visible_height(exponent, mean, variance);
    float sigma = scree_height_sigma(f.h, f.hh);
    return vec2(f.h + sigma * mean, sigma * sqrt(variance));
}

/// "slope", along a unit direction of the texture plane: (cos, sin) of scree:azimuthDegrees.
vec2 scree_seen_slope(vec3 w, ScreeFootprint f, vec2 direction)
{
    vec2 mean = vec2(0.0);
    vec3 covariance = vec3(0.0);
    scree_seen_slopes(w, f, mean, covariance);
    vec2 seen = vec2(0.0);
    scree_slope_along(direction.x, direction.y, mean.x, mean.y, covariance.x, covariance.y,
                      covariance.z, seen.x, seen.y);
    return seen;
}

/// "slope magnitude".
vec2 scree_seen_steepness(vec3 w, ScreeFootprint f)
{
    vec2 mean = vec2(0.0);
    vec3 covariance = vec3(0.0);
    scree_seen_slopes(w, f, mean, covariance);
    vec2 seen = vec2(0.0);
    scree_slope_magnitude(mean.x, mean.y, covariance.x, covariance.z, seen.x, seen.y);
    return seen;
}

/// Visible color of a color map.
///
/// map    the table, NAME.map.exr
/// range  scree:meanLow, scree:meanHigh and scree:widestDeviation of its header
/// seen   mean and deviation
vec3 scree_map_color(sampler2D map, vec3 range, vec2 seen)
{
    vec2 size = vec2(textureSize(map, 0));
    vec2 at = vec2(0.0);
    scree_color_map_coordinates(seen.x, seen.y, range.x, range.y, range.z, size.x, size.y, at.x,
                                at.y);
    return textureLod(map, at, 0.0).rgb;
}

/// Unit normal of the mean slope a direction sees.
vec3 scree_visible_normal(vec3 w, ScreeFootprint f)
{
    vec2 mean = vec2(0.0);
    vec3 covariance = vec3(0.0);
    scree_seen_slopes(w, f, mean, covariance);
    return normalize(vec3(-mean, 1.0));
}

/// Beckmann roughness: alpha along and across the direction of most spread, and that direction's
/// angle from +s towards +t. For a renderer with a BRDF of its own; the slopes are those over the
/// texture plane, which around a steep mean normal makes the lobe too wide along the tilt.
vec3 scree_roughness(ScreeFootprint f, float base_alpha)
{
    vec3 alpha = vec3(0.0);
    scree_beckmann_roughness(f.covariance.x, f.covariance.y, f.covariance.z, base_alpha, alpha.x,
                             alpha.y, alpha.z);
    return alpha;
}

/// Radiance to the viewer under one directional light: color diffuse / pi + Fresnel specular,
/// times the irradiance.
///
/// wo, wi      to viewer and light; black where the light is below the texture plane
/// color       of the diffuse part, such as scree_visible_color
/// f0          reflectance of a facet seen straight on
/// irradiance  on a plane that faces the light
/// source      Schlick 1994 for Fresnel, at the half vector h: (wo . h)^2 = (1 + wo . wi) / 2
/// not modelled: the diffuse part does not lose what the specular part reflects
vec3 scree_radiance(vec3 wo, vec3 wi, ScreeFootprint f, vec3 color, vec3 f0, float base_alpha,
                    vec3 irradiance)
{
    float diffuse =
        scree_diffuse(wo.x, wo.y, wo.z, wi.x, wi.y, wi.z, f.mean.x, f.mean.y, f.covariance.x,
                      f.covariance.y, f.covariance.z, f.tau);
    float specular =
        scree_specular(wo.x, wo.y, wo.z, wi.x, wi.y, wi.z, f.mean.x, f.mean.y, f.covariance.x,
                       f.covariance.y, f.covariance.z, base_alpha);
    if (wi.z <= 0.0)
        return vec3(0.0);
    float away = 1.0 - sqrt(max(0.5 + 0.5 * dot(wo, wi), 0.0));
    vec3 fresnel = f0 + (1.0 - f0) * (away * away * away * away * away);
    return (color * (0.318309886183790672 * diffuse) + fresnel * specular) * irradiance;
}

#endif
