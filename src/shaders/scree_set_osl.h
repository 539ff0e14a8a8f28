// How an OSL shader reads a texture set and what a viewer sees of it. All formulas are in
// kernel/scree_filter.h; compile with oslc -IFOLDER (no space), FOLDER the one that holds kernel/.

#ifndef SCREE_SET_OSL
#define SCREE_SET_OSL

#include "kernel/prelude_osl.h"
#include "kernel/scree_filter.h"

// A point of the surface as its set describes it, filtered for the pixel.
struct ScreeFootprint {
    float s, t;          // mean slope
    float css, cst, ctt; // its covariance
    float ss, st, tt;    // its second moments about the texture plane
    float tau;           // weight of heavy tails
};

// The tangent frame of a set: x along +s, y along +t, z the surface normal; orthonormal, y on the
// side of dP/dt.
struct ScreeFrame {
    vector x, y, z;
};

ScreeFrame scree_frame(vector dPds, vector dPdt, normal surface_normal)
{
    ScreeFrame f;
    f.z = normalize(vector(surface_normal));
    f.x = normalize(dPds - dot(dPds, f.z) * f.z);
    f.y = cross(f.z, f.x);
    if (dot(f.y, dPdt) < 0)
        f.y = -f.y;
    return f;
}

vector scree_to_frame(ScreeFrame f, vector w)
{
    return vector(dot(w, f.x), dot(w, f.y), dot(w, f.z));
}

// The normal of a slope, in the space of the frame's vectors.
normal scree_normal(ScreeFrame f, float s, float t)
{
    return normalize(normal(f.z - s * f.x - t * f.y));
}

// Where v runs up: the t at which a set is looked up. Of a set of tiles ("<UDIM>" in its name) t
// runs down inside each tile; its lower border stays in the tile.
float scree_flipped(string name, float v)
{
    if (!regex_search(name, "<UDIM>"))
        return 1 - v;
    float tile = floor(v);
    return tile + min(1 - (v - tile), 1 - 1e-6 * (1 + tile));
}

string scree_file(string folder, string name, string map)
{
    return concat(folder, "/", name, ".", map, ".exr");
}

// A texture that must be there: 4 channels from `first` on.
color scree_lookup(string file, float s, float t, int first, output float fourth)
{
    string problem = "";
    color three =
        texture(file, s, t, "firstchannel", first, "alpha", fourth, "errormessage", problem);
    if (problem != "")
        error("%s: %s; bake the set with this map, or mend folder and name", file, problem);
    return three;
}

// Slopes at (s, t) of NAME.slope.exr (s ss st t tt) and, where the set has it, NAME.tail.exr.
// height_scale is 1 as baked.
ScreeFootprint scree_footprint(string folder, string name, float s, float t, float height_scale)
{
    ScreeFootprint f;
    float mean_t = 0, unused = 0;
    string slope = scree_file(folder, name, "slope");
    color first = scree_lookup(slope, s, t, 0, mean_t);
    color last = scree_lookup(slope, s, t, 4, unused);
    f.s = height_scale * first[0];
    f.t = height_scale * mean_t;
    float scale2 = height_scale * height_scale;
    f.ss = scale2 * first[1];
    f.st = scale2 * first[2];
    f.tt = scale2 * last[0];
    scree_covariance(f.s, f.t, f.ss, f.st, f.tt, f.css, f.cst, f.ctt);
    f.tau = 0;
    int has_tail = 0;
    string tail = scree_file(folder, name, "tail");
    if (gettextureinfo(tail, "exists", has_tail) && has_tail) {
        color tau = scree_lookup(tail, s, t, 0, unused);
        f.tau = tau[0];
    }
    return f;
}

// The exponent of a direction w as it was measured of the asset, NAME.exponent.exr (gain, power,
// threshold); in place of Smith's Lambda for color by height.
float scree_exponent(string folder, string name, float s, float t, vector w, ScreeFootprint f)
{
    float unused = 0;
    color measured = scree_lookup(scree_file(folder, name, "exponent"), s, t, 0, unused);
    float lambda = scree_raw_lambda(w[0], w[1], w[2], f.ss, f.st, f.tt, f.tau);
    return scree_measured_exponent(lambda, measured[0], measured[1], measured[2]);
}

