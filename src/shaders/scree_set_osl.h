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
    scree_covariance(f.s, f.t, scale2 * first[1], scale2 * first[2], scale2 * last[0], f.css, f.cst,
                     f.ctt);
    f.tau = 0;
    int has_tail = 0;
    string tail = scree_file(folder, name, "tail");
    if (gettextureinfo(tail, "exists", has_tail) && has_tail) {
        color tau = scree_lookup(tail, s, t, 0, unused);
        f.tau = tau[0];
    }
    return f;
}

// Visible color of a set for a view w in its frame.
//
// tier            0 mean color; 1 and its correlation with height; 2 and with slope
// light_exponent  Lambda of the light, added to the view's, for what is both seen and lit; 0 else
color scree_visible_color(string folder, string name, float s, float t, float height_scale,
                          vector w, ScreeFootprint f, int tier, float light_exponent)
{
    float unused = 0;
    color c = scree_lookup(scree_file(folder, name, "color"), s, t, 0, unused);
    color result = c;
    if (tier >= 1) {
        float lambda = 0, g1 = 0, mean = 0, variance = 0;
        scree_masking(w[0], w[1], w[2], f.s, f.t, f.css, f.cst, f.ctt, f.tau, lambda, g1);
        scree_visible_height(lambda + light_exponent, mean, variance);
        color h = scree_lookup(scree_file(folder, name, "height"), s, t, 0, unused);
        color ch = scree_lookup(scree_file(folder, name, "colorheight"), s, t, 0, unused);
        for (int i = 0; i < 3; ++i)
            result[i] = scree_color_by_height(c[i], ch[i], h[0], h[1], mean);
    }
    if (tier >= 2) {
        // Bs Bt Gs Gt Rs Rt
        float gt = 0;
        string file = scree_file(folder, name, "colorslope");
        color first = scree_lookup(file, s, t, 0, gt);
        color last = scree_lookup(file, s, t, 4, unused);
        color cs = height_scale * color(last[0], first[2], first[0]);
        color ct = height_scale * color(last[1], gt, first[1]);
        float pull = scree_slope_pull(w[0], w[1], w[2], f.s, f.t, f.css, f.cst, f.ctt, f.tau);
        for (int i = 0; i < 3; ++i)
            result[i] =
                max(0.0, result[i] - c[i] +
                             scree_color_by_slope(c[i], cs[i], ct[i], f.s, f.t, w[0], w[1], pull));
    }
    return result;
}

#endif
