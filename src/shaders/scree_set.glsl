// How a shader reads a baked set: lookups, and the kernel's formulas on vectors.
//
// For GLSL 330 core and ES 300 and later. A fragment shader is, in this order:
//   #version, kernel/prelude_glsl.h, kernel/scree_filter.h, this file, its own text
//
// The maps of a set (docs/texture-set.md) go into four textures of four channels:
//
//   texture       R               G               B               A
//   slope         slope s         slope t         slope ss        slope tt
//   extra         slope st        height h        height hh       tail tau
//   color         color R         color G         color B         -
//   color_height  colorheight R   colorheight G   colorheight B   -
//
// at every MIP level, as the files hold it: RGBA32F, or RGBA16F where all maps in it are half
// (ES filters RGBA32F with OES_texture_float_linear only). Wrap as in the manifest. A map that was
// not baked is 0: without height the color does not follow it, without tail slopes are Gaussian.
// color-slope has no place here; see scree_slope_pull, scree_color_by_slope.
//
// Every channel is a linear moment: any filter will do, one lookup a texture, anisotropic at best.
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

/// Visible color by its linear correlation with height.
///
/// exponent  Lambda of the view; of view plus light for what is seen and lit
vec3 scree_visible_color(ScreeFootprint f, float exponent)
{
    float mean = 0.0;
    float variance = 0.0;
    scree_visible_height(exponent, mean, variance);
    return vec3(scree_color_by_height(f.color.r, f.color_height.r, f.h, f.hh, mean),
                scree_color_by_height(f.color.g, f.color_height.g, f.h, f.hh, mean),
                scree_color_by_height(f.color.b, f.color_height.b, f.h, f.hh, mean));
}

/// Unit normal of the mean slope a direction sees.
vec3 scree_visible_normal(vec3 w, ScreeFootprint f)
{
    float area = 0.0;
    vec2 mean = vec2(0.0);
    vec3 covariance = vec3(0.0);
    scree_visible_slopes(w.x, w.y, w.z, f.mean.x, f.mean.y, f.covariance.x, f.covariance.y,
                         f.covariance.z, f.tau, area, mean.x, mean.y, covariance.x, covariance.y,
                         covariance.z);
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
