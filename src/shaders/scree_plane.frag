// A plane under one directional light, from a baked set. Behind scree_set.glsl (see there).
//
// The plane is z = 0; world x runs along +s. World y runs along +t, down the image, or up it where
// v_up is set; then v = 1 - t.

uniform sampler2D slope, extra, color, color_height;

uniform vec2 world_size;  // of the set, which repeats over the plane
uniform vec4 eye;         // the viewer's place; with w = 0 the direction to a viewer far away
uniform vec3 light;       // unit, to the light
uniform vec3 irradiance;  // on a plane that faces the light
uniform vec3 f0;          // reflectance of a facet seen straight on
uniform float base_alpha; // Beckmann roughness of the facets
uniform int model;        // 0 plain MIP: mean color, mean normal; 1 the set with its mean color;
                          // 2 the set, colors by height
uniform bool v_up;

in vec3 position;

out vec4 radiance;

void main()
{
    vec2 st = position.xy / world_size;
    vec3 wo = normalize(eye.xyz - eye.w * position);
    vec3 wi = light;
    if (v_up) {
        st.y = 1.0 - st.y;
        wo.y = -wo.y;
        wi.y = -wi.y;
    }
    ScreeFootprint f = scree_footprint(slope, extra, color, color_height, st);
    if (model == 0)
        f.covariance = vec3(0.0);
    vec3 seen = f.color;
    if (model == 2)
        seen = scree_visible_color(f, scree_lambda(wo, f) + scree_lambda(wi, f));
    radiance = vec4(scree_radiance(wo, wi, f, seen, f0, base_alpha, irradiance), 1.0);
}
