// The example of docs/filtering.md.

#include <kernel/filter.h>
#include <kernel/visibility_table.h>

#include <cmath>

using Imath::V2f;
using Imath::V3f;
using namespace scree;

// One filtered lookup in each texture; directions in the tangent frame, y down the image.
V3f shade(const filter::SlopeMoments<float>& slope, float tau, const V3f& color, float h, float hh,
          const V3f& color_height, const V3f& to_viewer, const V3f& to_light, float base_alpha)
{
    const auto slopes = filter::slopes(slope, tau);
    const float exponent =
        filter::masking(to_viewer, slopes).lambda + filter::masking(to_light, slopes).lambda;
    const V3f visible =
        filter::color_by_height(color, color_height, h, hh, filter::visible_height(exponent));
    return visible * (filter::diffuse(to_viewer, to_light, slopes) / 3.14159265f) +
           V3f(0.04f) * filter::specular(to_viewer, to_light, slopes, base_alpha);
}

// The visible color of a set with a rank table: a[0] is (R1, G1, B1), and so on.
V3f visible_by_rank(const V3f& color, const V3f (&a)[4], float exponent)
{
    return filter::color_by_rank(color, a, 4, exponent);
}

// The visible color by height with the exponent that was measured of the asset: one filtered lookup
// in NAME.exponent.exr.
V3f visible_by_exponent(const filter::SlopeMoments<float>& slope, float tau, const V3f& color,
                        float h, float hh, const V3f& color_height,
                        const filter::Exponent<float>& exponent, const V3f& to_viewer,
                        const V3f& to_light)
{
    const float of_both = filter::measured_exponent(to_viewer, slope, tau, exponent) +
                          filter::measured_exponent(to_light, slope, tau, exponent);
    return filter::color_by_height(color, color_height, h, hh, filter::visible_height(of_both));
}

// Of a set with visibility tables, what is seen and lit: a table is one filtered lookup in all
// channels of NAME.visible.exr, and the nodes in its header.
V3f visible_by_tables(const V3f& color, const filter::VisibilityTable<float>& table,
                      const V3f& to_viewer, const V3f& to_light)
{
    const V3f seen = filter::visible_color(color, table, to_viewer);
    const V3f lit = filter::visible_color(color, table, to_light);
    return filter::color_seen_and_lit(color, seen, lit, to_viewer, to_light);
}

// Of a set with a color map by height: where NAME.map.exr is to be looked up, bilinear, clamped and
// without MIP levels. Size and ranges of the table are in its header.
V2f place_in_map(float h, float hh, const filter::ColorMapTable<float>& table, float exponent)
{
    const auto visible = filter::visible_height(exponent);
    const float sigma = filter::height_sigma(h, hh);
    return filter::color_map_coordinates(h + sigma * visible.mean,
                                         sigma * std::sqrt(visible.variance), table);
}
