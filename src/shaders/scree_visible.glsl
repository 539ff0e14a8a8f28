// How a shader reads the visibility tables of a set: what a direction sees of the color, measured.
//
// For GLSL 330 core and ES 300 and later. A fragment shader is, in this order:
//   #version, kernel/prelude_glsl.h, kernel/scree_filter.h, this file, its own text
// with or without scree_set.glsl, which says what frame directions are in and how wraps, pixel
// types and rows are uploaded.
//
// NAME.visible.exr goes into one array texture, at every MIP level, with 1 + 2 harmonics layers a
// node: the mean over the azimuth, then c1, [c2,] s1, [s2]; along axes with five: of all sides, xn,
// xp, yn, yp. A layer is the next four channels of the file, A B G R, made R G B A. With one
// harmonic:
//
//   layer           R               G               B               A
//   0               1R              1G              1B              1A
//   1               1c1R            1c1G            1c1B            1c1A
//   2               1s1R            1s1G            1s1B            1s1A
//   3               2R              2G              2B              2A
//
// All channels are linear moments: any filter will do, and where the color of a set is filtered the
// same way a pixel gets what its footprint shows. ES 300 has at least 256 layers; 6 nodes and 2
// harmonics, or axes, are 30.

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
    int harmonics;   // scree:harmonics, 0 to 2; -1 along axes, where the header has none
    vec2 axis;       // scree:axisCosine, scree:axisSine; of tables along axes
};

/// What a direction reads of the tables: layers, and what they are multiplied with. All pixels read
/// as many, since all must take the same path to have derivatives.
struct ScreeTablePlace {
    int count; // of pairs of layers: the nodes on either side
    int inner[5], outer[5];
    float inner_weight[5], outer_weight[5];
};

/// Adds a term's layers to a place.
///
/// z      cosine of the angle that nodes are looked up with
/// terms  layers of a node
void scree_add_layers(ScreeNodes nodes, float z, int term, int terms, float weight,
                      inout ScreeTablePlace place)
{
    int outer = 0;
    float before = 1.0;
    while (outer + 1 < nodes.count && z < nodes.cosine[outer]) {
        before = nodes.cosine[outer];
        ++outer;
    }
    float share = scree_node_share(z, before, nodes.cosine[outer]);
    int i = place.count;
    place.outer[i] = terms * outer + term;
    place.inner[i] = terms * max(outer - 1, 0) + term;
    place.outer_weight[i] = weight * share;
    place.inner_weight[i] = outer > 0 ? weight * (1.0 - share) : 0.0; // before the first is none
    place.count = i + 1;
}

ScreeTablePlace scree_table_place(ScreeNodes nodes, vec3 w)
{
    ScreeTablePlace place;
    place.count = 0;
    if (nodes.harmonics < 0) {
        float x = w.x * nodes.axis.x + w.y * nodes.axis.y;
        float y = w.y * nodes.axis.x - w.x * nodes.axis.y;
        scree_add_layers(nodes, w.z, 0, 5, 1.0, place);
        scree_add_layers(nodes, scree_axis_cosine(x, w.z), x < 0.0 ? 1 : 2, 5, 1.0, place);
        scree_add_layers(nodes, scree_axis_cosine(y, w.z), y < 0.0 ? 3 : 4, 5, 1.0, place);
        return place;
    }
    float c1 = 0.0, c2 = 0.0, s1 = 0.0, s2 = 0.0;
    scree_azimuth_harmonics(w.x, w.y, c1, c2, s1, s2);
    int terms = 1 + 2 * nodes.harmonics;
    scree_add_layers(nodes, w.z, 0, terms, 1.0, place);
    if (nodes.harmonics == 1) {
        scree_add_layers(nodes, w.z, 1, terms, c1, place);
        scree_add_layers(nodes, w.z, 2, terms, s1, place);
    } else if (nodes.harmonics == 2) {
        scree_add_layers(nodes, w.z, 1, terms, c1, place);
        scree_add_layers(nodes, w.z, 2, terms, c2, place);
        scree_add_layers(nodes, w.z, 3, terms, s1, place);
        scree_add_layers(nodes, w.z, 4, terms, s2, place);
    }
    return place;
}

/// beta (rgb) and a of a direction, to the viewer or to a light, as the hardware filters them: two
/// lookups a layer of a node; along axes six.
vec4 scree_visibility(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w)
{
    ScreeTablePlace place = scree_table_place(nodes, w);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < place.count; ++j) {
        sum += place.inner_weight[j] * texture(visible, vec3(st, float(place.inner[j])));
        sum += place.outer_weight[j] * texture(visible, vec3(st, float(place.outer[j])));
    }
    return sum;
}

/// The same at a given level.
vec4 scree_visibility_lod(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w, float lod)
{
    ScreeTablePlace place = scree_table_place(nodes, w);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < place.count; ++j) {
        sum += place.inner_weight[j] * textureLod(visible, vec3(st, float(place.inner[j])), lod);
        sum += place.outer_weight[j] * textureLod(visible, vec3(st, float(place.outer[j])), lod);
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