// Visible color by its linear correlation with height. c: mean color.
color scree_linear_color(string folder, string name, float s, float t, color c, float exponent)
{
    float unused = 0, mean = 0, variance = 0;
    scree_visible_height(exponent, mean, variance);
    color h = scree_lookup(scree_file(folder, name, "height"), s, t, 0, unused);
    color ch = scree_lookup(scree_file(folder, name, "colorheight"), s, t, 0, unused);
    color result = 0;
    for (int i = 0; i < 3; ++i)
        result[i] = scree_color_by_height(c[i], ch[i], h[0], h[1], mean);
    return result;
}

// Visible color by height rank, of as many terms as the file has: B1 .. BK G1 .. GK R1 .. RK.
color scree_rank_color(string folder, string name, float s, float t, color c, float exponent)
{
    string file = scree_file(folder, name, "rank");
    int channels = 0;
    gettextureinfo(file, "channels", channels);
    int terms = channels / 3;
    color result = 0;
    for (int i = 0; i < 3; ++i) {
        float a[8] = {0, 0, 0, 0, 0, 0, 0, 0};
        for (int n = 0; n < max(terms, 1); n += 4) { // a file that is not there is looked up too
            float fourth = 0;
            color three = scree_lookup(file, s, t, (2 - i) * terms + n, fourth);
            a[n] = three[0];
            a[n + 1] = n + 1 < terms ? three[1] : 0; // what follows is the next color's
            a[n + 2] = n + 2 < terms ? three[2] : 0;
            a[n + 3] = n + 3 < terms ? fourth : 0;
        }
        result[i] =
            scree_color_by_rank(c[i], a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], exponent);
    }
    return result;
}

// What the color map of a set goes by: "height", "slope" or "slope magnitude".
string scree_map_by(string folder, string name)
{
    string file = scree_file(folder, name, "map");
    string by = "";
    if (!gettextureinfo(file, "scree:by", by))
        error("%s: no table of a color map; bake the set with this map, or mend folder and name",
              file);
    return by;
}

// Visible color of a color map: its table, looked up where the visible heights or slopes are.
//
// by  of scree_map_by
color scree_map_color(string folder, string name, float s, float t, vector w, ScreeFootprint f,
                      float exponent, string by)
{
    string file = scree_file(folder, name, "map");
    float mean = 0, deviation = 0;
    if (by == "height") {
        float unused = 0, shift = 0, variance = 0;
        scree_visible_height(exponent, shift, variance);
        color h = scree_lookup(scree_file(folder, name, "height"), s, t, 0, unused);
        float sigma = scree_height_sigma(h[0], h[1]);
        mean = h[0] + sigma * shift;
        deviation = sigma * sqrt(variance);
    } else {
        float area, vs, vt, vss, vst, vtt;
        scree_visible_slopes(w[0], w[1], w[2], f.s, f.t, f.css, f.cst, f.ctt, f.tau, area, vs, vt,
                             vss, vst, vtt);
        float azimuth = 0;
        if (by == "slope" && gettextureinfo(file, "scree:azimuthDegrees", azimuth))
            scree_slope_along(cos(radians(azimuth)), sin(radians(azimuth)), vs, vt, vss, vst, vtt,
                              mean, deviation);
        else
            scree_slope_magnitude(vs, vt, vss, vtt, mean, deviation);
    }
    float low = 0, high = 1, widest = 1, x = 0, y = 0;
    int size[2] = {1, 1};
    gettextureinfo(file, "scree:meanLow", low);
    gettextureinfo(file, "scree:meanHigh", high);
    gettextureinfo(file, "scree:widestDeviation", widest);
    gettextureinfo(file, "resolution", size);
    scree_color_map_coordinates(mean, deviation, low, high, widest, size[0], size[1], x, y);
    // No derivatives: no filter. "linear", since OSL takes words it does not know, such as
    // "bilinear", for its bicubic default.
    return texture(file, x, y, 0.0, 0.0, 0.0, 0.0, "interp", "linear", "wrap", "clamp");
}

