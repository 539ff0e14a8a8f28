#include "judge/validation_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "judge/statistics_report.h"
#include "judge/view_report.h"
#include "report/page.h"

namespace scree {

namespace {

void add_verdict(const Validation& validation, const ValidationPlan& plan, report::Page& page)
{
    page.heading("Verdict");
    if (validation.exceeded.empty()) {
        page.paragraph(has_tolerance_of_views(plan.tolerances)
                           ? "Everything that has a tolerance is within it."
                           : "The statistics are what they should be. What views see was not "
                             "judged: no tolerance was given for it.");
    } else {
        page.paragraph("Out of tolerance:");
        page.list(validation.exceeded);
    }
    if (!validation.flags.empty()) {
        page.paragraph("What to know of this asset:");
        page.list(validation.flags);
    }
}

void add_views(const ViewCheck& check, const ViewPlan& plan, report::Page& page)
{
    page.heading("What views see");
    page.paragraph(fmt::format(
        "Up to {} footprints of each level, {} azimuths of each view angle and {} lights; the "
        "reference casts rays against the displaced surface of the inputs, {} samples a footprint. "
        "A footprint counts by the area of it that is seen. Color is relative to the rms visible "
        "color, radiance to the rms radiance, slopes to the map's rms slope ({:.3g}), their "
        "covariance to its square; masking is G1 itself. \"plain\" is an ordinary MIP chain: mean "
        "color, mean normal, nothing hidden. Facets reflect diffusely by their color, and {:g} of "
        "the light in a Beckmann lobe of roughness {:g}.",
        plan.footprints, plan.azimuths, plan.lights_deg.size(), plan.grid * plan.grid,
        check.rms_slope, plan.material.f0, plan.material.base_alpha));
    page.add(color_table(check));
    for (const report::Chart& chart : view_charts(check))
        page.add(chart);
    const report::Table models = model_table(check);
    if (!models.rows.empty())
        page.add(models);
    page.add(level_table(check, &ViewError::set));
    page.add(level_table(check, &ViewError::plain));
    page.add(slope_table(check));
    page.paragraph(fmt::format("{} samples, {} rays, in {:.1f} s: {:.2f} million samples a second.",
                               check.samples, check.rays, check.seconds,
                               static_cast<double>(check.samples) / check.seconds / 1e6));
}

void add_tables(const NodeCheck& check, const ViewPlan& plan, report::Page& page)
{
    page.heading("Tables of visibility");
    page.paragraph(fmt::format(
        "What NAME.visible.exr holds at its nodes, the means over the azimuth, against the same "
        "azimuths of the reference: up to {} footprints of each level, {} samples a footprint. "
        "Area is E[V W] / cos theta - 1, color E[c V W] / cos theta - E[c] over the rms of the "
        "map's mean color. \"noise\" is the reference's own.",
        std::min(plan.footprints, kMostNodeFootprints), plan.grid * plan.grid));
    page.add(node_table(check));
    page.paragraph(
        fmt::format("{} samples, {} rays, in {:.1f} s.", check.samples, check.rays, check.seconds));
}

void add_images(const TexelImages& images, report::Page& page)
{
    page.heading(fmt::format("Level {} seen at {:g} degrees", images.level, images.angle_deg));
    page.paragraph(
        "A pixel a texel, in the place it has in the texture; texels of which nothing is "
        "seen are gray in the reference.");
    page.add({{png_bytes(images.plain), "plain MIP"},
              {png_bytes(images.set), "set"},
              {png_bytes(images.truth), "reference"},
              {png_bytes(images.difference),
               fmt::format("difference of set and reference, {:g} times", kDifferenceGain)}});
}

} // namespace

std::string to_page(const Validation& validation, const ValidationPlan& plan,
                    const Manifest& manifest)
{
    report::Page page(fmt::format("Validation of {}", manifest.name));
    page.paragraph(fmt::format("{}x{} texels, {} levels, baked by Scree {}.", manifest.width,
                               manifest.height, manifest.levels.size(), manifest.program_version));
    add_verdict(validation, plan, page);
    page.heading("Statistics");
    page.paragraph("Every texel of every level against sums over the inputs themselves. Errors "
                   "are those of what a reader recovers, such as a covariance, over the largest of "
                   "its kind in the level or in the map.");
    page.add(statistics_table(validation.statistics));
    if (!validation.without_views.empty())
        page.paragraph("What views see was not compared: " + validation.without_views + ".");
    if (validation.views)
        add_views(*validation.views, plan.view, page);
    if (validation.tables)
        add_tables(*validation.tables, plan.view, page);
    for (const TexelImages& images : validation.images)
        add_images(images, page);
    return page.to_html();
}

} // namespace scree
