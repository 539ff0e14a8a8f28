// Each texel of level `level` of a packed set, by explicit level and by the functions that the
// plane does not call. Behind scree_set.glsl.

uniform sampler2D slope, extra, color, color_height;
uniform vec2 size;       // of that level, texels
uniform float level;
uniform vec3 wo;
uniform float base_alpha;
uniform int what;        // 0 visible normal, 1 roughness, 2 visible color and Lambda

out vec4 result;

void main()
{
    ScreeFootprint f =
        scree_footprint_lod(slope, extra, color, color_height, gl_FragCoord.xy / size, level);
    if (what == 0)
        result = vec4(scree_visible_normal(wo, f), 0.0);
    else if (what == 1)
        result = vec4(scree_roughness(f, base_alpha), 0.0);
    else
        result = vec4(scree_visible_color(f, scree_lambda(wo, f)), scree_lambda(wo, f));
}