// Visible color by its linear correlation with slope. c: mean color.
color scree_slope_color(string folder, string name, float s, float t, float height_scale, vector w,
                        ScreeFootprint f, color c)
{
    // Bs Bt Gs Gt Rs Rt
    float gt = 0, unused = 0;
    string file = scree_file(folder, name, "colorslope");
    color first = scree_lookup(file, s, t, 0, gt);
    color last = scree_lookup(file, s, t, 4, unused);
    color cs = height_scale * color(last[0], first[2], first[0]);
    color ct = height_scale * color(last[1], gt, first[1]);
    float pull = scree_slope_pull(w[0], w[1], w[2], f.s, f.t, f.css, f.cst, f.ctt, f.tau);
    color result = 0;
    for (int i = 0; i < 3; ++i)
        result[i] = scree_color_by_slope(c[i], cs[i], ct[i], f.s, f.t, w[0], w[1], pull);
    return result;
}

// Adds a term's numbers of NAME.visible.exr, times a weight, to a and beta.
//
// z       cosine of the angle that nodes are looked up with
// cosine  of the nodes, `nodes` of them
// terms   of a node
void scree_add_term(string file, float s, float t, float z, float cosine[6], int nodes, int term,
                    int terms, float weight, output float a, output color beta)
{
    int outer = 0;
    float z_inner = 1;
    while (outer + 1 < nodes && z < cosine[outer]) {
        z_inner = cosine[outer];
        ++outer;
    }
    float share = scree_node_share(z, z_inner, cosine[outer]);
    int first = 4 * (terms * outer + term);
    float red = 0;
    color abg = scree_lookup(file, s, t, first, red);
    a += weight * share * abg[0];
    beta += weight * share * color(red, abg[2], abg[1]);
    if (outer > 0) { // before the first node is straight above, where both are 0
        float rest = weight * (1 - share);
        abg = scree_lookup(file, s, t, first - 4 * terms, red);
        a += rest * abg[0];
        beta += rest * color(red, abg[2], abg[1]);
    }
}

// beta of NAME.visible.exr, E[c (v - 1)], and a = v - 1, of a direction w in the frame of the set:
// to the viewer or to a light. The file's channels follow each other as A B G R of the first node's
// mean over the azimuth, of its harmonics c1 [c2] s1 [s2], of the second node, and so on; along
// axes of all sides, xn, xp, yn, yp.
color scree_visibility(string folder, string name, float s, float t, vector w, output float a)
{
    string file = scree_file(folder, name, "visible");
    string names[6] = {"scree:nodeCosine1", "scree:nodeCosine2", "scree:nodeCosine3",
                       "scree:nodeCosine4", "scree:nodeCosine5", "scree:nodeCosine6"};
    int nodes = 0, harmonics = 0;
    float cosine[6] = {0, 0, 0, 0, 0, 0};
    float axis_cosine = 1, axis_sine = 0;
    a = 0;
    color beta = 0;
    int along_axes = gettextureinfo(file, "scree:axisCosine", axis_cosine) &&
                     gettextureinfo(file, "scree:axisSine", axis_sine);
    if (!gettextureinfo(file, "scree:nodes", nodes) || !gettextureinfo(file, names[0], cosine[0]) ||
        !(along_axes || gettextureinfo(file, "scree:harmonics", harmonics))) {
        error("%s: no visibility tables; bake the set with this map, or mend folder and name",
              file);
        return beta;
    }
    nodes = min(nodes, 6);
    for (int i = 1; i < nodes; ++i)
        gettextureinfo(file, names[i], cosine[i]);
    if (along_axes) {
        float x = w[0] * axis_cosine + w[1] * axis_sine;
        float y = w[1] * axis_cosine - w[0] * axis_sine;
        scree_add_term(file, s, t, w[2], cosine, nodes, 0, 5, 1, a, beta);
        scree_add_term(file, s, t, scree_axis_cosine(x, w[2]), cosine, nodes, x < 0 ? 1 : 2, 5, 1,
                       a, beta);
        scree_add_term(file, s, t, scree_axis_cosine(y, w[2]), cosine, nodes, y < 0 ? 3 : 4, 5, 1,
                       a, beta);
        return beta;
    }
    float c1 = 0, c2 = 0, s1 = 0, s2 = 0;
    scree_azimuth_harmonics(w[0], w[1], c1, c2, s1, s2);
    float azimuth[5] = {1, c1, s1, 0, 0};
    if (harmonics == 2) {
        azimuth[2] = c2;
        azimuth[3] = s1;
        azimuth[4] = s2;
    }
    int terms = 1 + 2 * harmonics;
    for (int j = 0; j < terms; ++j)
        scree_add_term(file, s, t, w[2], cosine, nodes, j, terms, azimuth[j], a, beta);
    return beta;
}

