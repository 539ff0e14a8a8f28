#include <fmt/format.h>

#include "chart/report.h"
#include "version.h"

namespace scree {

namespace {

std::vector<std::string> what_methods_are(const AssetChart& chart)
{
    std::vector<std::string> words;
    bool is_supersampling_told = false;
    for (const ChartRow& row : chart.rows) {
        const bool is_supersampling = row.family == MethodFamily::supersampling;
        if (!is_supersampling)
            words.push_back(fmt::format("{}: {}", row.name, row.what));
        else if (!is_supersampling_told)
            words.push_back(fmt::format("samples: {}", row.what));
        is_supersampling_told |= is_supersampling;
    }
    return words;
}

/// Where the bakes laid the nodes and axes of the tables of visibility.
std::string where_tables_lie(const AssetChart& chart)
{
    const auto nodes = [](const VisibilityRecord& record) {
        return fmt::format("{:g}", fmt::join(record.node_angles_deg, ", "));
    };
    return fmt::format("Tables of visibility of {}: at {} degrees from the normal; along axes at "
                       "{}, the first axis {:.3g} degrees from +s towards +t.",
                       chart.asset, nodes(chart.visibility), nodes(chart.visibility_axes),
                       chart.visibility_axes.axis_deg.value());
}

std::vector<std::string> how_it_was_measured(const std::vector<AssetChart>& charts,
                                             const ChartOptions& options)
{
    long long rays = 0;
    for (const AssetChart& chart : charts)
        rays += chart.rays;
    const std::string truth = fmt::format(
        "Truth: {0} x {0} jittered samples a footprint of the displaced, bilinear surface, with "
        "true masking and shadowing; {1:.3g} million rays. Its noise, half the difference of its "
        "two halves, is the last line of each table: it is part of every error.",
        options.grid, static_cast<double>(rays) / 1e6);
    const std::string footprints = fmt::format(
        "Footprints: of every level from 4 x 4 texels up {}, or as many as it has; the same for "
        "every method. Each is a texel of a set that scree bake made, with nothing blended between "
        "texels.",
        options.footprints);
    const std::string directions = "Views: two elevations and four azimuths in each band. Lights: "
                                   "one at a time, 20, 50 and 70 degrees from the normal.";
    const std::string material = fmt::format(
        "Material: color diffuse / pi + f0 specular, f0 {:g} at all angles, facets of Beckmann "
        "roughness {:g}. The microfacets of the methods' lobes mask each other, those of the "
        "reference's facets do not; scree chart plane shows what that makes, having no other "
        "error.",
        options.material.f0, options.material.base_alpha);
    const std::string error =
        "Error: root of the mean square over footprints, views, lights, R, G and B, over that of "
        "the truth. Footprints count by the area that is seen, as they do in a picture.";
    const std::string time = fmt::format(
        "Time: radiance of one footprint for one view and one light; {} footprints in memory, "
        "their lookups filtered already, one after the other; single precision, scalar, "
        "processor time of one thread; median of {} rounds in which the methods take turns, after "
        "a warm-up; bars hold the middle half of the rounds. Of supersampling: the reference "
        "renderer's time, rays "
        "included.",
        kCostTexels, options.rounds);
    const std::string bytes =
        "Bytes: of the channels that one lookup reads, in the pixel types that --pixel-type auto "
        "chose; normals as halves.";
    const std::string front =
        "Full markers: no other method is at least as good in both and better in one.";
    std::vector<std::string> all = {truth, footprints, directions, material,
                                    error, time,       bytes,      front};
    for (const AssetChart& chart : charts)
        all.push_back(where_tables_lie(chart));
    all.push_back(fmt::format("scree {}, {}.", kVersion, kCompiler));
    return all;
}

} // namespace

report::Page chart_page(const std::vector<AssetChart>& charts, const ChartOptions& options)
{
    report::Page page("Speed against accuracy");
    page.paragraph("Ways to shade a far, rough, colored surface: what one footprint costs, and how "
                   "far its radiance and its visible color are from a brute-force reference.");
    for (const AssetChart& chart : charts) {
        page.heading(fmt::format("{}: {} x {} texels, {} footprints", chart.asset, chart.width,
                                 chart.height, chart.footprints));
        page.add(chart_table(chart));
        for (const NamedChart& named : error_charts(chart))
            page.add(named.chart);
    }
    page.heading("The methods");
    page.list(what_methods_are(charts.front()));
    page.heading("How it was measured");
    page.list(how_it_was_measured(charts, options));
    return page;
}

} // namespace scree
