// Each texel of level `level` of a packed set: its color by every model. Behind scree_set.glsl.

uniform sampler2D slope, extra, color, color_height;
uniform sampler2D rank_b, rank_g, rank_r, color_slope_bg, color_slope_r;
uniform sampler2D exponents;
uniform sampler2D map;
uniform vec2 size;       // of that level, texels
uniform float level;
uniform vec3 wo;
uniform int color_model; // as scree_visible_color() of OSL
uniform bool slope_color;
uniform vec3 map_range;
uniform int map_by;      // 0 height, 1 slope, 2 slope magnitude
uniform vec2 direction;

out vec4 result;

void main()
{
    vec2 st = gl_FragCoord.xy / size;
    ScreeFootprint f = scree_footprint_lod(slope, extra, color, color_height, st, level);
    float exponent = scree_lambda(wo, f);
    vec3 seen = f.color;
    if (color_model == 1)
        seen = scree_visible_color(f, exponent);
    if (color_model == 2)
        seen = scree_rank_color(f, textureLod(rank_b, st, level), textureLod(rank_g, st, level),
                                textureLod(rank_r, st, level), exponent);
    if (color_model == 3) {
        vec2 at = scree_seen_height(f, exponent);
        if (map_by == 1)
            at = scree_seen_slope(wo, f, direction);
        if (map_by == 2)
            at = scree_seen_steepness(wo, f);
        seen = scree_map_color(map, map_range, at);
    }
    if (color_model == 5)
        seen = scree_visible_color(f, scree_exponent(wo, textureLod(slope, st, level),
                                                     textureLod(extra, st, level),
                                                     textureLod(exponents, st, level).rgb));
    if (slope_color)
        seen = scree_add_slope_color(seen, wo, f, textureLod(color_slope_bg, st, level),
                                     textureLod(color_slope_r, st, level));
    result = vec4(seen, 1.0);
}
