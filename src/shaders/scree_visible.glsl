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

/// A term that a direction reads: its layers of the nodes on both sides, and their weights. Before
/// the first node there is none (weight 0): the same one again, since all pixels must take the same
/// path to have derivatives.
struct ScreeTerm {
    int inner, outer;
    float inner_weight, outer_weight;
};

/// How many terms a direction reads.
int scree_term_count(ScreeNodes nodes)
{
    return nodes.harmonics < 0 ? 3 : 1 + 2 * nodes.harmonics;
}

/// Number j of the terms that a direction reads.
ScreeTerm scree_table_term(ScreeNodes nodes, vec3 w, int j)
{
    int terms = 1 + 2 * nodes.harmonics; // of a node
    int index = j;
    float weight = 1.0;
    float z = w.z; // cosine of the angle that nodes are looked up with
    if (nodes.harmonics < 0) {
        terms = 5;
        float along = j == 1 ? w.x * nodes.axis.x + w.y * nodes.axis.y
                             : w.y * nodes.axis.x - w.x * nodes.axis.y;
        if (j > 0) {
            index = 2 * j - (along < 0.0 ? 1 : 0);
            z = scree_axis_cosine(along, w.z);
        }
    } else if (j > 0) {
        float c1 = 0.0, c2 = 0.0, s1 = 0.0, s2 = 0.0;
        scree_azimuth_harmonics(w.x, w.y, c1, c2, s1, s2);
        bool twice = (j - 1) % nodes.harmonics == 1;
        if (j > nodes.harmonics)
            weight = twice ? s2 : s1;
        else
            weight = twice ? c2 : c1;
    }

    int outer = 0;
    float before = 1.0;
    while (outer + 1 < nodes.count && z < nodes.cosine[outer]) {
        before = nodes.cosine[outer];
        ++outer;
    }
    float share = scree_node_share(z, before, nodes.cosine[outer]);
    ScreeTerm term;
    term.outer = terms * outer + index;
    term.inner = terms * max(outer - 1, 0) + index;
    term.outer_weight = weight * share;
    term.inner_weight = outer > 0 ? weight * (1.0 - share) : 0.0;
    return term;
}

/// beta (rgb) and a of a direction, to the viewer or to a light, as the hardware filters them: two
/// lookups a layer of a node; along axes six.
vec4 scree_visibility(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w)
{
    vec4 sum = vec4(0.0);
    for (int j = 0; j < scree_term_count(nodes); ++j) {
        ScreeTerm term = scree_table_term(nodes, w, j);
        sum += term.inner_weight * texture(visible, vec3(st, float(term.inner)));
        sum += term.outer_weight * texture(visible, vec3(st, float(term.outer)));
    }
    return sum;
}

/// The same at a given level.
vec4 scree_visibility_lod(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w, float lod)
{
    vec4 sum = vec4(0.0);
    for (int j = 0; j < scree_term_count(nodes); ++j) {
        ScreeTerm term = scree_table_term(nodes, w, j);
        sum += term.inner_weight * textureLod(visible, vec3(st, float(term.inner)), lod);
        sum += term.outer_weight * textureLod(visible, vec3(st, float(term.outer)), lod);
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
