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

/// The nodes on both sides of a direction, and their shares. Before the first node there is none
/// (share 0): the same one again, since all pixels must take the same path to have derivatives.
struct ScreeNodePlace {
    int inner, outer;
    float inner_share, outer_share;
};

/// z  cosine of the angle that nodes are looked up with
ScreeNodePlace scree_node_place(ScreeNodes nodes, float z)
{
    ScreeNodePlace at;
    at.outer = 0;
    float before = 1.0;
    while (at.outer + 1 < nodes.count && z < nodes.cosine[at.outer]) {
        before = nodes.cosine[at.outer];
        ++at.outer;
    }
    at.inner = max(at.outer - 1, 0);
    at.outer_share = scree_node_share(z, before, nodes.cosine[at.outer]);
    at.inner_share = at.outer > 0 ? 1.0 - at.outer_share : 0.0;
    return at;
}

/// One of the terms of a node that a direction reads.
struct ScreeTerm {
    int index;    // among those of a node
    float weight; // what it is multiplied with
    float z;      // cosine of the angle that nodes are looked up with
};

/// The terms of a direction, number j of 1 + 2 harmonics, along axes of 3.
ScreeTerm scree_table_term(ScreeNodes nodes, vec3 w, int j)
{
    ScreeTerm term;
    term.index = j;
    term.weight = 1.0;
    term.z = w.z;
    if (j == 0)
        return term;
    if (nodes.harmonics < 0) {
        float along = j == 1 ? w.x * nodes.axis.x + w.y * nodes.axis.y
                             : w.y * nodes.axis.x - w.x * nodes.axis.y;
        term.index = 2 * j - (along < 0.0 ? 1 : 0);
        term.z = scree_axis_cosine(along, w.z);
        return term;
    }
    float c1 = 0.0, c2 = 0.0, s1 = 0.0, s2 = 0.0;
    scree_azimuth_harmonics(w.x, w.y, c1, c2, s1, s2);
    bool twice = (j - 1) % nodes.harmonics == 1;
    if (j > nodes.harmonics)
        term.weight = twice ? s2 : s1;
    else
        term.weight = twice ? c2 : c1;
    return term;
}

/// beta (rgb) and a of a direction, to the viewer or to a light, as the hardware filters them: two
/// lookups a layer of a node; along axes six.
vec4 scree_visibility(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w)
{
    bool along_axes = nodes.harmonics < 0;
    int terms = along_axes ? 5 : 1 + 2 * nodes.harmonics;
    ScreeNodePlace at = scree_node_place(nodes, w.z);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < (along_axes ? 3 : terms); ++j) {
        ScreeTerm term = scree_table_term(nodes, w, j);
        if (along_axes)
            at = scree_node_place(nodes, term.z);
        vec4 inner = texture(visible, vec3(st, float(terms * at.inner + term.index)));
        vec4 outer = texture(visible, vec3(st, float(terms * at.outer + term.index)));
        sum += term.weight * (at.inner_share * inner + at.outer_share * outer);
    }
    return sum;
}

/// The same at a given level.
vec4 scree_visibility_lod(sampler2DArray visible, ScreeNodes nodes, vec2 st, vec3 w, float lod)
{
    bool along_axes = nodes.harmonics < 0;
    int terms = along_axes ? 5 : 1 + 2 * nodes.harmonics;
    ScreeNodePlace at = scree_node_place(nodes, w.z);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < (along_axes ? 3 : terms); ++j) {
        ScreeTerm term = scree_table_term(nodes, w, j);
        if (along_axes)
            at = scree_node_place(nodes, term.z);
        vec4 inner = textureLod(visible, vec3(st, float(terms * at.inner + term.index)), lod);
        vec4 outer = textureLod(visible, vec3(st, float(terms * at.outer + term.index)), lod);
        sum += term.weight * (at.inner_share * inner + at.outer_share * outer);
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
