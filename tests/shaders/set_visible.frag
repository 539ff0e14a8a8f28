// Each texel of level `level` of a set's mean color and visibility tables: what the view sees of it,
// alpha the area, and what is lit as well. Behind scree_visible.glsl.

uniform sampler2D color;
uniform sampler2DArray visible;
uniform ScreeNodes nodes;
uniform vec2 size; // of that level, texels
uniform float level;
uniform vec3 wo;
uniform vec3 wi;            // 0 leaves the light out
uniform bool by_derivatives; // where the textures have that level only

out vec4 result;

void main()
{
    vec2 st = gl_FragCoord.xy / size;
    vec4 of_view = by_derivatives ? scree_visibility(visible, nodes, st, wo)
                                  : scree_visibility_lod(visible, nodes, st, wo, level);
    vec4 of_light = by_derivatives ? scree_visibility(visible, nodes, st, wi)
                                   : scree_visibility_lod(visible, nodes, st, wi, level);
    vec3 c = by_derivatives ? texture(color, st).rgb : textureLod(color, st, level).rgb;
    vec3 seen = scree_table_color(c, of_view);
    if (wi != vec3(0.0))
        seen = scree_table_color_lit(c, seen, scree_table_color(c, of_light), wo, wi);
    result = vec4(seen, scree_visible_area(wo.z, of_view.a));
}