// Color by visibility tables: what the view sees, or what the light lights. c: mean color.
color scree_table_color(string folder, string name, float s, float t, vector w, color c)
{
    float a = 0;
    color beta = scree_visibility(folder, name, s, t, w, a);
    return color(scree_color_by_visibility(c[0], beta[0], a),
                 scree_color_by_visibility(c[1], beta[1], a),
                 scree_color_by_visibility(c[2], beta[2], a));
}

// Color of what is both seen and lit. seen, lit: scree_table_color of view and light, wo and wi.
color scree_table_color_lit(color c, color seen, color lit, vector wo, vector wi)
{
    float together = scree_view_light_overlap(wo[0], wo[1], wi[0], wi[1]);
    return color(scree_color_seen_and_lit(c[0], seen[0], lit[0], together),
                 scree_color_seen_and_lit(c[1], seen[1], lit[1], together),
                 scree_color_seen_and_lit(c[2], seen[2], lit[2], together));
}

// Visible color of a set for a view w in its frame.
//
// color_model     0 mean color; 1 linear in height (colorheight); 2 by height rank (rank); 3 the
//                 color map the set was colored with (map); 4 visibility tables (visible); 5 linear
//                 in height with the measured exponent (colorheight, exponent)
// slope_color     1 adds the correlation with slope (colorslope); a color map by slope and
//                 visibility tables see the slope already and leave it out
// height_scale    scales slopes. Ranks of heights know no scale, a color map by height keeps the
//                 colors of the heights as baked, and tables the visibility as baked
// light_exponent  Lambda of the light, added to the view's, for what is both seen and lit; 0 else
// light           to the light, in the frame, for what is both seen and lit by visibility tables or
//                 with the measured exponent, which do not look at light_exponent; 0 else
color scree_visible_color(string folder, string name, float s, float t, float height_scale,
                          vector w, ScreeFootprint f, int color_model, int slope_color,
                          float light_exponent, vector light)
{
    float exponent = 0, g1 = 0, unused = 0;
    scree_masking(w[0], w[1], w[2], f.s, f.t, f.css, f.cst, f.ctt, f.tau, exponent, g1);
    exponent += light_exponent;
    string by = color_model == 3 ? scree_map_by(folder, name) : "";
    int add_slope = slope_color && color_model != 4 && (color_model != 3 || by == "height");
    color c = 0;
    if (color_model != 3 || add_slope)
        c = scree_lookup(scree_file(folder, name, "color"), s, t, 0, unused);
    color result = c;
    if (color_model == 1)
        result = scree_linear_color(folder, name, s, t, c, exponent);
    else if (color_model == 2)
        result = scree_rank_color(folder, name, s, t, c, exponent);
    else if (color_model == 3)
        result = scree_map_color(folder, name, s, t, w, f, exponent, by);
    else if (color_model == 4)
        result = scree_table_color(folder, name, s, t, w, c);
    else if (color_model == 5) {
        exponent = scree_exponent(folder, name, s, t, w, f);
        if (dot(light, light) > 0)
            exponent += scree_exponent(folder, name, s, t, light, f);
        result = scree_linear_color(folder, name, s, t, c, exponent);
    }
    if (color_model == 4 && dot(light, light) > 0)
        result = scree_table_color_lit(c, result, scree_table_color(folder, name, s, t, light, c),
                                       w, light);
    if (add_slope)
        result = max(color(0),
                     result - c + scree_slope_color(folder, name, s, t, height_scale, w, f, c));
    return result;
}

#endif
