// How a shader reads the visibility tables of a set: what a direction sees of the color, measured.
//
// For GLSL 330 core and ES 300 and later. A fragment shader is, in this order:
//   #version, kernel/prelude_glsl.h, kernel/scree_filter.h, this file, its own text
// with or without scree_set.glsl, which says what frame directions are in and how wraps, pixel
// types and rows are uploaded.
//
// NAME.visible.exr goes into one array texture, at every MIP level, with 1 + 2 harmonics layers a
// node: the mean over the azimuth, then c1, [c2,] s1, [s2]. A layer is the next four channels of the
// file, A B G R, made R G B A. With one harmonic:
//
//   layer           R               G               B               A
//   0               1R              1G              1B              1A
//   1               1c1R            1c1G            1c1B            1c1A
//   2               1s1R            1s1G            1s1B            1s1A
//   3               2R              2G              2B              2A
//
// All channels are linear moments: any filter will do, and where the color of a set is filtered the
// same way a pixel gets what its footprint shows. ES 300 has at least 256 layers; 6 nodes and 2
// harmonics are 30.

#ifndef SCREE_VISIBLE
#define SCREE_VISIBLE

#ifdef GL_ES // eight bits by default for the color, none at all for arrays
precision highp sampler2D;
precision highp sampler2DArray;
#endif

/// The nodes of the tables, as the header of NAME.visible.exr has them; a uniform.
struct ScreeNodes {
    float cosine[6]; // scree:nodeCosine1 and on, falling; what is beyond count is not read
    int count;       // scree:nodes, 1 to 6
    int harmonics;   // scree:harmonics, 0 to 2
};

/// What a direction reads of the tables: the layers of the nodes on either side of it, from the
/// first layer of each on, and their weights. Before the first node there is none (weight 0): the
/// same layers again, since all pixels must take the same path to have derivatives.
struct ScreeTablePlace {
    int inner_layer, outer_layer;
    float inner_weight, outer_weight;
    float azimuth[5]; // what a node's layers are multiplied with
};

ScreeTablePlace scree_table_place(ScreeNodes nodes, vec3 w)
{
    int outer = 0;
    float before = 1.0;
    while (outer + 1 < nodes.count && w.z < nodes.cosine[outer]) {
        before = nodes.cosine[outer];
        ++outer;
    }
    int layers = 1 + 2 * nodes.harmonics;
    float share = scree_node_share(w.z, before, nodes.cosine[outer]);
    ScreeTablePlace place;
    place.outer_layer = layers * outer;
    place.inner_layer = layers * max(outer - 1, 0);
    place.outer_weight = share;
    place.inner_weight = outer > 0 ? 1.0 - share : 0.0;

    float c1 = 0.0, c2 = 0.0, s1 = 0.0, s2 = 0.0;
    scree_azimuth_harmonics(w.x, w.y, c1, c2, s1, s2);
    place.azimuth[0] = 1.0;
    place.azimuth[1] = c1;
    place.azimuth[2] = nodes.harmonics == 2 ? c2 : s1;
    place.azimuth[3] = s1;
    place.azimuth[4] = s2;
    return place;
}

/// beta (rgb) and a of a direction, to the viewer or to a light, as the hardware filters them: two
/// lookups a layer of a node.
vec4 scree_visibility(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w)
{
    ScreeTablePlace place = scree_table_place(nodes, w);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < 1 + 2 * nodes.harmonics; ++j) {
        vec4 inner = texture(visible, vec3(st, float(place.inner_layer + j)));
        vec4 outer = texture(visible, vec3(st, float(place.outer_layer + j)));
        sum += place.azimuth[j] * (place.inner_weight * inner + place.outer_weight * outer);
    }
    return sum;
}

/// The same at a given level.
vec4 scree_visibility_lod(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w, float lod)
{
    ScreeTablePlace place = scree_table_place(nodes, w);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < 1 + 2 * nodes.harmonics; ++j) {
        vec4 inner = textureLod(visible, vec3(st, float(place.inner_layer + j)), lod);
        vec4 outer = textureLod(visible, vec3(st, float(place.outer_layer + j)), lod);
        sum += place.azimuth[j] * (place.inner_weight * inner + place.outer_weight * outer);
    }
    return sum;
}

/// Color by visibility tables of what the view sees, or of what a light lights.
///
/// color       E[c], a lookup in NAME.color.exr
/// visibility  of that direction, as above
vec3 scree_table_color(vec3 color, vec4 visibility)
{
    return vec3(scree_color_by_visibility(color.r, visibility.r, visibility.a),
                scree_color_by_visibility(color.g, visibility.g, visibility.a),
                scree_color_by_visibility(color.b, visibility.b, visibility.a));
}

/// Color of what is both seen and lit.
///
/// seen, lit  scree_table_color of view and light;  wo, wi  the two directions
vec3 scree_table_color_lit(vec3 color, vec3 seen, vec3 lit, vec3 wo, vec3 wi)
{
    float together = scree_view_light_overlap(wo.x, wo.y, wi.x, wi.y);
    return vec3(scree_color_seen_and_lit(color.r, seen.r, lit.r, together),
                scree_color_seen_and_lit(color.g, seen.g, lit.g, together),
                scree_color_seen_and_lit(color.b, seen.b, lit.b, together));
}

#endif
